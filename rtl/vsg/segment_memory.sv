// Segment memory (figure 5; chapter VII.C asks for 300 bits at one access): one wide word a segment block and one port.
// An access reads the word or writes the groups of fields that it names, as memory chips with write enables of their own
// do. Latency: a word read is there in the next cycle and stays until the next read. Refuses nothing: the users of the
// port take turns.

module segment_memory (
  input  logic                     clk_i,
  // from the block that works
  input  vsg_pkg::memory_request_t request_i,
  output vsg_pkg::segment_t        word_o,
  // lock-step
  output vsg_pkg::memory_request_t trace_o
);

  typedef logic [vsg_pkg::PtrAddrW-1:0] address_t;

  localparam int Depth = vsg_pkg::SegmentBlocks;
  localparam int LinksW = vsg_pkg::PtrW;
  localparam int EdgeW = vsg_pkg::SegmentEdgeW;

  logic [LinksW-1:0]           x_previous_mem   [Depth];
  logic [LinksW-1:0]           x_next_mem       [Depth];
  logic [vsg_pkg::OwnerW-1:0]  polygon_mem      [Depth];
  logic [LinksW-1:0]           polygon_next_mem [Depth];
  logic [vsg_pkg::CoordW+1:0]  left_lines_mem   [Depth];
  logic [vsg_pkg::CoordW+1:0]  right_lines_mem  [Depth];
  logic [EdgeW-1:0]            left_mem         [Depth];
  logic [EdgeW-1:0]            right_mem        [Depth];
  logic [LinksW:0]             active_mem       [Depth];

  address_t address;
  assign address = request_i.block[vsg_pkg::PtrAddrW-1:0];

  logic read, write;
  vsg_pkg::groups_t groups;
  assign groups = request_i.groups;
  assign read = request_i.valid && (groups == '0);
  assign write = request_i.valid && (groups != '0);

  logic [LinksW-1:0]           x_previous_q, x_next_q, polygon_next_q;
  logic [vsg_pkg::OwnerW-1:0]  polygon_q;
  logic [vsg_pkg::CoordW+1:0]  left_lines_q, right_lines_q;
  logic [EdgeW-1:0]            left_q, right_q;
  logic [LinksW:0]             active_q;

  // A memory a group: they share the address and the one access a cycle.
  always_ff @(posedge clk_i) begin
    if (write && groups[0]) x_previous_mem[address] <= request_i.word.x_previous;
    if (read) x_previous_q <= x_previous_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[1]) x_next_mem[address] <= request_i.word.x_next;
    if (read) x_next_q <= x_next_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[2]) polygon_mem[address] <= request_i.word.polygon;
    if (read) polygon_q <= polygon_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[3]) polygon_next_mem[address] <= request_i.word.polygon_next;
    if (read) polygon_next_q <= polygon_next_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[4]) left_lines_mem[address] <= request_i.word.left_lines;
    if (read) left_lines_q <= left_lines_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[5]) right_lines_mem[address] <= request_i.word.right_lines;
    if (read) right_lines_q <= right_lines_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[6]) left_mem[address] <= request_i.word.left;
    if (read) left_q <= left_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[7]) right_mem[address] <= request_i.word.right;
    if (read) right_q <= right_mem[address];
  end
  always_ff @(posedge clk_i) begin
    if (write && groups[8]) active_mem[address] <= {request_i.word.implied, request_i.word.active_next};
    if (read) active_q <= active_mem[address];
  end

  always_comb begin
    word_o.x_previous   = x_previous_q;
    word_o.x_next       = x_next_q;
    word_o.polygon      = polygon_q;
    word_o.polygon_next = polygon_next_q;
    word_o.left_lines   = left_lines_q;
    word_o.right_lines  = right_lines_q;
    word_o.left         = left_q;
    word_o.right        = right_q;
    word_o.implied      = active_q[LinksW];
    word_o.active_next  = active_q[LinksW-1:0];
  end

  assign trace_o = request_i;

endmodule
