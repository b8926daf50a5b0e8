// Types of the pixel processors: the instruction word, its codes, and an element's registers. docs/pixel_processor.md
// says what each code does. The paper (Olano and Lastra 1998, section 5.1) gives 8-bit ALUs that support integer
// multiplication, 256 bytes of memory and an enable flag; the rest of the element is this project's own.

`include "pixelflow_parameters.svh"

package pixelflow_pkg;

  localparam int unsigned Elements       = `PIXELFLOW_ELEMENTS;
  localparam int unsigned MemoryBytes    = `PIXELFLOW_MEMORY_BYTES;
  localparam int unsigned MultiplierBits = `PIXELFLOW_MULTIPLIER_BITS;
  localparam int unsigned Digits         = 8 / `PIXELFLOW_MULTIPLIER_BITS;
  localparam int unsigned DigitWidth     = Digits > 1 ? $clog2(Digits) : 1;
  localparam int unsigned RegionWidth    = `PIXELFLOW_REGION_WIDTH;
  localparam int unsigned RegionHeight   = `PIXELFLOW_REGION_HEIGHT;
  localparam int unsigned PacketBytes    = `PIXELFLOW_PACKET_BYTES;
  localparam int unsigned DepthBytes     = `PIXELFLOW_DEPTH_BYTES;
  localparam int unsigned StreamWords    = `PIXELFLOW_STREAM_WORDS;

  typedef logic [7:0]  byte_t;
  typedef logic [31:0] wide_t;
  typedef logic [DigitWidth-1:0] digit_t;

  typedef enum logic [1:0] {KindAlu = 2'd0, KindWide = 2'd1, KindFlag = 2'd2, KindControl = 2'd3} kind_e;

  // `fn` of an ALU instruction: R from the operands P and Q and a carry.
  typedef enum logic [3:0] {
    AluAdd = 4'd0, AluSub = 4'd1, AluReverseSub = 4'd2, AluAddSub = 4'd3, AluAddIf = 4'd4, AluNegateIf = 4'd5,
    AluAnd = 4'd6, AluOr = 4'd7, AluXor = 4'd8, AluAndNot = 4'd9, AluSelect = 4'd10,
    AluShiftLeft = 4'd11, AluShiftRight = 4'd12
  } alu_e;

  // `fn` of a wide instruction: what happens to W (and X).
  typedef enum logic [3:0] {
    WideClear = 4'd0, WideMultiply = 4'd1, WideShiftRight = 4'd2, WideShiftLeft = 4'd3, WideDivide = 4'd4
  } wide_e;

  // `fn` of a flag instruction: the source bit.
  typedef enum logic [3:0] {
    BitOne = 4'd0, BitC = 4'd1, BitZ = 4'd2, BitS = 4'd3, BitK = 4'd4, BitE = 4'd5, BitOfP = 4'd6, BitOfQ = 4'd7,
    BitWideZero = 4'd8
  } bit_e;

  // `fn` of a control instruction, for the sequencer alone.
  typedef enum logic [3:0] {
    ControlNop = 4'd0, ControlEnd = 4'd1, ControlWaitInbound = 4'd2, ControlFreeInbound = 4'd3, ControlSend = 4'd4
  } control_e;

  typedef enum logic [2:0] {PZero = 3'd0, PM = 3'd1, PX = 3'd2, PW = 3'd3, PImmediate = 3'd4} p_e;

  typedef enum logic [2:0] {
    QMemory = 3'd0, QImmediate = 3'd1, QM = 3'd2, QMemoryOrM = 3'd3, QExponentLow = 3'd4, QExponentHigh = 3'd5,
    QPort = 3'd6, QFlags = 3'd7
  } q_e;

  typedef enum logic [1:0] {CarryZero = 2'd0, CarryOne = 2'd1, CarryC = 2'd2, CarryK = 2'd3} carry_e;

  // `p` and `cin` of a shift: when it happens, and what comes in.
  typedef enum logic [2:0] {WhenAlways = 3'd0, WhenK = 3'd1, WhenXBit = 3'd2, WhenNormalize = 3'd3} when_e;
  typedef enum logic [1:0] {FillZero = 2'd0, FillSign = 2'd1, FillC = 2'd2, FillJam = 2'd3} fill_e;

  typedef enum logic [2:0] {ToNone = 3'd0, ToM = 3'd1, ToX = 3'd2, ToW = 3'd3, ToMemory = 3'd4, ToPort = 3'd5} dest_e;
  // `dest` and `cin` of a flag instruction.
  typedef enum logic [2:0] {FlagC = 3'd0, FlagZ = 3'd1, FlagS = 3'd2, FlagK = 3'd3, FlagE = 3'd4} flag_e;
  typedef enum logic [1:0] {FlagMove = 2'd0, FlagAnd = 2'd1, FlagOr = 2'd2, FlagXor = 2'd3} flag_op_e;

  typedef enum logic [1:0] {GateE = 2'd0, GateEK = 2'd1, GateEnotK = 2'd2, GateNone = 2'd3} gate_e;
  typedef enum logic [1:0] {ZKeep = 2'd0, ZSet = 2'd1, ZAnd = 2'd2} z_e;

  // Fields that have other names in other kinds are explained in docs/pixel_processor.md; an unused code does nothing.
  typedef struct packed {
    logic [1:0] kind;
    logic [3:0] fn;
    logic [2:0] p;
    logic [2:0] q;
    logic [1:0] cin;
    logic [2:0] dest;
    logic [1:0] gate;
    logic       set_c;
    logic [1:0] z;
    logic       set_s;
    logic [1:0] at;
    logic       down;
    logic [7:0] addr;
    logic [7:0] imm;
  } instruction_t;

  // An element's registers, as trace ports show them.
  typedef struct packed {
    logic  e;
    logic  k;
    logic  s;
    logic  z;
    logic  c;
    byte_t m;
    byte_t x;
    wide_t w;
  } registers_t;

  // What imm names when Q is the port, beyond the bytes of the packet.
  localparam logic [7:0] PortColumn = 8'h80;
  localparam logic [7:0] PortRow    = 8'h81;

  // Number of an element in its chip.
  localparam int unsigned LaneWidth = Elements > 1 ? $clog2(Elements) : 1;
  typedef logic [LaneWidth-1:0] lane_t;

  // A packet of the composition network; its first byte is the least significant one, depth is unsigned.
  typedef struct packed {
    logic [8*(PacketBytes-DepthBytes)-1:0] data;
    logic [8*DepthBytes-1:0]               depth;
  } packet_t;

  // What the composition port passes on: own packets alone (the first node, or final colours), the closer of own and
  // upstream, upstream alone (colours of another node), or for further packets of the same pixels what won last.
  typedef enum logic [1:0] {
    ComposeOwn = 2'd0, ComposeCloser = 2'd1, ComposeUpstream = 2'd2, ComposeRepeat = 2'd3
  } compose_e;

  typedef logic [63:0] count_t;

endpackage
