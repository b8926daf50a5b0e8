// What one instruction does to one element, written from docs/pixel_processor.md alone for the proofs: a table of bit
// vectors, with the word cut by position and the arithmetic in its textbook form. PIXEL_SPEC_WRONG plants one mistake,
// so that the tests can show that the proof would find it.

module pixel_element_spec #(
  parameter DigitBits  = 2,    // multiplier bits a cycle
  parameter DigitIndex = 2     // bits of a digit's number
) (
  input  [41:0]           word,
  input  [DigitIndex-1:0] digit,
  input  [52:0]           state,        // E K S Z C, M, X, W
  input  [7:0]            memory,       // memory[addr]
  input  [7:0]            packet,       // inbound packet's byte imm
  input  [7:0]            column,
  input  [7:0]            row,
  output [52:0]           next,
  output                  reads_memory,
  output                  writes_memory,
  output                  writes_packet,
  output [7:0]            value
);

  // The word.
  wire [1:0] kind  = word[41:40];
  wire [3:0] fn    = word[39:36];
  wire [2:0] p     = word[35:33];
  wire [2:0] q     = word[32:30];
  wire [1:0] cin   = word[29:28];
  wire [2:0] dest  = word[27:25];
  wire [1:0] gate  = word[24:23];
  wire       set_c = word[22];
  wire [1:0] zmode = word[21:20];
  wire       set_s = word[19];
  wire [1:0] at    = word[18:17];
  wire       down  = word[16];
  wire [7:0] addr  = word[15:8];
  wire [7:0] imm   = word[7:0];

  // The state.
  wire        e = state[52], k = state[51], s = state[50], z = state[49], c = state[48];
  wire [7:0]  m = state[47:40];
  wire [7:0]  x = state[39:32];
  wire [31:0] w = state[31:0];

  wire alu = kind == 0, wide = kind == 1, flag = kind == 2;
  wire to_memory = alu & dest == 4;

  // Operands. Who writes memory does not read it; of the wide instructions only a multiplication has an operand.
  assign reads_memory = (q == 0 | q == 3) & (alu & dest != 4 | wide & fn == 1 | flag);
  wire [7:0] read    = to_memory ? 8'd0 : memory;
  wire [7:0] w_of_at = at == 0 ? w[7:0] : at == 1 ? w[15:8] : at == 2 ? w[23:16] : w[31:24];
  wire [7:0] port    = imm <= 31 ? packet : imm == 128 ? column : imm == 129 ? row : 8'd0;
  wire [63:0] p_table = {24'd0, imm, w_of_at, x, m, 8'd0};
  wire [63:0] q_table = {3'd0, e, k, s, z, c, port, s, x[7:1], x[0], 7'd0, k ? m : read, m, imm, read};
  wire [7:0] vp = p_table >> {p, 3'd0};
  wire [7:0] vq = q_table >> {q, 3'd0};

  // ALU: a sum unsigned, for its carry, and the same sum of signed numbers with one bit more, for its sign.
  wire ci = cin == 1 | cin == 2 & c | cin == 3 & k;
  wire [7:0] a = fn == 2 ? 8'd255 - vp : fn == 5 & k ? 8'd255 - vp : vp;
  wire [7:0] b = fn == 1 ? 8'd255 - vq : fn == 3 & k ? 8'd255 - vq : fn == 4 & !k ? 8'd0 : vq;
  wire [8:0] unsigned_sum = {1'b0, a} + {1'b0, b} + ci;
  wire [8:0] signed_sum   = {a[7], a} + {b[7], b} + ci;
  wire sums = fn <= 5;
  wire [7:0] r = sums ? unsigned_sum[7:0]
               : fn == 6 ? vp & vq : fn == 7 ? vp | vq : fn == 8 ? (vp | vq) & ~(vp & vq) : fn == 9 ? vp & ~vq
               : fn == 10 ? (k ? vp : vq) : fn == 11 ? vq * 2 + ci : fn == 12 ? vq / 2 + 128 * ci : 8'd0;
  wire carry = sums ? unsigned_sum[8] : fn == 11 ? vq >= 128 : fn == 12 ? vq[0] : 1'b0;
`ifdef PIXEL_SPEC_WRONG
  wire sign  = r[7];
`else
  wire sign  = sums ? signed_sum[8] : r[7];
`endif

  wire [3:0] gates = {1'b1, e & !k, e & k, e};
  wire open = gates[gate];
  assign writes_memory = to_memory & open;
  assign writes_packet = alu & dest == 5 & addr < 32 & open;
  assign value = r;

  wire [31:0] w_down = down ? {{8{w[31]}}, w[31:8]} : w;
  wire [31:0] byte_mask = 32'd255 << (8 * at);
  wire [31:0] alu_w = dest == 3 ? w_down & ~byte_mask | {4{r}} & byte_mask : w_down;

  // Multiplication: the bits of the digit, each with its weight; of a signed multiplier the top bit's weight is -128.
  wire [7:0]  multiplier   = p == 4 ? imm : x;
  wire [31:0] multiplicand = {{24{set_s & vq[7]}}, vq};
  reg  [31:0] multiplied;
  integer n;
  always @* begin
    multiplied = w;
    for (n = 0; n < 8; n = n + 1) begin
      if (n / DigitBits == digit && multiplier[n]) begin
        if (n == 7 && set_c) multiplied = multiplied - (multiplicand << n);
        else multiplied = multiplied + (multiplicand << n);
      end
    end
  end

  // Shifts.
  wire [3:0] distance = 4'd1 << at;
  wire [7:0] high = at == 0 ? w[31] : at == 1 ? w[31:30] : at == 2 ? w[31:28] : w[31:24];
  wire [7:0] lost = at == 0 ? w[0] : at == 1 ? w[1:0] : at == 2 ? w[3:0] : w[7:0];
  wire normal  = high == 0 & x > distance;
  wire shifts  = p == 0 | p == 1 & k | p == 2 & x[imm[2:0]] | p == 3 & normal;
  wire come_in = cin == 1 & w[31] | cin == 2 & c;
  wire [63:0] long = {{32{come_in}}, w} >> distance;
  wire [31:0] right_w = {long[31:1], long[0] | cin == 3 & lost != 0};
  wire [31:0] left_w  = w << distance;

  // Division.
  wire quotient = ~(s + k + c);

  wire [31:0] wide_w = fn == 0 ? 32'd0 : fn == 1 ? multiplied : fn == 2 & shifts ? right_w : fn == 3 & shifts ? left_w
                     : fn == 4 & set_s ? {w[30:0], x[7]} : w;
  wire [7:0] wide_x = fn == 3 & p == 3 & normal ? x - distance
                    : fn == 4 & (set_c | set_s) ? {x[6:0], set_c & quotient} : x;
  wire wide_k = fn == 4 & set_c ? quotient : k;
  wire wide_s = fn == 4 & set_s ? w_of_at[7] : s;

  // Flags.
  wire [15:0] sources = {7'd0, w == 0, vq[imm[2:0]], vp[imm[2:0]], e, k, s, z, c, 1'b1};
  wire source = sources[fn] ^ set_c;
  wire [7:0] flags = {3'd0, e, k, s, z, c};
  wire [3:0] combined = {flags[dest] ^ source, flags[dest] | source, flags[dest] & source, source};
  wire [7:0] one_hot = 8'd1 << dest;
  wire [7:0] new_flags = flags & ~one_hot | {8{combined[cin]}} & one_hot;

  wire zero = r == 0;
  wire alu_z = zmode == 1 ? zero : zmode == 2 ? z & zero : z;
  assign next = alu  ? {e, k, set_s ? sign : s, alu_z, set_c ? carry : c, dest == 1 ? r : m, dest == 2 ? r : x, alu_w}
              : wide ? {e, wide_k, wide_s, z, c, m, wide_x, wide_w}
              : flag ? {new_flags[4:0], m, x, w}
              : state;

endmodule
