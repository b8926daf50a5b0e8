// The element beside its specification: for every state, instruction, digit and operand both write the same, and their
// next states agree.

module pixel_element_proof (
  input logic                         clk_i,
  input logic                         rst_ni,
  input logic                         execute_i,
  input pixelflow_pkg::instruction_t  instruction_i,
  input pixelflow_pkg::digit_t        digit_i,
  input pixelflow_pkg::byte_t         rdata_i,
  input pixelflow_pkg::byte_t         inbound_i,
  input pixelflow_pkg::byte_t         column_i,
  input pixelflow_pkg::byte_t         row_i
);

  logic memory_re, memory_we, outbound_we, spec_memory_re, spec_memory_we, spec_outbound_we;
  pixelflow_pkg::byte_t wdata, spec_wdata;
  logic [52:0] registers, expected, expected_q;
  logic known_q = 1'b0;   // the first cycle is over

  pixel_element element (
    .clk_i, .rst_ni, .execute_i, .instruction_i, .digit_i, .memory_re_o(memory_re), .rdata_i, .memory_we_o(memory_we),
    .wdata_o(wdata), .inbound_i, .outbound_we_o(outbound_we), .column_i, .row_i, .registers_o(registers)
  );

  pixel_element_spec #(.DigitBits(pixelflow_pkg::MultiplierBits), .DigitIndex(pixelflow_pkg::DigitWidth)) spec (
    .word(instruction_i), .digit(digit_i), .state(registers), .memory(rdata_i), .packet(inbound_i), .column(column_i),
    .row(row_i), .next(expected), .reads_memory(spec_memory_re), .writes_memory(spec_memory_we), .writes_packet(spec_outbound_we), .value(spec_wdata)
  );

  always_ff @(posedge clk_i) begin
    known_q    <= 1'b1;
    expected_q <= !rst_ni ? '0 : execute_i ? expected : registers;
  end

  always_comb begin
    // The memory gives the byte of the address only where it is asked for.
    assert (memory_re == spec_memory_re);
    assert (!memory_re || !memory_we);
    assert (memory_we == (execute_i && spec_memory_we));
    assert (outbound_we == (execute_i && spec_outbound_we));
    if (memory_we || outbound_we) assert (wdata == spec_wdata);
    if (!rst_ni) assert (registers == '0);
    else if (known_q) assert (registers == expected_q);
  end

endmodule
