// The row form with one lane, two bytes of memory and packets of two bytes, beside the element's module: from equal
// states every instruction and digit leads to equal states, and both write the same bytes. PIXEL_SPEC_WRONG plants a
// mistake.

module pixel_row_proof (
  input logic                         clk_i,
  input logic                         execute_i,
  input pixelflow_pkg::instruction_t  instruction_i,
  input pixelflow_pkg::digit_t        digit_i,
  input logic [15:0]                  inbound_i,
  input logic                         inbound_we_i
);

  logic [52:0] row_registers, registers;
  logic [63:0] row_bytes, bytes_q;   // inbound packet, row, column, outbound packet, memory
  logic [15:0] unused_packet;
  pixelflow_pkg::byte_t rdata, inbound, wdata;
  logic memory_re, memory_we, outbound_we;
  logic known_q = 1'b0;   // the first cycle is over: all is loaded

  pixelflow_pkg::instruction_t instruction;
  logic [7:0] addr, imm;
  assign instruction = instruction_i;
  assign addr        = instruction.addr;
  assign imm         = instruction.imm;

  pixel_row elements (
    .clk_i, .rst_ni(1'b1), .execute_i(execute_i && known_q), .instruction_i, .digit_i,
    .place_all_i(!known_q), .chip_i(8'd5), .place_i(1'b0), .place_lane_i('0), .place_column_i('0), .place_row_i('0),
    .inbound_we_i(inbound_we_i || !known_q), .inbound_lane_i('0), .inbound_packet_i(inbound_i),
    .outbound_re_i(1'b0), .outbound_lane_i('0), .outbound_packet_o(unused_packet),
    .registers_o(row_registers), .bytes_o(row_bytes)
  );

  assign rdata   = (addr == 8'd0) ? bytes_q[7:0] : (addr == 8'd1) ? bytes_q[15:8] : 8'd0;
  assign inbound = imm[0] ? bytes_q[63:56] : bytes_q[55:48];
  pixel_element element (
    .clk_i, .rst_ni(1'b1), .execute_i(execute_i && known_q), .instruction_i, .digit_i, .memory_re_o(memory_re),
    .rdata_i(rdata),
    .memory_we_o(memory_we), .wdata_o(wdata), .inbound_i(inbound), .outbound_we_o(outbound_we),
`ifdef PIXEL_SPEC_WRONG
    .column_i(bytes_q[47:40]), .row_i(bytes_q[39:32]),
`else
    .column_i(bytes_q[39:32]), .row_i(bytes_q[47:40]),
`endif
    .registers_o(registers)
  );

  always_ff @(posedge clk_i) begin
    known_q <= 1'b1;
    if (!known_q) begin
      bytes_q <= {inbound_i, 16'h0005, row_bytes[31:0]};   // the fifth chip of one element stands in column 5
    end else begin
      if (inbound_we_i) bytes_q[63:48] <= inbound_i;
      if (memory_we && addr == 8'd0) bytes_q[7:0] <= wdata;
      if (memory_we && addr == 8'd1) bytes_q[15:8] <= wdata;
      if (outbound_we && addr == 8'd0) bytes_q[23:16] <= wdata;
      if (outbound_we && addr == 8'd1) bytes_q[31:24] <= wdata;
    end
  end

  always_comb begin
    if (!known_q) begin
      assume (row_registers == registers);
    end else begin
      assert (row_registers == registers);
      assert (row_bytes == bytes_q);
    end
  end

endmodule
