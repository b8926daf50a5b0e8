// Polygon segment lists (chapter III.A): an edge that enters finds its place among the segments of its polygon, left to
// right: the empty half of a block, or a new block. Equal X: the slope decides.
//
// Latency: 2 cycles a block looked at, 1 to 3 for the insertion. Refuses: when no block is left, full_o, and nothing more.

module polygon_segment_lists (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  // from the segment generator
  input  logic                      insert_i,
  input  vsg_pkg::edge_t            edge_i,           // held until done_o
  input  vsg_pkg::poly_ptr_t        polygon_i,
  input  vsg_pkg::ptr_t             first_segment_i,
  output logic                      done_o,
  output logic                      full_o,
  // to the polygon memory
  output logic                      set_first_o,
  output vsg_pkg::ptr_t             set_segment_o,
  // to and from the free list and the sample list
  output logic                      take_o,
  input  vsg_pkg::ptr_t             free_block_i,
  input  logic                      free_fresh_i,
  input  logic                      free_full_i,
  output logic                      clear_samples_o,
  // segment memory
  output vsg_pkg::memory_request_t  request_o,
  input  vsg_pkg::segment_t         word_i,
  // to the tally
  output vsg_pkg::count_t           count_o
);

  typedef enum logic [2:0] {
    StIdle,
    StLook,       // is there a block?
    StWord,       // its word
    StTake,       // a new block
    StLink,       // the block before points to the new one
    StFill        // the empty half of a block
  } state_e;

  typedef enum logic [1:0] {
    PlaceNewBlock,
    PlaceSplit,          // between the edges of a segment: its right edge moves to a new block
    PlaceLeft,           // empty left half of `previous`
    PlaceRight           // empty right half of `previous`
  } place_e;

  state_e state_d, state_q;
  place_e place_d, place_q;
  vsg_pkg::ptr_t previous_d, previous_q, next_d, next_q, taken_d, taken_q;
  logic right_empty_d, right_empty_q;  // of `previous`

  // Sides of the entering edge: X here, then the slope.
  vsg_pkg::x_t left_x, right_x, left_dx, right_dx, edge_x, edge_dx;
  assign left_x   = vsg_pkg::next_x(word_i.left.x, word_i.left.dx);
  assign right_x  = vsg_pkg::next_x(word_i.right.x, word_i.right.dx);
  assign left_dx  = word_i.left.dx;
  assign right_dx = word_i.right.dx;
  assign edge_x   = edge_i.x;
  assign edge_dx  = edge_i.dx;
  logic left_of_left, left_of_right, has_left, has_right;
  assign left_of_left  = (edge_x == left_x) ? (edge_dx < left_dx) : (edge_x < left_x);
  assign left_of_right = (edge_x == right_x) ? (edge_dx < right_dx) : (edge_x < right_x);
  assign has_left  = word_i.left_lines[vsg_pkg::CoordW+1];
  assign has_right = word_i.right_lines[vsg_pkg::CoordW+1];

  // The depth comparator adds the increments before it uses a segment: what is stored is one line behind.
  vsg_pkg::segment_edge_t half;
  vsg_pkg::lines_t half_lines;
  assign half.x     = edge_i.x - edge_i.dx;
  assign half.dx    = edge_i.dx;
  assign half.z     = edge_i.z - edge_i.dz;
  assign half.dz    = edge_i.dz;
  assign half_lines = -{2'b00, edge_i.lines};

  always_comb begin
    state_d         = state_q;
    place_d         = place_q;
    previous_d      = previous_q;
    next_d          = next_q;
    taken_d         = taken_q;
    right_empty_d   = right_empty_q;
    done_o          = 1'b0;
    full_o          = 1'b0;
    set_first_o     = 1'b0;
    set_segment_o   = free_block_i;
    take_o          = 1'b0;
    clear_samples_o = 1'b0;
    request_o       = '0;
    count_o         = '0;
    case (state_q)
      StIdle: begin
        previous_d    = '0;
        next_d        = first_segment_i;
        right_empty_d = 1'b0;
        if (insert_i) state_d = StLook;
      end
      StLook: begin
        if (next_q == '0) begin
          place_d = right_empty_q ? PlaceRight : PlaceNewBlock;
          state_d = right_empty_q ? StFill : StTake;
        end else begin
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = next_q;
          state_d               = StWord;
        end
      end
      StWord: begin
        if (has_left && left_of_left) begin
          place_d = right_empty_q ? PlaceRight : PlaceNewBlock;
          state_d = right_empty_q ? StFill : StTake;
        end else begin
          previous_d    = next_q;
          next_d        = word_i.polygon_next;
          right_empty_d = !has_right;
          state_d       = StLook;
          if (has_right && left_of_right) begin
            place_d = has_left ? PlaceSplit : PlaceLeft;
            state_d = has_left ? StTake : StFill;
          end
        end
      end
      StTake: begin
        if (free_full_i) begin
          full_o  = 1'b1;
          state_d = StIdle;
        end else begin
          take_o               = 1'b1;
          clear_samples_o      = free_fresh_i;
          taken_d              = free_block_i;
          count_o.blocks_taken = 1'b1;
          count_o.segment_writes = (place_q == PlaceNewBlock) ? 2'd1 : 2'd0;
          request_o.valid             = 1'b1;
          request_o.groups            = vsg_pkg::GroupAll;
          request_o.block             = free_block_i;
          request_o.word.x_previous   = vsg_pkg::NotSorted;
          request_o.word.polygon[vsg_pkg::PolyW-1:0] = polygon_i;
          request_o.word.polygon_next = next_q;
          if (place_q == PlaceNewBlock) begin
            request_o.word.left       = half;
            request_o.word.left_lines = half_lines;
          end else begin
            request_o.word.right       = word_i.right;
            request_o.word.right_lines = word_i.right_lines;
          end
          state_d = (place_q == PlaceSplit) ? StFill : StLink;
        end
        if (previous_q == '0 && !free_full_i) begin
          set_first_o = 1'b1;
          done_o      = 1'b1;
          state_d     = StIdle;
        end
      end
      StLink: begin
        count_o.segment_writes      = 2'd1;
        request_o.valid             = 1'b1;
        request_o.groups            = vsg_pkg::GroupPolygonNext;
        request_o.block             = previous_q;
        request_o.word.polygon_next = taken_q;
        done_o                      = 1'b1;
        state_d                     = StIdle;
      end
      StFill: begin
        count_o.segment_writes = (place_q == PlaceSplit) ? 2'd2 : 2'd1;
        request_o.valid        = 1'b1;
        request_o.block        = previous_q;
        if (place_q == PlaceLeft) begin
          request_o.groups          = vsg_pkg::GroupLeft | vsg_pkg::GroupLeftLines;
          request_o.word.left       = half;
          request_o.word.left_lines = half_lines;
        end else begin
          request_o.groups           = vsg_pkg::GroupRight | vsg_pkg::GroupRightLines;
          request_o.word.right       = half;
          request_o.word.right_lines = half_lines;
          if (place_q == PlaceSplit) begin
            request_o.groups            = vsg_pkg::GroupRight | vsg_pkg::GroupRightLines | vsg_pkg::GroupPolygonNext;
            request_o.word.polygon_next = taken_q;
          end
        end
        done_o  = 1'b1;
        state_d = StIdle;
      end
      default: state_d = StIdle;
    endcase
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q       <= StIdle;
      place_q       <= PlaceNewBlock;
      previous_q    <= '0;
      next_q        <= '0;
      taken_q       <= '0;
      right_empty_q <= 1'b0;
    end else begin
      state_q       <= state_d;
      place_q       <= place_d;
      previous_q    <= previous_d;
      next_q        <= next_d;
      taken_q       <= taken_d;
      right_empty_q <= right_empty_d;
    end
  end

endmodule
