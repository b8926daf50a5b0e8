// A multiplication digit after digit: with each digit W grows by the partial products of its bits, and the factors stay
// as they are, so that after the last one W has grown by the product; the top bit counts negative where the multiplier
// is signed. By the invariant of one digit, for every multiplier, multiplicand, W and pair of signs. PIXEL_SPEC_WRONG
// plants a mistake.

module pixel_multiply_proof (
  input logic                         clk_i,
  input pixelflow_pkg::byte_t         multiplicand_i,
  input pixelflow_pkg::byte_t         multiplier_i,
  input logic                         immediate_i,
  input logic                         signed_multiplier_i,
  input logic                         signed_multiplicand_i
);

  localparam int unsigned R      = pixelflow_pkg::MultiplierBits;
  localparam int unsigned Digits = pixelflow_pkg::Digits;

  // First X := multiplier, then a digit a cycle; what the instruction says is the same for all of them.
  logic [3:0] step_q = 4'd0;
  logic loads;
  logic [18:0] held_q;
  assign loads = (step_q == 4'd0);

  pixelflow_pkg::instruction_t instruction;
  pixelflow_pkg::digit_t digit;
  always_comb begin
    instruction = '0;
    if (loads) begin
      instruction.kind = pixelflow_pkg::KindAlu;
      instruction.q    = pixelflow_pkg::QPort;
      instruction.dest = pixelflow_pkg::ToX;
      instruction.imm  = pixelflow_pkg::PortColumn;
    end else begin
      instruction.kind  = pixelflow_pkg::KindWide;
      instruction.fn    = pixelflow_pkg::WideMultiply;
      instruction.p     = held_q[18] ? pixelflow_pkg::PImmediate : pixelflow_pkg::PX;
      instruction.set_c = held_q[17];
      instruction.set_s = held_q[16];
      instruction.imm   = held_q[15:8];
    end
    digit = pixelflow_pkg::DigitWidth'(step_q - 4'd1);
  end

  logic memory_re, memory_we, outbound_we;
  pixelflow_pkg::byte_t wdata;
  logic [52:0] registers;
  pixel_element element (
    .clk_i, .rst_ni(1'b1), .execute_i(32'(step_q) <= Digits), .instruction_i(instruction), .digit_i(digit),
    .memory_re_o(memory_re), .rdata_i(held_q[7:0]), .memory_we_o(memory_we), .wdata_o(wdata), .inbound_i('0),
    .outbound_we_o(outbound_we), .column_i(multiplier_i), .row_i('0), .registers_o(registers)
  );

  // W before, and a partial product for every bit of the multiplier: the product in its textbook form, a digit further
  // in each cycle.
  logic [31:0] grown_q, grown, grown_next, multiplicand;
  logic [7:0] multiplier;
  assign grown        = loads ? registers[31:0] : grown_q;
  assign multiplier   = held_q[15:8];
  assign multiplicand = {{24{held_q[16] && held_q[7]}}, held_q[7:0]};
  always_comb begin
    grown_next = grown;
    for (int b = 0; b < 8; b++) begin
      if (32'(step_q) == 1 + b / R && multiplier[b]) begin
`ifdef PIXEL_SPEC_WRONG
        if (b == 7) grown_next = grown_next - (multiplicand << b);
`else
        if (b == 7 && held_q[17]) grown_next = grown_next - (multiplicand << b);
`endif
        else grown_next = grown_next + (multiplicand << b);
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (loads) held_q <= {immediate_i, signed_multiplier_i, signed_multiplicand_i, multiplier_i, multiplicand_i};
    grown_q <= grown_next;
    if (32'(step_q) <= Digits) step_q <= step_q + 4'd1;
  end

  always_comb begin
    assert (32'(step_q) <= Digits + 1);
    assert (registers[31:0] == grown);
    if (!loads) assert (registers[39:32] == multiplier);
    assert (!memory_we && !outbound_we);
  end

endmodule
