// The 16-bit addition as microcode does it, M := memory[a], M := M + memory[b] + carry, memory[d] := M for each byte,
// on every content of a memory of 8 bytes: the sum and its carry are right where E is set, no other byte changes, and
// nothing does where E is clear. PIXEL_SPEC_WRONG plants a mistake.

module pixel_add_proof (
  input logic         clk_i,
  input logic [63:0]  memory_i,   // the content at first
  input logic         enable_i    // and E
);

  localparam logic [2:0] A = 3'd0;
  localparam logic [2:0] B = 3'd2;
  localparam logic [2:0] D = 3'd5;

  logic [2:0] step_q = 3'd0;
  logic [63:0] memory_q, before_q, expected;

  pixelflow_pkg::instruction_t instruction;
  logic [2:0] address;
  logic upper;
  always_comb begin
    upper             = (step_q >= 3'd4);
    instruction       = '0;
    instruction.kind  = pixelflow_pkg::KindAlu;
    instruction.fn    = pixelflow_pkg::AluAdd;
    instruction.p     = pixelflow_pkg::PM;
    instruction.dest  = pixelflow_pkg::ToM;
    case (step_q)
      3'd0: begin   // E := bit 0 of the column, which stands for any E
        instruction.kind = pixelflow_pkg::KindFlag;
        instruction.fn   = pixelflow_pkg::BitOfQ;
        instruction.q    = pixelflow_pkg::QPort;
        instruction.dest = pixelflow_pkg::FlagE;
        instruction.imm  = pixelflow_pkg::PortColumn;
        address          = '0;
      end
      3'd1, 3'd4: begin
        instruction.p = pixelflow_pkg::PZero;
        address       = A;
      end
      3'd2, 3'd5: begin
        instruction.set_c = 1'b1;
        instruction.cin   = upper ? pixelflow_pkg::CarryC : pixelflow_pkg::CarryZero;
        address           = B;
      end
      default: begin
        instruction.q    = pixelflow_pkg::QImmediate;
        instruction.dest = pixelflow_pkg::ToMemory;
        address          = D;
      end
    endcase
    address          = address + {2'd0, upper};
    instruction.addr = {5'd0, address};
  end

  logic memory_re, memory_we, outbound_we;
  pixelflow_pkg::byte_t rdata, wdata;
  logic [52:0] registers;
  pixel_element element (
    .clk_i, .rst_ni(1'b1), .execute_i(step_q < 3'd7), .instruction_i(instruction), .digit_i('0),
    .memory_re_o(memory_re), .rdata_i(rdata), .memory_we_o(memory_we), .wdata_o(wdata),
    .inbound_i('0), .outbound_we_o(outbound_we), .column_i({7'd0, enable_i}),
    .row_i('0), .registers_o(registers)
  );

  assign rdata = memory_q >> {address, 3'd0};
  always_ff @(posedge clk_i) begin
    if (step_q == 3'd0) begin
      memory_q <= memory_i;
      before_q <= memory_i;
    end else if (memory_we) begin
      memory_q <= (memory_q & ~(64'hFF << {address, 3'd0})) | ({56'd0, wdata} << {address, 3'd0});
    end
    if (step_q < 3'd7) step_q <= step_q + 3'd1;
  end

  logic [16:0] sum;
  logic [15:0] left, right;
  logic enabled;
  assign enabled  = registers[52];
  assign left     = before_q >> {A, 3'd0};
  assign right    = before_q >> {B, 3'd0};
  assign sum      = {1'b0, left} + {1'b0, right};
  assign expected = enabled ? (before_q & ~(64'hFFFF << {D, 3'd0})) | ({48'd0, sum[15:0]} << {D, 3'd0}) : before_q;

  always_comb begin
    if (step_q == 3'd7) begin
      assert (memory_q == expected);
`ifdef PIXEL_SPEC_WRONG
      assert (registers[48] == sum[15]);
`else
      assert (registers[48] == sum[16]);
`endif
    end
  end

endmodule
