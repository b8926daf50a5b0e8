// Registers are never gated: two elements whose states differ in E alone stay so under instructions that neither read E
// nor write it. And where E is clear, nothing outside the registers is written but with the gate that is always open.
// PIXEL_SPEC_WRONG plants a mistake.

module pixel_gating_proof (
  input logic                         clk_i,
  input logic                         execute_i,
  input pixelflow_pkg::instruction_t  instruction_i,
  input pixelflow_pkg::digit_t        digit_i,
  input pixelflow_pkg::byte_t         rdata_i,
  input pixelflow_pkg::byte_t         inbound_i,
  input pixelflow_pkg::byte_t         column_i,
  input pixelflow_pkg::byte_t         row_i
);

  logic [52:0] one, other;
  logic memory_re, memory_we, outbound_we, other_re, other_memory_we, other_outbound_we;
  pixelflow_pkg::byte_t wdata, other_wdata;

  pixel_element element (
    .clk_i, .rst_ni(1'b1), .execute_i, .instruction_i, .digit_i, .memory_re_o(memory_re), .rdata_i,
    .memory_we_o(memory_we),
    .wdata_o(wdata), .inbound_i, .outbound_we_o(outbound_we), .column_i, .row_i, .registers_o(one)
  );
  pixel_element twin (
    .clk_i, .rst_ni(1'b1), .execute_i, .instruction_i, .digit_i, .memory_re_o(other_re), .rdata_i,
    .memory_we_o(other_memory_we), .wdata_o(other_wdata), .inbound_i, .outbound_we_o(other_outbound_we),
    .column_i, .row_i,
    .registers_o(other)
  );

  logic known_q = 1'b0;   // the first cycle is over
  always_ff @(posedge clk_i) known_q <= 1'b1;

  logic reads_e, writes_e;
`ifdef PIXEL_SPEC_WRONG
  assign reads_e  = (instruction_i.q == pixelflow_pkg::QFlags);
`else
  assign reads_e  = (instruction_i.q == pixelflow_pkg::QFlags) ||
                    (instruction_i.kind == pixelflow_pkg::KindFlag && instruction_i.fn == pixelflow_pkg::BitE);
`endif
  assign writes_e = instruction_i.kind == pixelflow_pkg::KindFlag && instruction_i.dest == pixelflow_pkg::FlagE;

  always_comb begin
    assume (!reads_e && !writes_e);
    if (!known_q) assume (one[51:0] == other[51:0]);
    else assert (one[51:0] == other[51:0]);
    if (!one[52] && instruction_i.gate != pixelflow_pkg::GateNone) assert (!memory_we && !outbound_we);
  end

endmodule
