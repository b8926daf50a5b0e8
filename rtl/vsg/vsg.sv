// The Visible Segment Generator VSG6 (Watkins 1970, figure 10): Segment Generator, Segment Eliminator and Depth Sorter
// (Sample Space Generator, Depth Comparator, Decision Processor) work scan line by scan line, one after the other, on one
// segment memory with one port.
//
// A frame: frame_start_i with the size; polygon blocks, then edge blocks, are loaded in the order of their numbers; run_i;
// visible segments leave through valid/ready; done_o. Frames up to 2^VSG_COORDINATE_BITS - 1 columns and lines.
// Refuses: what error_o names. The machine then stops, and frame_start_i starts it again.
//
// Longer than a module should be: it holds nothing but the wiring of the blocks and the control of figure 10.

module vsg (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  // host
  input  logic                       frame_start_i,
  input  vsg_pkg::line_t             width_i,        // held during the frame
  input  vsg_pkg::line_t             height_i,
  input  logic                       polygon_valid_i,
  output logic                       polygon_ready_o,
  input  logic                       polygon_front_i,
  input  logic                       edge_valid_i,
  output logic                       edge_ready_o,
  input  vsg_pkg::edge_t             edge_i,
  input  logic                       run_i,
  output logic                       loading_o,      // not yet ready to run
  output logic                       running_o,
  output logic                       done_o,         // one cycle
  output vsg_pkg::error_e            error_o,
  output vsg_pkg::line_t             line_o,
  // display file
  output logic                       segment_valid_o,
  input  logic                       segment_ready_i,
  output vsg_pkg::visible_segment_t  segment_o,
  // counters
  input  logic [5:0]                 counter_select_i,
  output vsg_pkg::counter_t          counter_o,
  // lock-step
  output vsg_pkg::trace_edge_t       trace_edge_o,
  output vsg_pkg::memory_request_t   trace_write_o,
  output vsg_pkg::trace_test_t       trace_test_o,
  output vsg_pkg::trace_decision_t   trace_decision_o,
  output vsg_pkg::trace_sample_t     trace_sample_o,
  output vsg_pkg::trace_phase_t      trace_phase_o,
  output vsg_pkg::counters_t         trace_counters_o
);

  typedef enum logic [3:0] {
    StIdle,        // loading
    StLine,        // a scan line begins
    StGenerate,
    StEliminate,
    StSort,        // the depth sort begins: implied edges not found again go back
    StSpan,
    StSpanWait,
    StCompare,
    StCompareAgain,
    StDecide,
    StFinish,
    StLineDone,
    StError
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::line_t line_d, line_q;
  // Spans of a line before the frame is given up: 64 times the width.
  localparam int SpanShift = 6;
  logic [vsg_pkg::CoordW+SpanShift-1:0] spans_d, spans_q;
  vsg_pkg::error_e error_d, error_q;
  logic sort_started_q;

  vsg_pkg::pixel_t width;
  assign width = {{vsg_pkg::IntegerBits-vsg_pkg::CoordW{1'b0}}, width_i};

  logic line_start, generate_start, eliminate_start, sort_start, span_next, compare_start, decide_start, finish_start;

  // --- memories and lists

  vsg_pkg::memory_request_t request, sort_request, lists_request, eliminator_request, active_request, implied_request,
                            comparator_request;
  vsg_pkg::segment_t word;
  vsg_pkg::count_t count, polygon_count, edge_count, sort_count, lists_count, generator_count, eliminator_count,
                   active_count, implied_count, comparator_count, samples_count, decision_count;

  // One block works at a time; the others drive zeros.
  assign request = sort_request | lists_request | eliminator_request | active_request | implied_request |
                   comparator_request;
  assign count   = polygon_count | edge_count | sort_count | lists_count | generator_count | eliminator_count |
                   active_count | implied_count | comparator_count | samples_count | decision_count;

  segment_memory u_segment_memory (.clk_i, .request_i(request), .word_o(word), .trace_o(trace_write_o));

  logic take, free_fresh, free_full, put_back, lists_take, implied_take, eliminator_return, implied_return,
        comparator_return;
  vsg_pkg::ptr_t free_block, returned, eliminator_returned, implied_returned, comparator_returned;
  assign take     = lists_take || implied_take;
  assign put_back = eliminator_return || implied_return || comparator_return;
  assign returned = eliminator_return ? eliminator_returned : implied_return ? implied_returned : comparator_returned;

  free_list u_free_list (
    .clk_i, .rst_ni, .frame_start_i, .take_i(take), .block_o(free_block), .fresh_o(free_fresh), .full_o(free_full),
    .return_i(put_back), .returned_i(returned)
  );

  logic polygon_read, polygon_mark, polygon_set_first, polygon_take, polygon_front, polygon_active, polygon_full;
  logic generator_polygon_read, comparator_polygon_read, edge_polygon_read, generator_mark, comparator_mark;
  logic lists_set_first, eliminator_set_first;
  vsg_pkg::poly_ptr_t polygon_address, generator_polygon, comparator_polygon, edge_polygon, set_polygon, enter_polygon,
                      eliminator_set_polygon, changing;
  vsg_pkg::ptr_t set_segment, lists_set_segment, eliminator_set_segment, first_segment;
  assign polygon_read      = generator_polygon_read || comparator_polygon_read || edge_polygon_read;
  assign polygon_address   = edge_polygon_read ? edge_polygon :
                             generator_polygon_read ? generator_polygon : comparator_polygon;
  assign polygon_mark      = generator_mark || comparator_mark;
  assign polygon_set_first = lists_set_first || eliminator_set_first;
  assign set_polygon       = lists_set_first ? enter_polygon : eliminator_set_polygon;
  assign set_segment       = lists_set_first ? lists_set_segment : eliminator_set_segment;

  logic polygon_load, edges_clearing;
  assign polygon_ready_o = (state_q == StIdle) && !polygon_full && !edges_clearing;
  assign polygon_load    = polygon_valid_i && polygon_ready_o;

  polygon_memory u_polygon_memory (
    .clk_i, .rst_ni, .frame_start_i, .load_i(polygon_load), .load_front_i(polygon_front_i),
    .load_full_o(polygon_full), .read_i(polygon_read), .read_polygon_i(polygon_address), .mark_i(polygon_mark),
    .set_first_i(polygon_set_first), .set_polygon_i(set_polygon), .set_segment_i(set_segment), .take_i(polygon_take),
    .changing_o(changing), .front_o(polygon_front), .active_o(polygon_active), .first_segment_o(first_segment),
    .count_o(polygon_count)
  );

  logic edges_loading, bucket_read, edge_read;
  vsg_pkg::error_e edge_error, generator_error, comparator_error, decision_error;
  vsg_pkg::edge_ptr_t bucket_edge, edge_number, edge_next;
  vsg_pkg::edge_t edge_word;

  edge_memory u_edge_memory (
    .clk_i, .rst_ni, .frame_start_i, .height_i, .clearing_o(edges_clearing), .load_valid_i(edge_valid_i),
    .load_ready_o(edge_ready_o), .load_edge_i(edge_i), .loading_o(edges_loading), .error_o(edge_error),
    .polygon_read_o(edge_polygon_read), .polygon_o(edge_polygon), .polygon_front_i(polygon_front),
    .bucket_read_i(bucket_read), .bucket_line_i(line_q), .bucket_edge_o(bucket_edge), .edge_read_i(edge_read),
    .edge_number_i(edge_number), .edge_o(edge_word), .edge_next_o(edge_next), .count_o(edge_count)
  );

  // X-sort list: the segment eliminator, the depth comparator and the implied edges give commands.
  logic sort_command_valid, sort_done, eliminator_sort, comparator_sort, implied_sort, pop;
  vsg_pkg::sort_command_e sort_command, eliminator_sort_command;
  vsg_pkg::ptr_t sort_block, sort_previous, sort_next, eliminator_sort_block, comparator_sort_block, implied_sort_block,
                 sort_start_block, unlink_previous, unlink_next, front, pop_next;
  vsg_pkg::pixel_t sort_pixel, eliminator_sort_pixel, comparator_sort_pixel, implied_sort_pixel;
  assign sort_command_valid = eliminator_sort || comparator_sort || implied_sort;
  assign sort_command = eliminator_sort ? eliminator_sort_command : vsg_pkg::SortInsertNext;
  assign sort_block   = eliminator_sort ? eliminator_sort_block : implied_sort ? implied_sort_block : comparator_sort_block;
  assign sort_pixel   = eliminator_sort ? eliminator_sort_pixel : implied_sort ? implied_sort_pixel : comparator_sort_pixel;

  x_sort u_x_sort (
    .clk_i, .rst_ni, .frame_start_i, .line_start_i(line_start), .command_valid_i(sort_command_valid),
    .command_i(sort_command), .block_i(sort_block), .start_i(sort_start_block), .pixel_i(sort_pixel),
    .x_previous_i(unlink_previous), .x_next_i(unlink_next), .done_o(sort_done), .x_previous_o(sort_previous),
    .x_next_o(sort_next), .front_o(front), .pop_i(pop), .pop_next_i(pop_next), .request_o(sort_request), .word_i(word),
    .count_o(sort_count)
  );

  logic sample_read, sample_valid, sample_store, clear_samples, lists_clear_samples, implied_clear_samples;
  vsg_pkg::pixel_t sample_from, sample;
  vsg_pkg::span_t span;
  assign clear_samples = lists_clear_samples || implied_clear_samples;

  sample_list u_sample_list (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .line_start_i(line_start), .read_i(sample_read),
    .from_pixel_i(sample_from), .sample_valid_o(sample_valid), .sample_o(sample), .store_i(sample_store),
    .point_i(span.at_left), .clear_i(clear_samples), .clear_block_i(free_block), .count_o(samples_count),
    .trace_o(trace_sample_o)
  );

  // --- segment generator and eliminator

  logic generate_done, insert, insert_done, insert_full, eliminate_done;

  polygon_segment_lists u_polygon_segment_lists (
    .clk_i, .rst_ni, .insert_i(insert), .edge_i(edge_word), .polygon_i(enter_polygon), .first_segment_i(first_segment),
    .done_o(insert_done), .full_o(insert_full), .set_first_o(lists_set_first), .set_segment_o(lists_set_segment),
    .take_o(lists_take), .free_block_i(free_block), .free_fresh_i(free_fresh), .free_full_i(free_full),
    .clear_samples_o(lists_clear_samples), .request_o(lists_request), .word_i(word), .count_o(lists_count)
  );

  segment_generator u_segment_generator (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .start_i(generate_start), .done_o(generate_done),
    .error_o(generator_error), .bucket_read_o(bucket_read), .bucket_edge_i(bucket_edge), .edge_read_o(edge_read),
    .edge_number_o(edge_number), .edge_i(edge_word), .edge_next_i(edge_next), .polygon_read_o(generator_polygon_read),
    .polygon_o(generator_polygon), .polygon_mark_o(generator_mark), .polygon_front_i(polygon_front),
    .polygon_active_i(polygon_active), .enter_polygon_o(enter_polygon), .insert_o(insert), .insert_done_i(insert_done),
    .insert_full_i(insert_full), .count_o(generator_count), .trace_o(trace_edge_o)
  );

  segment_eliminator u_segment_eliminator (
    .clk_i, .rst_ni, .frame_start_i, .start_i(eliminate_start), .done_o(eliminate_done), .take_o(polygon_take),
    .changing_i(changing), .first_segment_i(first_segment), .set_first_o(eliminator_set_first),
    .set_polygon_o(eliminator_set_polygon), .set_segment_o(eliminator_set_segment), .return_o(eliminator_return),
    .returned_o(eliminator_returned), .sort_o(eliminator_sort), .sort_command_o(eliminator_sort_command),
    .sort_block_o(eliminator_sort_block), .sort_start_o(sort_start_block), .sort_pixel_o(eliminator_sort_pixel),
    .unlink_previous_o(unlink_previous), .unlink_next_o(unlink_next), .sort_done_i(sort_done),
    .sort_previous_i(sort_previous), .sort_next_i(sort_next), .request_o(eliminator_request), .word_i(word),
    .count_o(eliminator_count)
  );

  // --- depth sorter

  logic span_start, active_remove, active_add, active_add_ending, restore, implied_line_done, crossing, crossing_done,
        crossing_full;
  vsg_pkg::ptr_t active_first, active_previous, active_next, active_block, active_link;

  active_list u_active_list (
    .clk_i, .rst_ni, .line_start_i(line_start), .span_start_i(span_start), .first_o(active_first),
    .remove_i(active_remove), .remove_previous_i(active_previous), .remove_next_i(active_next), .add_i(active_add),
    .add_ending_i(active_add_ending), .add_block_i(active_block), .link_o(active_link), .restore_i(restore),
    .request_o(active_request), .count_o(active_count)
  );

  vsg_pkg::x_t crossing_x;
  vsg_pkg::box_t box;
  vsg_pkg::sample_point_t implied_point, left_point, right_point, decided_point;
  logic last_lines;
  assign last_lines = (line_q + 1'b1 == height_i);

  implied_edges u_implied_edges (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .last_lines_i(last_lines), .line_start_i(sort_start),
    .line_done_o(implied_line_done), .crossing_i(crossing), .left_i(box.front), .right_i(box.other), .x_i(crossing_x),
    .done_o(crossing_done), .full_o(crossing_full), .point_o(implied_point), .take_o(implied_take),
    .free_block_i(free_block), .free_fresh_i(free_fresh), .free_full_i(free_full), .return_o(implied_return),
    .returned_o(implied_returned), .clear_samples_o(implied_clear_samples), .sort_o(implied_sort),
    .sort_block_o(implied_sort_block), .sort_pixel_o(implied_sort_pixel), .sort_done_i(sort_done),
    .sort_previous_i(sort_previous), .sort_next_i(sort_next), .request_o(implied_request), .word_i(word),
    .count_o(implied_count)
  );

  logic span_done, set_left, set_right, clear_left, set_implied, subdivide;
  vsg_pkg::pixel_t new_right;

  sample_space_generator u_sample_space_generator (
    .clk_i, .rst_ni, .line_start_i(line_start), .next_i(span_next), .done_o(span_done), .read_o(sample_read),
    .from_pixel_o(sample_from), .sample_valid_i(sample_valid), .sample_i(sample), .set_left_i(set_left),
    .left_point_i(left_point), .set_right_i(set_right), .right_point_i(right_point), .clear_left_i(clear_left),
    .set_implied_i(set_implied), .implied_point_i(decided_point), .subdivide_i(subdivide), .new_right_i(new_right),
    .span_o(span)
  );

  logic compare_done, find_crossing, crossing_found;

  depth_comparator u_depth_comparator (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .sort_i(compare_start), .sort_done_o(compare_done),
    .error_o(comparator_error), .intersect_i(find_crossing), .intersect_done_o(crossing_found), .crossing_o(crossing_x),
    .box_o(box), .span_i(span), .set_left_o(set_left), .left_point_o(left_point), .set_right_o(set_right),
    .right_point_o(right_point), .active_span_start_o(span_start), .active_first_i(active_first),
    .active_remove_o(active_remove), .active_previous_o(active_previous), .active_next_o(active_next),
    .active_add_o(active_add), .active_add_ending_o(active_add_ending), .active_block_o(active_block),
    .active_link_i(active_link), .front_i(front), .pop_o(pop), .pop_next_o(pop_next), .sort_next_o(comparator_sort),
    .sort_block_o(comparator_sort_block), .sort_pixel_o(comparator_sort_pixel), .sort_next_done_i(sort_done),
    .sort_previous_i(sort_previous), .sort_following_i(sort_next), .return_o(comparator_return),
    .returned_o(comparator_returned), .polygon_read_o(comparator_polygon_read), .polygon_o(comparator_polygon),
    .polygon_mark_o(comparator_mark), .polygon_active_i(polygon_active), .request_o(comparator_request),
    .word_i(word), .count_o(comparator_count), .trace_o(trace_test_o)
  );

  logic decided, again, finished;

  decision_processor u_decision_processor (
    .clk_i, .rst_ni, .frame_start_i, .line_start_i(line_start), .line_i(line_q), .decide_i(decide_start),
    .decided_o(decided), .again_o(again), .finish_line_i(finish_start), .finished_o(finished),
    .error_o(decision_error), .box_i(box), .intersect_o(find_crossing), .intersect_done_i(crossing_found),
    .crossing_i(crossing_x), .span_i(span), .clear_left_o(clear_left), .set_implied_o(set_implied),
    .implied_point_o(decided_point), .subdivide_o(subdivide), .new_right_o(new_right), .restore_o(restore),
    .implied_o(crossing), .implied_done_i(crossing_done), .implied_full_i(crossing_full),
    .implied_point_i(implied_point), .store_o(sample_store), .valid_o(segment_valid_o), .ready_i(segment_ready_i),
    .segment_o, .count_o(decision_count), .trace_o(trace_decision_o)
  );

  tally u_tally (
    .clk_i, .rst_ni, .frame_start_i, .count_i(count), .port_access_i(request.valid), .select_i(counter_select_i),
    .counter_o, .trace_o(trace_counters_o)
  );

  // --- control (figure 10)

  vsg_pkg::error_e block_error;
  always_comb begin
    block_error = vsg_pkg::ErrorNone;
    if (edge_error != vsg_pkg::ErrorNone) block_error = edge_error;
    if (polygon_valid_i && polygon_full && state_q == StIdle) block_error = vsg_pkg::ErrorPolygonMemoryFull;
    if (generator_error != vsg_pkg::ErrorNone) block_error = generator_error;
    if (comparator_error != vsg_pkg::ErrorNone) block_error = comparator_error;
    if (decision_error != vsg_pkg::ErrorNone) block_error = decision_error;
  end

  always_comb begin
    state_d = state_q;
    line_d  = line_q;
    spans_d = spans_q;
    error_d = error_q;
    line_start      = 1'b0;
    generate_start  = 1'b0;
    eliminate_start = 1'b0;
    sort_start      = 1'b0;
    span_next       = 1'b0;
    compare_start   = 1'b0;
    decide_start    = 1'b0;
    finish_start    = 1'b0;
    done_o          = 1'b0;
    trace_phase_o   = '0;
    case (state_q)
      StIdle: begin
        line_d = '0;
        if (run_i && !loading_o && block_error == vsg_pkg::ErrorNone) begin
          line_d[0] = 1'b1;
          state_d   = StLine;
        end
      end
      StLine: begin
        trace_phase_o.line_started = 1'b1;
        line_start     = 1'b1;
        generate_start = 1'b1;
        spans_d        = '0;
        state_d        = StGenerate;
      end
      StGenerate: begin
        if (generate_done) begin
          eliminate_start = 1'b1;
          state_d         = StEliminate;
        end
      end
      StEliminate: begin
        if (eliminate_done) begin
          sort_start = 1'b1;
          state_d    = StSort;
        end
      end
      StSort: begin
        // Nothing that implied edges count before they are done is part of scan preparation.
        trace_phase_o.sort_started = sort_started_q;
        if (implied_line_done) state_d = StSpan;
      end
      StSpan: begin
        span_next = 1'b1;
        state_d   = StSpanWait;
      end
      StSpanWait: begin
        if (span_done) begin
          compare_start = 1'b1;
          spans_d       = spans_q + 1'b1;
          state_d       = StCompare;
        end
      end
      StCompare: begin
        if (compare_done) begin
          decide_start = 1'b1;
          state_d      = StDecide;
        end
      end
      StDecide: begin
        if (decided && again) begin
          state_d = StCompareAgain;
        end else if (decided) begin
          state_d = (span.right == width) ? StFinish : StSpan;
        end
      end
      StCompareAgain: begin
        compare_start = 1'b1;
        spans_d       = spans_q + 1'b1;
        state_d       = StCompare;
        if (spans_q == {width_i, {SpanShift{1'b0}}}) begin
          compare_start = 1'b0;
          error_d       = vsg_pkg::ErrorTooManySpans;
          state_d       = StError;
        end
      end
      StFinish: begin
        finish_start = 1'b1;
        if (finished) state_d = StLineDone;
      end
      StLineDone: begin
        trace_phase_o.line_finished = 1'b1;
        line_d                      = line_q + 1'b1;
        state_d                     = StLine;
        if (line_q == height_i) begin
          done_o  = 1'b1;
          state_d = StIdle;
        end
      end
      default: ;  // StError
    endcase
    if (block_error != vsg_pkg::ErrorNone && state_q != StError) begin
      error_d = block_error;
      state_d = StError;
    end
    if (frame_start_i) begin
      state_d = StIdle;
      error_d = vsg_pkg::ErrorNone;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q        <= StIdle;
      line_q         <= '0;
      spans_q        <= '0;
      error_q        <= vsg_pkg::ErrorNone;
      sort_started_q <= 1'b0;
    end else begin
      state_q        <= state_d;
      line_q         <= line_d;
      spans_q        <= spans_d;
      error_q        <= error_d;
      sort_started_q <= sort_start;
    end
  end

  assign loading_o = edges_clearing || edges_loading;
  assign running_o = (state_q != StIdle) && (state_q != StError);
  assign error_o   = error_q;
  assign line_o    = line_q;

endmodule
