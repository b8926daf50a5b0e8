// One processing element (Olano and Lastra 1998, section 5.1: an 8-bit ALU that supports integer multiplication, an
// enable flag): its registers and its logic; memory and packets lie outside. docs/pixel_processor.md describes each
// code. An instruction takes one cycle, a multiplication one for each digit that the sequencer gives. The memory
// operand comes in the same cycle, and an instruction that writes does not read. Refuses nothing: unused codes do
// nothing.

module pixel_element (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from the instruction sequencer
  input  logic                         execute_i,
  input  pixelflow_pkg::instruction_t  instruction_i,
  input  pixelflow_pkg::digit_t        digit_i,        // of the multiplier
  // to and from the memory, at the instruction's address
  output logic                         memory_re_o,
  input  pixelflow_pkg::byte_t         rdata_i,
  output logic                         memory_we_o,
  output pixelflow_pkg::byte_t         wdata_o,
  // to and from the communication buffers
  input  pixelflow_pkg::byte_t         inbound_i,      // byte imm of the packet that has arrived, 0 beyond it
  output logic                         outbound_we_o,  // wdata_o is byte addr of the packet to be sent
  // place in the region
  input  pixelflow_pkg::byte_t         column_i,
  input  pixelflow_pkg::byte_t         row_i,
  // trace
  output pixelflow_pkg::registers_t    registers_o
);

  localparam int unsigned R = pixelflow_pkg::MultiplierBits;
  localparam pixelflow_pkg::digit_t LastDigit = pixelflow_pkg::DigitWidth'(pixelflow_pkg::Digits - 1);

  logic e_q, k_q, s_q, z_q, c_q, e_d, k_d, s_d, z_d, c_d;
  pixelflow_pkg::byte_t m_q, x_q, m_d, x_d;
  pixelflow_pkg::wide_t w_q, w_d;

  logic [3:0] fn;
  logic [2:0] bit_number;
  logic is_alu, is_wide, is_flag, is_multiply;
  assign fn          = instruction_i.fn;
  assign bit_number  = instruction_i.imm[2:0];
  assign is_alu      = (instruction_i.kind == pixelflow_pkg::KindAlu);
  assign is_wide     = (instruction_i.kind == pixelflow_pkg::KindWide);
  assign is_flag     = (instruction_i.kind == pixelflow_pkg::KindFlag);
  assign is_multiply = is_wide && (fn == pixelflow_pkg::WideMultiply);

  // Operands.
  logic to_memory, to_outbound;
  assign to_memory   = is_alu && (instruction_i.dest == pixelflow_pkg::ToMemory);
  assign to_outbound = is_alu && (instruction_i.dest == pixelflow_pkg::ToPort) &&
                       (32'(instruction_i.addr) < pixelflow_pkg::PacketBytes);

  logic names_memory;
  assign names_memory = (instruction_i.q == pixelflow_pkg::QMemory) || (instruction_i.q == pixelflow_pkg::QMemoryOrM);
  assign memory_re_o  = names_memory && ((is_alu && !to_memory) || is_multiply || is_flag);

  pixelflow_pkg::byte_t memory, w_byte, port, p, q;
  assign memory = memory_re_o ? rdata_i : '0;
  assign w_byte = w_q[{instruction_i.at, 3'd0} +: 8];

  always_comb begin
    port = '0;
    if (32'(instruction_i.imm) < pixelflow_pkg::PacketBytes) port = inbound_i;
    else if (instruction_i.imm == pixelflow_pkg::PortColumn) port = column_i;
    else if (instruction_i.imm == pixelflow_pkg::PortRow) port = row_i;
  end

  always_comb begin
    case (instruction_i.p)
      pixelflow_pkg::PM:         p = m_q;
      pixelflow_pkg::PX:         p = x_q;
      pixelflow_pkg::PW:         p = w_byte;
      pixelflow_pkg::PImmediate: p = instruction_i.imm;
      default:                   p = '0;
    endcase
    case (instruction_i.q)
      pixelflow_pkg::QMemory:       q = memory;
      pixelflow_pkg::QImmediate:    q = instruction_i.imm;
      pixelflow_pkg::QM:            q = m_q;
      pixelflow_pkg::QMemoryOrM:    q = k_q ? m_q : memory;
      pixelflow_pkg::QExponentLow:  q = {x_q[0], 7'd0};
      pixelflow_pkg::QExponentHigh: q = {s_q, x_q[7:1]};
      pixelflow_pkg::QPort:         q = port;
      default:                      q = {3'd0, e_q, k_q, s_q, z_q, c_q};
    endcase
  end

  // ALU: one adder, whose operands are inverted or cleared before it.
  logic cin, carry, sign, adds;
  pixelflow_pkg::byte_t left, right, result;
  logic [8:0] sum;
  always_comb begin
    case (instruction_i.cin)
      pixelflow_pkg::CarryOne: cin = 1'b1;
      pixelflow_pkg::CarryC:   cin = c_q;
      pixelflow_pkg::CarryK:   cin = k_q;
      default:                 cin = 1'b0;
    endcase
    left  = p;
    right = q;
    adds  = 1'b1;
    case (fn)
      pixelflow_pkg::AluAdd:        ;
      pixelflow_pkg::AluSub:        right = ~q;
      pixelflow_pkg::AluReverseSub: left  = ~p;
      pixelflow_pkg::AluAddSub:     right = q ^ {8{k_q}};
      pixelflow_pkg::AluAddIf:      right = q & {8{k_q}};
      pixelflow_pkg::AluNegateIf:   left  = p ^ {8{k_q}};
      default:                      adds  = 1'b0;
    endcase
  end
  assign sum = {1'b0, left} + {1'b0, right} + {8'd0, cin};

  always_comb begin
    result = '0;
    carry  = 1'b0;
    if (adds) begin
      result = sum[7:0];
      carry  = sum[8];
    end else begin
      case (fn)
        pixelflow_pkg::AluAnd:        result = p & q;
        pixelflow_pkg::AluOr:         result = p | q;
        pixelflow_pkg::AluXor:        result = p ^ q;
        pixelflow_pkg::AluAndNot:     result = p & ~q;
        pixelflow_pkg::AluSelect:     result = k_q ? p : q;
        pixelflow_pkg::AluShiftLeft:  {carry, result} = {q, cin};
        pixelflow_pkg::AluShiftRight: {result, carry} = {cin, q};
        default:                      ;
      endcase
    end
    // Of a sum with one bit more, so that it is right where eight bits overflow.
    sign = adds ? left[7] ^ right[7] ^ carry : result[7];
  end

  // Writes outside the registers; only these are gated.
  logic gated;
  always_comb begin
    case (instruction_i.gate)
      pixelflow_pkg::GateE:     gated = e_q;
      pixelflow_pkg::GateEK:    gated = e_q && k_q;
      pixelflow_pkg::GateEnotK: gated = e_q && !k_q;
      default:                  gated = 1'b1;
    endcase
  end
  assign memory_we_o   = execute_i && to_memory && gated;
  assign outbound_we_o = execute_i && to_outbound && gated;
  assign wdata_o       = result;

  // A digit of the multiplier times the multiplicand; the last digit of a signed multiplier counts negative.
  pixelflow_pkg::byte_t multiplier;
  logic [R-1:0] magnitude;
  logic signed [R:0] digit;
  logic signed [8:0] multiplicand;
  logic signed [R+9:0] product;
  logic [4:0] weight;
  pixelflow_pkg::wide_t addend;
  assign multiplier   = (instruction_i.p == pixelflow_pkg::PImmediate) ? instruction_i.imm : x_q;
  assign weight       = 5'(32'(digit_i) * R);
  assign magnitude    = R'(multiplier >> weight);
  assign digit        = {instruction_i.set_c && (digit_i == LastDigit) && magnitude[R-1], magnitude};
  assign multiplicand = {instruction_i.set_s && q[7], q};
  assign product      = digit * multiplicand;
  assign addend       = {{(22-R){product[R+9]}}, product} << weight;

  // Shifts of W.
  logic top_zero, happens, fill;
  logic [3:0] distance;
  pixelflow_pkg::wide_t right_shifted, left_shifted;
  always_comb begin
    case (instruction_i.at)
      2'd0: begin
        distance      = 4'd1;
        top_zero      = !w_q[31];
        right_shifted = {fill, w_q[31:1]};
        if (instruction_i.cin == pixelflow_pkg::FillJam) right_shifted[0] = w_q[1] || w_q[0];
        left_shifted  = {w_q[30:0], 1'd0};
      end
      2'd1: begin
        distance      = 4'd2;
        top_zero      = (w_q[31:30] == '0);
        right_shifted = {{2{fill}}, w_q[31:2]};
        if (instruction_i.cin == pixelflow_pkg::FillJam) right_shifted[0] = (w_q[2:0] != '0);
        left_shifted  = {w_q[29:0], 2'd0};
      end
      2'd2: begin
        distance      = 4'd4;
        top_zero      = (w_q[31:28] == '0);
        right_shifted = {{4{fill}}, w_q[31:4]};
        if (instruction_i.cin == pixelflow_pkg::FillJam) right_shifted[0] = (w_q[4:0] != '0);
        left_shifted  = {w_q[27:0], 4'd0};
      end
      default: begin
        distance      = 4'd8;
        top_zero      = (w_q[31:24] == '0);
        right_shifted = {{8{fill}}, w_q[31:8]};
        if (instruction_i.cin == pixelflow_pkg::FillJam) right_shifted[0] = (w_q[8:0] != '0);
        left_shifted  = {w_q[23:0], 8'd0};
      end
    endcase
  end
  always_comb begin
    case (instruction_i.cin)
      pixelflow_pkg::FillSign: fill = w_q[31];
      pixelflow_pkg::FillC:    fill = c_q;
      default:                 fill = 1'b0;
    endcase
    case (instruction_i.p)
      pixelflow_pkg::WhenAlways:    happens = 1'b1;
      pixelflow_pkg::WhenK:         happens = k_q;
      pixelflow_pkg::WhenXBit:      happens = x_q[bit_number];
      pixelflow_pkg::WhenNormalize: happens = top_zero && (x_q > {4'd0, distance});
      default:                      happens = 1'b0;
    endcase
  end

  // One bit of a non-restoring division: the remainder is not negative where its sign, the first operation's kind and
  // the carry agree.
  logic quotient;
  assign quotient = !(s_q ^ k_q ^ c_q);

  // Source of a flag instruction.
  logic source;
  always_comb begin
    case (fn)
      pixelflow_pkg::BitOne:      source = 1'b1;
      pixelflow_pkg::BitC:        source = c_q;
      pixelflow_pkg::BitZ:        source = z_q;
      pixelflow_pkg::BitS:        source = s_q;
      pixelflow_pkg::BitK:        source = k_q;
      pixelflow_pkg::BitE:        source = e_q;
      pixelflow_pkg::BitOfP:      source = p[bit_number];
      pixelflow_pkg::BitOfQ:      source = q[bit_number];
      pixelflow_pkg::BitWideZero: source = (w_q == '0);
      default:                    source = 1'b0;
    endcase
    source = source ^ instruction_i.set_c;
  end

  logic old_flag, new_flag;
  always_comb begin
    case (instruction_i.dest)
      pixelflow_pkg::FlagC: old_flag = c_q;
      pixelflow_pkg::FlagZ: old_flag = z_q;
      pixelflow_pkg::FlagS: old_flag = s_q;
      pixelflow_pkg::FlagK: old_flag = k_q;
      default:              old_flag = e_q;
    endcase
    case (instruction_i.cin)
      pixelflow_pkg::FlagAnd: new_flag = old_flag && source;
      pixelflow_pkg::FlagOr:  new_flag = old_flag || source;
      pixelflow_pkg::FlagXor: new_flag = old_flag ^ source;
      default:                new_flag = source;
    endcase
  end

  always_comb begin
    {e_d, k_d, s_d, z_d, c_d} = {e_q, k_q, s_q, z_q, c_q};
    m_d = m_q;
    x_d = x_q;
    w_d = w_q;
    if (is_alu) begin
      if (instruction_i.down) w_d = {{8{w_q[31]}}, w_q[31:8]};
      case (instruction_i.dest)
        pixelflow_pkg::ToM: m_d = result;
        pixelflow_pkg::ToX: x_d = result;
        pixelflow_pkg::ToW: w_d[{instruction_i.at, 3'd0} +: 8] = result;
        default:            ;
      endcase
      if (instruction_i.set_c) c_d = carry;
      if (instruction_i.z == pixelflow_pkg::ZSet) z_d = (result == '0);
      if (instruction_i.z == pixelflow_pkg::ZAnd) z_d = z_q && (result == '0);
      if (instruction_i.set_s) s_d = sign;
    end
    if (is_wide) begin
      case (fn)
        pixelflow_pkg::WideClear:      w_d = '0;
        pixelflow_pkg::WideMultiply:   w_d = w_q + addend;
        pixelflow_pkg::WideShiftRight: if (happens) w_d = right_shifted;
        pixelflow_pkg::WideShiftLeft: begin
          if (happens) begin
            w_d = left_shifted;
            if (instruction_i.p == pixelflow_pkg::WhenNormalize) x_d = x_q - {4'd0, distance};
          end
        end
        pixelflow_pkg::WideDivide: begin
          if (instruction_i.set_c || instruction_i.set_s) x_d = {x_q[6:0], instruction_i.set_c && quotient};
          if (instruction_i.set_c) k_d = quotient;
          if (instruction_i.set_s) begin
            s_d = w_byte[7];
            w_d = {w_q[30:0], x_q[7]};
          end
        end
        default: ;
      endcase
    end
    if (is_flag) begin
      case (instruction_i.dest)
        pixelflow_pkg::FlagC: c_d = new_flag;
        pixelflow_pkg::FlagZ: z_d = new_flag;
        pixelflow_pkg::FlagS: s_d = new_flag;
        pixelflow_pkg::FlagK: k_d = new_flag;
        pixelflow_pkg::FlagE: e_d = new_flag;
        default:              ;
      endcase
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {e_q, k_q, s_q, z_q, c_q} <= '0;
      m_q <= '0;
      x_q <= '0;
      w_q <= '0;
    end else if (execute_i) begin
      {e_q, k_q, s_q, z_q, c_q} <= {e_d, k_d, s_d, z_d, c_d};
      m_q <= m_d;
      x_q <= x_d;
      w_q <= w_d;
    end
  end

  assign registers_o = {e_q, k_q, s_q, z_q, c_q, m_q, x_q, w_q};

`ifdef FORMAL
  // One memory port, and enable.
  always_comb begin
    assert (!(memory_re_o && memory_we_o));
    if (!e_q && instruction_i.gate != pixelflow_pkg::GateNone) assert (!memory_we_o && !outbound_we_o);
  end
`endif

endmodule
