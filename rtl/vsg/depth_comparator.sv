// Depth Comparator (chapter III.F): runs through the segments of a span, first those of the active list, then those of the
// X-sort list whose left edge lies in the span, which the segment stepper brings to this scan line. Each segment present
// in the span is tried against the visible box by the clipping unit. On demand it runs the two segments of the box again
// to find where they cross.
//
// Latency: about 4 cycles a segment of the active list, 6 a segment of the X-sort list, and the test. Refuses: an edge
// that leaves the frame (error_o, held until the next frame).

module depth_comparator (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      frame_start_i,
  input  vsg_pkg::pixel_t           width_i,
  // control
  input  logic                      sort_i,           // build the box of the span
  output logic                      sort_done_o,
  output vsg_pkg::error_e           error_o,
  // from the decision processor
  input  logic                      intersect_i,      // find where the two segments of the box cross
  output logic                      intersect_done_o,
  output vsg_pkg::x_t               crossing_o,       // from the cycle after intersect_done_o on
  output vsg_pkg::box_t             box_o,
  // sample space generator
  input  vsg_pkg::span_t            span_i,
  output logic                      set_left_o,
  output vsg_pkg::sample_point_t    left_point_o,
  output logic                      set_right_o,
  output vsg_pkg::sample_point_t    right_point_o,
  // active list
  output logic                      active_span_start_o,
  input  vsg_pkg::ptr_t             active_first_i,
  output logic                      active_remove_o,
  output vsg_pkg::ptr_t             active_previous_o,
  output vsg_pkg::ptr_t             active_next_o,
  output logic                      active_add_o,
  output logic                      active_add_ending_o,
  output vsg_pkg::ptr_t             active_block_o,
  input  vsg_pkg::ptr_t             active_link_i,
  // X-sort list
  input  vsg_pkg::ptr_t             front_i,
  output logic                      pop_o,
  output vsg_pkg::ptr_t             pop_next_o,
  output logic                      sort_next_o,
  output vsg_pkg::ptr_t             sort_block_o,
  output vsg_pkg::pixel_t           sort_pixel_o,
  input  logic                      sort_next_done_i,
  input  vsg_pkg::ptr_t             sort_previous_i,
  input  vsg_pkg::ptr_t             sort_following_i,
  // free list
  output logic                      return_o,
  output vsg_pkg::ptr_t             returned_o,
  // polygon memory
  output logic                      polygon_read_o,
  output vsg_pkg::poly_ptr_t        polygon_o,
  output logic                      polygon_mark_o,
  input  logic                      polygon_active_i,
  // segment memory
  output vsg_pkg::memory_request_t  request_o,
  input  vsg_pkg::segment_t         word_i,
  // to the tally, and lock-step
  output vsg_pkg::count_t           count_o,
  output vsg_pkg::trace_test_t      trace_o
);

  typedef enum logic [4:0] {
    StIdle,
    StActive,        // is there a segment in the active list?
    StActiveWord,
    StActiveEnd,     // it ends in the span
    StSorted,        // is there a segment in the X-sort list?
    StSortedWord,
    StStep,          // the segment stepper works
    StTest,          // load the clipping unit
    StTestWait,
    StAccount,
    StRun,           // intersection: read a segment of the box
    StRunWord,
    StRunWait,
    StRunAccount,
    StCrossing
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::ptr_t at_d, at_q, next_d, next_q, previous_d, previous_q;
  vsg_pkg::segment_t block_d, block_q;
  logic from_x_sort_d, from_x_sort_q;  // the span has reached the X-sort list
  logic tested_d, tested_q;
  logic searching_d, searching_q, second_d, second_q;
  vsg_pkg::x_t crossing_d, crossing_q;
  vsg_pkg::error_e error_d, error_q;

  vsg_pkg::pixel_t span_left, span_right;
  assign span_left  = span_i.left;
  assign span_right = span_i.right;

  // The segment at hand on this line.
  vsg_pkg::segment_t at_hand;
  assign at_hand = (state_q == StActiveWord || state_q == StRunWord) ? word_i : block_q;
  vsg_pkg::pixel_t left, right, next_left, next_right;
  assign left       = vsg_pkg::pixel_of(at_hand.left.x);
  assign right      = vsg_pkg::pixel_of(at_hand.right.x);
  assign next_left  = vsg_pkg::next_pixel(block_q.left.x, block_q.left.dx);
  assign next_right = vsg_pkg::next_pixel(block_q.right.x, block_q.right.dx);
  logic left_lives, right_lives;
  assign left_lives  = block_q.left_lines[vsg_pkg::CoordW+1];
  assign right_lives = block_q.right_lines[vsg_pkg::CoordW+1];

  vsg_pkg::pixel_t front_pixel;
  assign front_pixel = vsg_pkg::next_pixel(word_i.left.x, word_i.left.dx);

  logic signed [vsg_pkg::IntegerBits:0] span_middle;
  assign span_middle = {span_left[vsg_pkg::IntegerBits-1], span_left} + {span_right[vsg_pkg::IntegerBits-1], span_right};
  localparam logic [vsg_pkg::BoxW-1:0] Two = 2;

  // --- segment stepper
  logic step_start, step_done, step_present, step_error, step_set_left, step_add, step_add_ending;
  vsg_pkg::segment_t stepped;
  vsg_pkg::sample_point_t step_left_point;
  vsg_pkg::memory_request_t step_request;
  vsg_pkg::count_t step_count;

  segment_stepper u_segment_stepper (
    .clk_i, .rst_ni, .frame_start_i, .width_i, .span_left_i(span_left), .span_right_i(span_right),
    .start_i(step_start), .at_i(at_q), .word_i, .done_o(step_done),
    .present_o(step_present), .block_o(stepped), .error_o(step_error), .set_left_o(step_set_left),
    .left_point_o(step_left_point), .sort_next_o, .sort_pixel_o, .sort_next_done_i, .sort_previous_i, .sort_following_i,
    .polygon_read_o, .polygon_o, .polygon_mark_o, .polygon_active_i, .active_add_o(step_add),
    .active_add_ending_o(step_add_ending), .active_link_i, .return_o, .request_o(step_request), .count_o(step_count)
  );
  assign sort_block_o = at_q;
  assign returned_o   = at_q;

  // --- clipping unit
  logic clear_box, start, test_done, account;
  vsg_pkg::candidate_t candidate;
  vsg_pkg::x_t found_crossing;
  logic [vsg_pkg::AddW-1:0] add_cycles;
  vsg_pkg::box_t box;

  always_comb begin
    candidate.block       = at_q;
    candidate.polygon     = at_hand.polygon[vsg_pkg::PolyW-1:0];
    candidate.x_left      = at_hand.left.x;
    candidate.x_right     = at_hand.right.x;
    candidate.z_left      = at_hand.left.z;
    candidate.z_right     = at_hand.right.z;
    candidate.edge_inside = (left < span_left) ? right : left;
    if (state_q == StRunWord) candidate.edge_inside = box.edge_inside;  // judged already
  end

  clipping_unit u_clipping_unit (
    .clk_i, .rst_ni, .frame_start_i,
    .clear_i(clear_box), .start_i(start), .candidate_i(candidate), .from_x_sort_i(from_x_sort_q),
    .searching_i(searching_q), .done_o(test_done), .account_i(account), .add_cycles_o(add_cycles),
    .crossing_o(found_crossing), .span_i, .box_o(box), .trace_o
  );

  always_comb begin
    state_d       = state_q;
    at_d          = at_q;
    next_d        = next_q;
    previous_d    = previous_q;
    block_d       = block_q;
    from_x_sort_d = from_x_sort_q;
    tested_d      = tested_q;
    searching_d   = searching_q;
    second_d      = second_q;
    crossing_d    = crossing_q;
    error_d       = error_q;
    sort_done_o         = 1'b0;
    intersect_done_o    = 1'b0;
    set_left_o          = 1'b0;
    left_point_o        = '0;
    set_right_o         = 1'b0;
    right_point_o       = '0;
    active_span_start_o = 1'b0;
    active_remove_o     = 1'b0;
    active_previous_o   = previous_q;
    active_next_o       = word_i.active_next;
    active_add_o        = 1'b0;
    active_add_ending_o = 1'b0;
    active_block_o      = at_q;
    pop_o               = 1'b0;
    pop_next_o          = word_i.x_next;
    request_o           = '0;
    count_o             = '0;
    clear_box           = 1'b0;
    step_start          = 1'b0;
    start               = 1'b0;
    account             = 1'b0;
    case (state_q)
      StIdle: begin
        searching_d = 1'b0;
        second_d    = 1'b0;
        previous_d  = '0;
        at_d        = active_first_i;
        if (sort_i) begin
          clear_box           = 1'b1;
          from_x_sort_d       = 1'b0;
          active_span_start_o = 1'b1;
          state_d             = StActive;
        end else if (intersect_i) begin
          clear_box   = 1'b1;
          searching_d = 1'b1;
          at_d        = box.front;
          state_d     = StRun;
        end
      end

      // --- active list
      StActive: begin
        if (at_q == '0) begin
          state_d = StSorted;
        end else begin
          count_o.mark          = 1'b1;
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = at_q;
          tested_d              = 1'b0;
          state_d               = StActiveWord;
        end
      end
      StActiveWord: begin
        block_d = word_i;
        next_d  = word_i.active_next;
        if (right > span_right) begin
          previous_d = at_q;
          state_d    = (left < span_right) ? StTest : StAccount;
        end else begin
          active_remove_o = 1'b1;
          count_o.segment_writes = (right >= span_left) ? 2'd2 : 2'd1;
          state_d                = (right >= span_left) ? StActiveEnd : StAccount;
        end
      end
      StActiveEnd: begin
        active_add_ending_o        = 1'b1;
        request_o.valid            = 1'b1;
        request_o.groups           = vsg_pkg::GroupActive;
        request_o.block            = at_q;
        request_o.word.implied     = block_q.implied;
        request_o.word.active_next = active_link_i;
        state_d                    = StTest;
      end

      // --- X-sort list
      StSorted: begin
        at_d = front_i;
        if (front_i == '0) begin
          sort_done_o = 1'b1;
          state_d     = StIdle;
        end else begin
          count_o.mark          = 1'b1;
          count_o.segment_reads = 2'd1;
          request_o.valid       = 1'b1;
          request_o.block       = front_i;
          tested_d              = 1'b0;
          state_d               = StSortedWord;
        end
      end
      StSortedWord: begin
        if (front_pixel >= span_right) begin
          sort_done_o = 1'b1;
          state_d     = StIdle;
        end else begin
          from_x_sort_d = 1'b1;
          pop_o         = 1'b1;
          step_start    = 1'b1;
          count_o       = step_count;
          state_d       = StStep;
        end
      end
      StStep: begin
        block_d        = stepped;
        request_o      = step_request;
        count_o        = step_count;
        set_left_o     = step_set_left;
        left_point_o   = step_left_point;
        active_add_o        = step_add;
        active_add_ending_o = step_add_ending;
        if (step_error) begin
          error_d = vsg_pkg::ErrorOutOfFrame;
          state_d = StIdle;
        end else if (step_done) begin
          state_d = step_present ? StTest : StAccount;
        end
      end

      // --- test
      StTest: begin
        count_o.depth_tests = 1'b1;
        tested_d            = 1'b1;
        start               = 1'b1;
        set_left_o                  = left_lives && (left + 1'b1 == span_left);
        left_point_o.pixel          = next_left;
        left_point_o.address.block  = at_q;
        set_right_o                 = right_lives && (right == span_right);
        right_point_o.pixel         = next_right;
        right_point_o.address.block = at_q;
        right_point_o.address.side  = 1'b1;
        state_d                     = StTestWait;
      end
      StTestWait: if (test_done) state_d = StAccount;
      StAccount: begin
        account         = 1'b1;
        count_o.account = 1'b1;
        count_o.tested  = tested_q;
        at_d            = next_q;
        state_d         = from_x_sort_q ? StSorted : StActive;
      end

      // --- intersection
      StRun: begin
        count_o.mark          = 1'b1;
        count_o.segment_reads = 2'd1;
        request_o.valid       = 1'b1;
        request_o.block       = at_q;
        state_d               = StRunWord;
      end
      StRunWord: begin
        start   = 1'b1;
        state_d = StRunWait;
      end
      StRunWait: if (test_done) state_d = StRunAccount;
      StRunAccount: begin
        account         = 1'b1;
        count_o.account = 1'b1;
        second_d        = 1'b1;
        at_d            = box.other;
        state_d         = second_q ? StCrossing : StRun;
      end
      StCrossing: begin
        count_o.segment_reads = 2'd2;
        // A crossing that turned out a tie has no place of its own: the middle of the span stands for it.
        crossing_d = (box.segments == Two) ? found_crossing : {span_middle[vsg_pkg::IntegerBits:1], {vsg_pkg::FracX{1'b0}}};
        intersect_done_o = 1'b1;
        state_d          = StIdle;
      end
      default: state_d = StIdle;
    endcase
    count_o.add_cycles = count_o.account ? add_cycles : '0;
    if (frame_start_i) begin
      state_d = StIdle;
      error_d = vsg_pkg::ErrorNone;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q       <= StIdle;
      at_q          <= '0;
      next_q        <= '0;
      previous_q    <= '0;
      block_q       <= '0;
      from_x_sort_q <= 1'b0;
      tested_q      <= 1'b0;
      searching_q   <= 1'b0;
      second_q      <= 1'b0;
      crossing_q    <= '0;
      error_q       <= vsg_pkg::ErrorNone;
    end else begin
      state_q       <= state_d;
      at_q          <= at_d;
      next_q        <= next_d;
      previous_q    <= previous_d;
      block_q       <= block_d;
      from_x_sort_q <= from_x_sort_d;
      tested_q      <= tested_d;
      searching_q   <= searching_d;
      second_q      <= second_d;
      crossing_q    <= crossing_d;
      error_q       <= error_d;
    end
  end

  assign error_o    = error_q;
  assign crossing_o = crossing_q;
  assign box_o      = box;

endmodule
