// One element with its memory: the form for proofs and synthesis. pixel_row is the same for all elements of a chip.
// Latency: one cycle an instruction, for a multiplication one a digit. Refuses nothing.

module pixel_processor (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from the instruction sequencer
  input  logic                         execute_i,
  input  pixelflow_pkg::instruction_t  instruction_i,
  input  pixelflow_pkg::digit_t        digit_i,
  // to and from the communication buffers
  input  pixelflow_pkg::byte_t         inbound_i,
  output logic                         outbound_we_o,
  output pixelflow_pkg::byte_t         wdata_o,
  // place in the region
  input  pixelflow_pkg::byte_t         column_i,
  input  pixelflow_pkg::byte_t         row_i,
  // trace
  output logic                         memory_we_o,
  output pixelflow_pkg::registers_t    registers_o
);

  logic memory_re;
  pixelflow_pkg::byte_t rdata;

  pixel_element element (
    .clk_i, .rst_ni, .execute_i, .instruction_i, .digit_i,
    .memory_re_o(memory_re), .rdata_i(rdata), .memory_we_o, .wdata_o,
    .inbound_i, .outbound_we_o, .column_i, .row_i, .registers_o
  );

  pixel_memory memory (
    .clk_i, .addr_i(instruction_i.addr), .re_i(memory_re), .rdata_o(rdata), .we_i(memory_we_o), .wdata_i(wdata_o)
  );

endmodule
