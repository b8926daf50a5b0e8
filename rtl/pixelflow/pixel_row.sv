// The elements of a chip in row form: what pixel_element, its memory and its packets do, for all lanes at once, which a
// C++ compiler makes vector code of. Every array has a row of all lanes, state changes in place, and the choices by the
// instruction stand outside the loops over the lanes. Tests and a proof tie a lane to pixel_processor. Latency: one
// cycle an instruction, for a multiplication one a digit; a packet to be sent comes one cycle after it is asked for.
// Refuses nothing.

module pixel_row (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // from the instruction sequencer
  input  logic                         execute_i,
  input  pixelflow_pkg::instruction_t  instruction_i,
  input  pixelflow_pkg::digit_t        digit_i,
  // places in the region: all lanes from the chip's number, or one lane
  input  logic                         place_all_i,
  input  logic [7:0]                   chip_i,
  input  logic                         place_i,
  input  pixelflow_pkg::lane_t         place_lane_i,
  input  pixelflow_pkg::byte_t         place_column_i,
  input  pixelflow_pkg::byte_t         place_row_i,
  // to and from the communication buffer
  input  logic                         inbound_we_i,
  input  pixelflow_pkg::lane_t         inbound_lane_i,
  input  pixelflow_pkg::packet_t       inbound_packet_i,
  input  logic                         outbound_re_i,
  input  pixelflow_pkg::lane_t         outbound_lane_i,
  output pixelflow_pkg::packet_t       outbound_packet_o
`ifdef FORMAL
  // the first lane's state and its first bytes, for the proof
  , output pixelflow_pkg::registers_t  registers_o
  , output logic [63:0]                bytes_o
`endif
);

  localparam int unsigned N           = pixelflow_pkg::Elements;
  localparam int unsigned R           = pixelflow_pkg::MultiplierBits;
  localparam int unsigned Bytes       = pixelflow_pkg::MemoryBytes;
  localparam int unsigned PacketBytes = pixelflow_pkg::PacketBytes;

  localparam logic [8:0] LastAddress = 9'(Bytes - 1);

  logic [7:0]  memory_q [Bytes][N];
  logic [7:0]  inbound_q [PacketBytes][N], outbound_q [PacketBytes][N];
  logic [7:0]  column_q [N], row_q [N];
  logic [31:0] w_q [N];
  logic [7:0]  m_q [N], x_q [N];
  logic        e_q [N], k_q [N], s_q [N], z_q [N], c_q [N];
  logic [8*PacketBytes-1:0] outbound_packet_q;

  // Rows between the loops of one instruction; none keeps a value from one cycle to the next.
  logic [7:0] p [N], q [N], result [N];
  logic       carry [N], sign [N], bits [N];

  logic [1:0] kind, cin, gate, z, at;
  logic [2:0] p_code, q_code, dest, bit_number;
  logic [3:0] fn;
  logic [7:0] addr, imm;
  logic       set_c, set_s, down, names_memory;
  assign kind         = instruction_i.kind;
  assign fn           = instruction_i.fn;
  assign p_code       = instruction_i.p;
  assign q_code       = instruction_i.q;
  assign cin          = instruction_i.cin;
  assign dest         = instruction_i.dest;
  assign gate         = instruction_i.gate;
  assign set_c        = instruction_i.set_c;
  assign z            = instruction_i.z;
  assign set_s        = instruction_i.set_s;
  assign at           = instruction_i.at;
  assign down         = instruction_i.down;
  assign addr         = instruction_i.addr;
  assign imm          = instruction_i.imm;
  assign bit_number   = imm[2:0];
  // One port: who writes memory does not read it.
  assign names_memory = ({1'b0, addr} <= LastAddress) &&
                        !(kind == pixelflow_pkg::KindAlu && dest == pixelflow_pkg::ToMemory);

  task automatic fetch_p();
    case (p_code)
      pixelflow_pkg::PM:         for (int unsigned i = 0; i < N; i++) p[i] = m_q[i];
      pixelflow_pkg::PX:         for (int unsigned i = 0; i < N; i++) p[i] = x_q[i];
      pixelflow_pkg::PImmediate: for (int unsigned i = 0; i < N; i++) p[i] = imm;
      pixelflow_pkg::PW:
        case (at)
          2'd0:    for (int unsigned i = 0; i < N; i++) p[i] = w_q[i][7:0];
          2'd1:    for (int unsigned i = 0; i < N; i++) p[i] = w_q[i][15:8];
          2'd2:    for (int unsigned i = 0; i < N; i++) p[i] = w_q[i][23:16];
          default: for (int unsigned i = 0; i < N; i++) p[i] = w_q[i][31:24];
        endcase
      default:                   for (int unsigned i = 0; i < N; i++) p[i] = 8'd0;
    endcase
  endtask

  task automatic fetch_memory();
    if (names_memory) for (int unsigned i = 0; i < N; i++) q[i] = memory_q[addr][i];
    else for (int unsigned i = 0; i < N; i++) q[i] = 8'd0;
  endtask

  task automatic fetch_port();
    if (32'(imm) < PacketBytes) for (int unsigned i = 0; i < N; i++) q[i] = inbound_q[imm[$clog2(PacketBytes)-1:0]][i];
    else if (imm == pixelflow_pkg::PortColumn) for (int unsigned i = 0; i < N; i++) q[i] = column_q[i];
    else if (imm == pixelflow_pkg::PortRow) for (int unsigned i = 0; i < N; i++) q[i] = row_q[i];
    else for (int unsigned i = 0; i < N; i++) q[i] = 8'd0;
  endtask

  task automatic fetch_q();
    case (q_code)
      pixelflow_pkg::QMemory:       fetch_memory();
      pixelflow_pkg::QImmediate:    for (int unsigned i = 0; i < N; i++) q[i] = imm;
      pixelflow_pkg::QM:            for (int unsigned i = 0; i < N; i++) q[i] = m_q[i];
      pixelflow_pkg::QMemoryOrM: begin
        fetch_memory();
        for (int unsigned i = 0; i < N; i++) q[i] = (m_q[i] & {8{k_q[i]}}) | (q[i] & ~{8{k_q[i]}});
      end
      pixelflow_pkg::QExponentLow:  for (int unsigned i = 0; i < N; i++) q[i] = {x_q[i][0], 7'd0};
      pixelflow_pkg::QExponentHigh: for (int unsigned i = 0; i < N; i++) q[i] = {s_q[i], x_q[i][7:1]};
      pixelflow_pkg::QPort:         fetch_port();
      default: for (int unsigned i = 0; i < N; i++) q[i] = {3'd0, e_q[i], k_q[i], s_q[i], z_q[i], c_q[i]};
    endcase
  endtask

  task automatic fetch_carry();
    case (cin)
      pixelflow_pkg::CarryOne: for (int unsigned i = 0; i < N; i++) bits[i] = 1'b1;
      pixelflow_pkg::CarryC:   for (int unsigned i = 0; i < N; i++) bits[i] = c_q[i];
      pixelflow_pkg::CarryK:   for (int unsigned i = 0; i < N; i++) bits[i] = k_q[i];
      default:                 for (int unsigned i = 0; i < N; i++) bits[i] = 1'b0;
    endcase
  endtask

  // The carry out is the majority of the top bits, the sum's inverted: lanes of eight bits suffice.
  task automatic add();
    for (int unsigned i = 0; i < N; i++) begin
      logic [7:0] sum;
      logic       over;
      sum       = p[i] + q[i] + {7'd0, bits[i]};
      over      = (p[i][7] & q[i][7]) | ((p[i][7] | q[i][7]) & ~sum[7]);
      result[i] = sum;
      carry[i]  = over;
      sign[i]   = p[i][7] ^ q[i][7] ^ over;
    end
  endtask

  task automatic no_carry();
    for (int unsigned i = 0; i < N; i++) begin
      carry[i] = 1'b0;
      sign[i]  = result[i][7];
    end
  endtask

  task automatic compute();
    case (fn)
      pixelflow_pkg::AluAdd: add();
      pixelflow_pkg::AluSub: begin
        for (int unsigned i = 0; i < N; i++) q[i] = ~q[i];
        add();
      end
      pixelflow_pkg::AluReverseSub: begin
        for (int unsigned i = 0; i < N; i++) p[i] = ~p[i];
        add();
      end
      pixelflow_pkg::AluAddSub: begin
        for (int unsigned i = 0; i < N; i++) q[i] = q[i] ^ {8{k_q[i]}};
        add();
      end
      pixelflow_pkg::AluAddIf: begin
        for (int unsigned i = 0; i < N; i++) q[i] = q[i] & {8{k_q[i]}};
        add();
      end
      pixelflow_pkg::AluNegateIf: begin
        for (int unsigned i = 0; i < N; i++) p[i] = p[i] ^ {8{k_q[i]}};
        add();
      end
      pixelflow_pkg::AluAnd: begin
        for (int unsigned i = 0; i < N; i++) result[i] = p[i] & q[i];
        no_carry();
      end
      pixelflow_pkg::AluOr: begin
        for (int unsigned i = 0; i < N; i++) result[i] = p[i] | q[i];
        no_carry();
      end
      pixelflow_pkg::AluXor: begin
        for (int unsigned i = 0; i < N; i++) result[i] = p[i] ^ q[i];
        no_carry();
      end
      pixelflow_pkg::AluAndNot: begin
        for (int unsigned i = 0; i < N; i++) result[i] = p[i] & ~q[i];
        no_carry();
      end
      pixelflow_pkg::AluSelect: begin
        for (int unsigned i = 0; i < N; i++) result[i] = (p[i] & {8{k_q[i]}}) | (q[i] & ~{8{k_q[i]}});
        no_carry();
      end
      pixelflow_pkg::AluShiftLeft:
        for (int unsigned i = 0; i < N; i++) begin
          result[i] = {q[i][6:0], bits[i]};
          carry[i]  = q[i][7];
          sign[i]   = q[i][6];
        end
      pixelflow_pkg::AluShiftRight:
        for (int unsigned i = 0; i < N; i++) begin
          result[i] = {bits[i], q[i][7:1]};
          carry[i]  = q[i][0];
          sign[i]   = bits[i];
        end
      default: begin
        for (int unsigned i = 0; i < N; i++) result[i] = 8'd0;
        no_carry();
      end
    endcase
  endtask

  task automatic fetch_gate();
    case (gate)
      pixelflow_pkg::GateE:     for (int unsigned i = 0; i < N; i++) bits[i] = e_q[i];
      pixelflow_pkg::GateEK:    for (int unsigned i = 0; i < N; i++) bits[i] = e_q[i] & k_q[i];
      pixelflow_pkg::GateEnotK: for (int unsigned i = 0; i < N; i++) bits[i] = e_q[i] & ~k_q[i];
      default:                  for (int unsigned i = 0; i < N; i++) bits[i] = 1'b1;
    endcase
  endtask

  task automatic write_memory();
    fetch_gate();
    if ({1'b0, addr} <= LastAddress) begin
      for (int unsigned i = 0; i < N; i++) begin
        memory_q[addr][i] = (result[i] & {8{bits[i]}}) | (memory_q[addr][i] & ~{8{bits[i]}});
      end
    end
  endtask

  task automatic write_outbound();
    fetch_gate();
    if (32'(addr) < PacketBytes) begin
      for (int unsigned i = 0; i < N; i++) begin
        outbound_q[addr[$clog2(PacketBytes)-1:0]][i] =
            (result[i] & {8{bits[i]}}) | (outbound_q[addr[$clog2(PacketBytes)-1:0]][i] & ~{8{bits[i]}});
      end
    end
  endtask

  task automatic write_w();
    case (at)
      2'd0:    for (int unsigned i = 0; i < N; i++) w_q[i] = {w_q[i][31:8], result[i]};
      2'd1:    for (int unsigned i = 0; i < N; i++) w_q[i] = {w_q[i][31:16], result[i], w_q[i][7:0]};
      2'd2:    for (int unsigned i = 0; i < N; i++) w_q[i] = {w_q[i][31:24], result[i], w_q[i][15:0]};
      default: for (int unsigned i = 0; i < N; i++) w_q[i] = {result[i], w_q[i][23:0]};
    endcase
  endtask

  task automatic execute_alu();
    fetch_p();
    fetch_q();
    fetch_carry();
    compute();
    if (down) for (int unsigned i = 0; i < N; i++) w_q[i] = {{8{w_q[i][31]}}, w_q[i][31:8]};
    case (dest)
      pixelflow_pkg::ToM:      for (int unsigned i = 0; i < N; i++) m_q[i] = result[i];
      pixelflow_pkg::ToX:      for (int unsigned i = 0; i < N; i++) x_q[i] = result[i];
      pixelflow_pkg::ToW:      write_w();
      pixelflow_pkg::ToMemory: write_memory();
      pixelflow_pkg::ToPort:   write_outbound();
      default:                 ;
    endcase
    if (set_c) for (int unsigned i = 0; i < N; i++) c_q[i] = carry[i];
    case (z)
      pixelflow_pkg::ZSet: for (int unsigned i = 0; i < N; i++) z_q[i] = (result[i] == 8'd0);
      pixelflow_pkg::ZAnd: for (int unsigned i = 0; i < N; i++) z_q[i] = z_q[i] & (result[i] == 8'd0);
      default:             ;
    endcase
    if (set_s) for (int unsigned i = 0; i < N; i++) s_q[i] = sign[i];
  endtask

  // A digit times the multiplicand; the last digit of a signed multiplier counts negative.
  localparam logic [7:0] DigitMask = 8'((1 << R) - 1);
  localparam logic [31:0] LastDigit = pixelflow_pkg::Digits - 1;
  logic [2:0]  weight;
  logic [31:0] above_digit, imm_factor;
  logic        counts_negative;
  assign weight          = 3'(32'(digit_i) * R);
  assign counts_negative = set_c && (32'(digit_i) == LastDigit);
  assign above_digit     = counts_negative ? 32'd1 << R : 32'd0;   // taken off where the digit's top bit is set
  assign imm_factor      = factor(imm, weight, above_digit);

  function automatic logic [31:0] factor(input logic [7:0] multiplier, input logic [2:0] shift,
                                         input logic [31:0] taken);
    logic [31:0] digit;
    digit  = {24'd0, (multiplier >> shift) & DigitMask};
    factor = (digit - (digit[R-1] ? taken : 32'd0)) << shift;
  endfunction

  task automatic multiply();
    logic [31:0] extend;
    extend = set_s ? 32'hFFFF_FFFF : 32'd0;
    fetch_q();
    if (p_code == pixelflow_pkg::PImmediate) begin
      for (int unsigned i = 0; i < N; i++) begin
        w_q[i] = w_q[i] + imm_factor * ({24'd0, q[i]} | ({{24{q[i][7]}}, 8'd0} & extend));
      end
    end else begin
      for (int unsigned i = 0; i < N; i++) begin
        w_q[i] = w_q[i] + factor(x_q[i], weight, above_digit) * ({24'd0, q[i]} | ({{24{q[i][7]}}, 8'd0} & extend));
      end
    end
  endtask

  // Where a shift happens.
  task automatic fetch_when();
    case (p_code)
      pixelflow_pkg::WhenAlways: for (int unsigned i = 0; i < N; i++) bits[i] = 1'b1;
      pixelflow_pkg::WhenK:      for (int unsigned i = 0; i < N; i++) bits[i] = k_q[i];
      pixelflow_pkg::WhenXBit:   for (int unsigned i = 0; i < N; i++) bits[i] = x_q[i][bit_number];
      pixelflow_pkg::WhenNormalize:
        case (at)
          2'd0:    for (int unsigned i = 0; i < N; i++) bits[i] = (w_q[i] < 32'h8000_0000) & (x_q[i] > 8'd1);
          2'd1:    for (int unsigned i = 0; i < N; i++) bits[i] = (w_q[i] < 32'h4000_0000) & (x_q[i] > 8'd2);
          2'd2:    for (int unsigned i = 0; i < N; i++) bits[i] = (w_q[i] < 32'h1000_0000) & (x_q[i] > 8'd4);
          default: for (int unsigned i = 0; i < N; i++) bits[i] = (w_q[i] < 32'h0100_0000) & (x_q[i] > 8'd8);
        endcase
      default:                   for (int unsigned i = 0; i < N; i++) bits[i] = 1'b0;
    endcase
  endtask

  task automatic shift_right();
    logic [31:0] jam;
    jam = {31'd0, cin == pixelflow_pkg::FillJam};
    fetch_when();
    case (cin)
      pixelflow_pkg::FillSign: for (int unsigned i = 0; i < N; i++) carry[i] = w_q[i][31];
      pixelflow_pkg::FillC:    for (int unsigned i = 0; i < N; i++) carry[i] = c_q[i];
      default:                 for (int unsigned i = 0; i < N; i++) carry[i] = 1'b0;
    endcase
    case (at)
      2'd0: for (int unsigned i = 0; i < N; i++)
        w_q[i] = bits[i] ? {carry[i], w_q[i][31:1]} | (jam & {31'd0, w_q[i][0]}) : w_q[i];
      2'd1: for (int unsigned i = 0; i < N; i++)
        w_q[i] = bits[i] ? {{2{carry[i]}}, w_q[i][31:2]} | (jam & {31'd0, w_q[i][1:0] != 2'd0}) : w_q[i];
      2'd2: for (int unsigned i = 0; i < N; i++)
        w_q[i] = bits[i] ? {{4{carry[i]}}, w_q[i][31:4]} | (jam & {31'd0, w_q[i][3:0] != 4'd0}) : w_q[i];
      default: for (int unsigned i = 0; i < N; i++)
        w_q[i] = bits[i] ? {{8{carry[i]}}, w_q[i][31:8]} | (jam & {31'd0, w_q[i][7:0] != 8'd0}) : w_q[i];
    endcase
  endtask

  task automatic shift_left();
    fetch_when();
    case (at)
      2'd0:    for (int unsigned i = 0; i < N; i++) w_q[i] = bits[i] ? {w_q[i][30:0], 1'd0} : w_q[i];
      2'd1:    for (int unsigned i = 0; i < N; i++) w_q[i] = bits[i] ? {w_q[i][29:0], 2'd0} : w_q[i];
      2'd2:    for (int unsigned i = 0; i < N; i++) w_q[i] = bits[i] ? {w_q[i][27:0], 4'd0} : w_q[i];
      default: for (int unsigned i = 0; i < N; i++) w_q[i] = bits[i] ? {w_q[i][23:0], 8'd0} : w_q[i];
    endcase
    if (p_code == pixelflow_pkg::WhenNormalize) begin
      for (int unsigned i = 0; i < N; i++) x_q[i] = x_q[i] - (8'({7'd0, bits[i]}) << at);
    end
  endtask

  task automatic divide();
    for (int unsigned i = 0; i < N; i++) begin
      bits[i]  = ~(s_q[i] ^ k_q[i] ^ c_q[i]);
      carry[i] = x_q[i][7];
    end
    if (set_c || set_s) for (int unsigned i = 0; i < N; i++) x_q[i] = {x_q[i][6:0], bits[i] & set_c};
    if (set_c) for (int unsigned i = 0; i < N; i++) k_q[i] = bits[i];
    if (set_s) begin
      case (at)
        2'd0:    for (int unsigned i = 0; i < N; i++) s_q[i] = w_q[i][7];
        2'd1:    for (int unsigned i = 0; i < N; i++) s_q[i] = w_q[i][15];
        2'd2:    for (int unsigned i = 0; i < N; i++) s_q[i] = w_q[i][23];
        default: for (int unsigned i = 0; i < N; i++) s_q[i] = w_q[i][31];
      endcase
      for (int unsigned i = 0; i < N; i++) w_q[i] = {w_q[i][30:0], carry[i]};
    end
  endtask

  task automatic execute_wide();
    case (fn)
      pixelflow_pkg::WideClear:      for (int unsigned i = 0; i < N; i++) w_q[i] = 32'd0;
      pixelflow_pkg::WideMultiply:   multiply();
      pixelflow_pkg::WideShiftRight: shift_right();
      pixelflow_pkg::WideShiftLeft:  shift_left();
      pixelflow_pkg::WideDivide:     divide();
      default:                       ;
    endcase
  endtask

  task automatic execute_flag();
    case (fn)
      pixelflow_pkg::BitOne: for (int unsigned i = 0; i < N; i++) bits[i] = 1'b1;
      pixelflow_pkg::BitC:   for (int unsigned i = 0; i < N; i++) bits[i] = c_q[i];
      pixelflow_pkg::BitZ:   for (int unsigned i = 0; i < N; i++) bits[i] = z_q[i];
      pixelflow_pkg::BitS:   for (int unsigned i = 0; i < N; i++) bits[i] = s_q[i];
      pixelflow_pkg::BitK:   for (int unsigned i = 0; i < N; i++) bits[i] = k_q[i];
      pixelflow_pkg::BitE:   for (int unsigned i = 0; i < N; i++) bits[i] = e_q[i];
      pixelflow_pkg::BitOfP: begin
        fetch_p();
        for (int unsigned i = 0; i < N; i++) bits[i] = p[i][bit_number];
      end
      pixelflow_pkg::BitOfQ: begin
        fetch_q();
        for (int unsigned i = 0; i < N; i++) bits[i] = q[i][bit_number];
      end
      pixelflow_pkg::BitWideZero: for (int unsigned i = 0; i < N; i++) bits[i] = (w_q[i] == 32'd0);
      default: for (int unsigned i = 0; i < N; i++) bits[i] = 1'b0;
    endcase
    if (set_c) for (int unsigned i = 0; i < N; i++) bits[i] = ~bits[i];
    // The old value joins in where the operation is not a move.
    case (dest)
      pixelflow_pkg::FlagC: begin
        for (int unsigned i = 0; i < N; i++) carry[i] = c_q[i];
        combine();
        for (int unsigned i = 0; i < N; i++) c_q[i] = bits[i];
      end
      pixelflow_pkg::FlagZ: begin
        for (int unsigned i = 0; i < N; i++) carry[i] = z_q[i];
        combine();
        for (int unsigned i = 0; i < N; i++) z_q[i] = bits[i];
      end
      pixelflow_pkg::FlagS: begin
        for (int unsigned i = 0; i < N; i++) carry[i] = s_q[i];
        combine();
        for (int unsigned i = 0; i < N; i++) s_q[i] = bits[i];
      end
      pixelflow_pkg::FlagK: begin
        for (int unsigned i = 0; i < N; i++) carry[i] = k_q[i];
        combine();
        for (int unsigned i = 0; i < N; i++) k_q[i] = bits[i];
      end
      pixelflow_pkg::FlagE: begin
        for (int unsigned i = 0; i < N; i++) carry[i] = e_q[i];
        combine();
        for (int unsigned i = 0; i < N; i++) e_q[i] = bits[i];
      end
      default: ;
    endcase
  endtask

  task automatic combine();
    case (cin)
      pixelflow_pkg::FlagAnd: for (int unsigned i = 0; i < N; i++) bits[i] = bits[i] & carry[i];
      pixelflow_pkg::FlagOr:  for (int unsigned i = 0; i < N; i++) bits[i] = bits[i] | carry[i];
      pixelflow_pkg::FlagXor: for (int unsigned i = 0; i < N; i++) bits[i] = bits[i] ^ carry[i];
      default:                ;
    endcase
  endtask

  task automatic clear();
    for (int unsigned i = 0; i < N; i++) begin
      w_q[i] = 32'd0;
      m_q[i] = 8'd0;
      x_q[i] = 8'd0;
      e_q[i] = 1'b0;
      k_q[i] = 1'b0;
      s_q[i] = 1'b0;
      z_q[i] = 1'b0;
      c_q[i] = 1'b0;
    end
  endtask

  task automatic place_all();
    for (int unsigned i = 0; i < N; i++) begin
      logic [31:0] index;
      index       = 32'(chip_i) * N + i;
      column_q[i] = 8'(index % pixelflow_pkg::RegionWidth);
      row_q[i]    = 8'(index / pixelflow_pkg::RegionWidth);
    end
  endtask

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      clear();
    end else if (execute_i) begin
      case (kind)
        pixelflow_pkg::KindAlu:  execute_alu();
        pixelflow_pkg::KindWide: execute_wide();
        pixelflow_pkg::KindFlag: execute_flag();
        default:                 ;
      endcase
    end
    if (place_all_i) place_all();
    if (place_i) begin
      column_q[place_lane_i] = place_column_i;
      row_q[place_lane_i]    = place_row_i;
    end
    if (inbound_we_i) begin
      for (int unsigned b = 0; b < PacketBytes; b++) inbound_q[b][inbound_lane_i] = inbound_packet_i[8*b +: 8];
    end
    if (outbound_re_i) begin
      for (int unsigned b = 0; b < PacketBytes; b++) outbound_packet_q[8*b +: 8] <= outbound_q[b][outbound_lane_i];
    end
  end

  assign outbound_packet_o = outbound_packet_q;

`ifdef FORMAL
  assign registers_o = {e_q[0], k_q[0], s_q[0], z_q[0], c_q[0], m_q[0], x_q[0], w_q[0]};
  assign bytes_o     = {inbound_q[1][0], inbound_q[0][0], row_q[0], column_q[0],
                        outbound_q[1][0], outbound_q[0][0], memory_q[1][0], memory_q[0][0]};
`endif

endmodule
