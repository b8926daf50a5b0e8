// The Depth Sorter's blocks and the tally, each alone, with their ports spread out for the C++ testbenches. Simulation only.

module sorter_bench (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  frame_start_i,
  input  logic [31:0]           width_i,
  input  bench_pkg::span_t      span_i,
  // clip quadrant
  input  logic                  quadrant_load_i,
  input  logic [63:0]           quadrant_x_left_i,
  input  logic [63:0]           quadrant_x_right_i,
  input  logic [63:0]           quadrant_z_min_i,
  input  logic [63:0]           quadrant_z_max_i,
  input  logic                  quadrant_rising_i,
  input  logic                  quadrant_step_i,
  output logic [63:0]           quadrant_z_min_o,
  output logic [63:0]           quadrant_z_max_o,
  output logic                  quadrant_rising_o,
  // clip verdict: new left <=, >=, right <=, >=, behind at the left: new, old, at the right: new, old, exhausted
  input  logic [8:0]            verdict_i,
  output logic [31:0]           verdict_o,
  // box growth; relations: same, left <=, right >=, new rising, old rising, behind at the left: new, old, right: new, old
  input  bench_pkg::box_t       growth_box_i,
  input  bench_pkg::candidate_t growth_candidate_i,
  input  logic [31:0]           growth_left_i,
  input  logic [31:0]           growth_right_i,
  input  logic [8:0]            growth_relations_i,
  input  logic [7:0][63:0]      growth_z_i,  // minimum, maximum: new left, new right, old left, old right
  output bench_pkg::box_t       growth_box_o,
  // clipping unit
  input  logic                  clip_clear_i,
  input  logic                  clip_start_i,
  input  bench_pkg::candidate_t clip_candidate_i,
  input  logic                  clip_from_x_sort_i,
  input  logic                  clip_searching_i,
  output logic                  clip_done_o,
  input  logic                  clip_account_i,
  output logic [31:0]           clip_add_cycles_o,
  output logic [63:0]           clip_crossing_o,
  output bench_pkg::box_t       clip_box_o,
  output logic [31:0]           clip_outcome_o,
  // depth comparator
  input  logic                  comparator_sort_i,
  output logic                  comparator_sort_done_o,
  output logic [31:0]           comparator_error_o,
  input  logic                  comparator_intersect_i,
  output logic                  comparator_intersect_done_o,
  output logic [63:0]           comparator_crossing_o,
  output bench_pkg::box_t       comparator_box_o,
  output logic                  set_left_o,
  output bench_pkg::point_t     left_point_o,
  output logic                  set_right_o,
  output bench_pkg::point_t     right_point_o,
  output logic                  active_span_start_o,
  input  logic [31:0]           active_first_i,
  output logic                  active_remove_o,
  output logic [31:0]           active_previous_o,
  output logic [31:0]           active_next_o,
  output logic                  active_add_o,
  output logic                  active_add_ending_o,
  output logic [31:0]           active_block_o,
  input  logic [31:0]           active_link_i,
  input  logic [31:0]           front_i,
  output logic                  pop_o,
  output logic [31:0]           pop_next_o,
  output logic                  sort_next_o,
  output logic [31:0]           sort_block_o,
  output logic [31:0]           sort_pixel_o,
  input  logic                  sort_done_i,
  input  logic [31:0]           sort_previous_i,
  input  logic [31:0]           sort_following_i,
  output logic                  return_o,
  output logic [31:0]           returned_o,
  output logic                  polygon_read_o,
  output logic [31:0]           polygon_o,
  output logic                  polygon_mark_o,
  input  logic                  polygon_active_i,
  output bench_pkg::request_t   request_o,
  input  bench_pkg::word_t      word_i,
  output logic                  test_o,
  output logic [31:0]           test_block_o,
  output logic                  test_from_x_sort_o,
  output logic                  test_intersecting_o,
  output logic [31:0]           test_outcome_o,
  output logic [31:0]           test_add_cycles_o,
  output bench_pkg::box_t       test_box_o,
  output bench_pkg::span_t      test_span_o,
  output bench_pkg::counts_t    comparator_count_o,
  // decision processor
  input  logic                  line_start_i,
  input  logic [31:0]           line_i,
  input  logic                  decide_i,
  output logic                  decided_o,
  output logic                  again_o,
  input  logic                  finish_line_i,
  output logic                  finished_o,
  output logic [31:0]           decision_error_o,
  input  bench_pkg::box_t       decision_box_i,
  output logic                  intersect_o,
  input  logic                  intersect_done_i,
  input  logic [63:0]           crossing_i,
  output logic                  clear_left_o,
  output logic                  set_implied_o,
  output bench_pkg::point_t     implied_point_o,
  output logic                  subdivide_o,
  output logic [31:0]           new_right_o,
  output logic                  restore_o,
  output logic                  implied_o,
  input  logic                  implied_done_i,
  input  logic                  implied_full_i,
  input  bench_pkg::point_t     implied_point_i,
  output logic                  store_o,
  output logic                  valid_o,
  input  logic                  ready_i,
  output logic [31:0]           segment_y_o,
  output logic [31:0]           segment_x_end_o,
  output logic [31:0]           segment_polygon_o,
  output logic                  decision_o,
  output logic [31:0]           decision_kind_o,
  output logic [31:0]           decision_segments_o,
  output logic [31:0]           decision_new_right_o,
  output bench_pkg::span_t      decision_span_o,
  output bench_pkg::counts_t    decision_count_o,
  // tally
  input  bench_pkg::counts_t    tally_count_i,
  input  logic                  tally_port_access_i,
  input  logic [5:0]            tally_select_i,
  output logic [31:0]           tally_counter_o,
  output vsg_pkg::counters_t    tally_counters_o
);

  vsg_pkg::span_t span;
  vsg_pkg::pixel_t width;
  assign span  = bench_pkg::make_span(span_i);
  assign width = width_i[vsg_pkg::IntegerBits-1:0];

  vsg_pkg::z_t quadrant_z_min, quadrant_z_max;
  clip_quadrant u_clip_quadrant (
    .clk_i, .rst_ni, .load_i(quadrant_load_i), .x_left_i(quadrant_x_left_i[vsg_pkg::XW-1:0]),
    .x_right_i(quadrant_x_right_i[vsg_pkg::XW-1:0]), .z_min_i(quadrant_z_min_i[vsg_pkg::ZW-1:0]),
    .z_max_i(quadrant_z_max_i[vsg_pkg::ZW-1:0]), .rising_i(quadrant_rising_i), .step_i(quadrant_step_i),
    .z_min_o(quadrant_z_min), .z_max_o(quadrant_z_max), .rising_o(quadrant_rising_o)
  );
  assign quadrant_z_min_o = 64'(quadrant_z_min);
  assign quadrant_z_max_o = 64'(quadrant_z_max);

  vsg_pkg::verdict_e verdict;
  clip_verdict u_clip_verdict (
    .new_left_le_i(verdict_i[0]), .new_left_ge_i(verdict_i[1]), .new_right_le_i(verdict_i[2]),
    .new_right_ge_i(verdict_i[3]), .new_behind_left_i(verdict_i[4]), .old_behind_left_i(verdict_i[5]),
    .new_behind_right_i(verdict_i[6]), .old_behind_right_i(verdict_i[7]), .exhausted_i(verdict_i[8]),
    .verdict_o(verdict)
  );
  assign verdict_o = 32'(verdict);

  vsg_pkg::box_t grown;
  box_growth u_box_growth (
    .box_i(bench_pkg::make_box(growth_box_i)), .candidate_i(bench_pkg::make_candidate(growth_candidate_i)),
    .left_i(growth_left_i[vsg_pkg::IntegerBits-1:0]), .right_i(growth_right_i[vsg_pkg::IntegerBits-1:0]),
    .same_i(growth_relations_i[0]), .left_le_i(growth_relations_i[1]), .right_ge_i(growth_relations_i[2]),
    .new_left_min_i(growth_z_i[0][vsg_pkg::ZW-1:0]), .new_left_max_i(growth_z_i[1][vsg_pkg::ZW-1:0]),
    .new_right_min_i(growth_z_i[2][vsg_pkg::ZW-1:0]), .new_right_max_i(growth_z_i[3][vsg_pkg::ZW-1:0]),
    .old_left_min_i(growth_z_i[4][vsg_pkg::ZW-1:0]), .old_left_max_i(growth_z_i[5][vsg_pkg::ZW-1:0]),
    .old_right_min_i(growth_z_i[6][vsg_pkg::ZW-1:0]), .old_right_max_i(growth_z_i[7][vsg_pkg::ZW-1:0]),
    .new_rising_i(growth_relations_i[3]), .old_rising_i(growth_relations_i[4]),
    .new_behind_left_i(growth_relations_i[5]), .old_behind_left_i(growth_relations_i[6]),
    .new_behind_right_i(growth_relations_i[7]), .old_behind_right_i(growth_relations_i[8]), .box_o(grown)
  );
  assign growth_box_o = bench_pkg::spread_box(grown);

  logic [vsg_pkg::AddW-1:0] add_cycles;
  vsg_pkg::x_t clip_crossing;
  vsg_pkg::box_t clip_box;
  vsg_pkg::trace_test_t clip_trace, test;
  clipping_unit u_clipping_unit (
    .clk_i, .rst_ni, .frame_start_i, .clear_i(clip_clear_i), .start_i(clip_start_i),
    .candidate_i(bench_pkg::make_candidate(clip_candidate_i)), .from_x_sort_i(clip_from_x_sort_i),
    .searching_i(clip_searching_i), .done_o(clip_done_o), .account_i(clip_account_i), .add_cycles_o(add_cycles),
    .crossing_o(clip_crossing), .span_i(span), .box_o(clip_box), .trace_o(clip_trace)
  );
  assign clip_add_cycles_o = 32'(add_cycles);
  assign clip_crossing_o   = 64'(clip_crossing);
  assign clip_box_o        = bench_pkg::spread_box(clip_box);
  assign clip_outcome_o    = 32'(clip_trace.outcome);

  vsg_pkg::error_e comparator_error, decision_error;
  vsg_pkg::x_t crossing;
  vsg_pkg::box_t box;
  vsg_pkg::sample_point_t left_point, right_point, implied_point;
  vsg_pkg::ptr_t active_previous, active_next, active_block, pop_next, sort_block, returned;
  vsg_pkg::pixel_t sort_pixel, new_right;
  vsg_pkg::poly_ptr_t polygon;
  vsg_pkg::memory_request_t request;
  vsg_pkg::count_t comparator_count, decision_count;
  depth_comparator u_depth_comparator (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .sort_i(comparator_sort_i), .sort_done_o(comparator_sort_done_o),
    .error_o(comparator_error), .intersect_i(comparator_intersect_i), .intersect_done_o(comparator_intersect_done_o),
    .crossing_o(crossing), .box_o(box), .span_i(span), .set_left_o, .left_point_o(left_point), .set_right_o,
    .right_point_o(right_point), .active_span_start_o, .active_first_i(active_first_i[vsg_pkg::PtrW-1:0]),
    .active_remove_o, .active_previous_o(active_previous), .active_next_o(active_next), .active_add_o,
    .active_add_ending_o, .active_block_o(active_block), .active_link_i(active_link_i[vsg_pkg::PtrW-1:0]),
    .front_i(front_i[vsg_pkg::PtrW-1:0]), .pop_o, .pop_next_o(pop_next), .sort_next_o, .sort_block_o(sort_block),
    .sort_pixel_o(sort_pixel), .sort_next_done_i(sort_done_i), .sort_previous_i(sort_previous_i[vsg_pkg::PtrW-1:0]),
    .sort_following_i(sort_following_i[vsg_pkg::PtrW-1:0]), .return_o, .returned_o(returned), .polygon_read_o,
    .polygon_o(polygon), .polygon_mark_o, .polygon_active_i, .request_o(request),
    .word_i(bench_pkg::make_word(word_i)), .count_o(comparator_count), .trace_o(test)
  );
  assign comparator_error_o    = 32'(comparator_error);
  assign comparator_crossing_o = 64'(crossing);
  assign comparator_box_o      = bench_pkg::spread_box(box);
  assign left_point_o          = bench_pkg::spread_point(left_point);
  assign right_point_o         = bench_pkg::spread_point(right_point);
  assign active_previous_o     = 32'(active_previous);
  assign active_next_o         = 32'(active_next);
  assign active_block_o        = 32'(active_block);
  assign pop_next_o            = 32'(pop_next);
  assign sort_block_o          = 32'(sort_block);
  assign sort_pixel_o          = 32'(sort_pixel);
  assign returned_o            = 32'(returned);
  assign polygon_o             = 32'(polygon);
  assign request_o             = bench_pkg::spread_request(request);
  assign test_o                = test.valid;
  assign test_block_o          = 32'(test.block);
  assign test_from_x_sort_o    = test.from_x_sort;
  assign test_intersecting_o   = test.intersecting;
  assign test_outcome_o        = 32'(test.outcome);
  assign test_add_cycles_o     = 32'(test.add_cycles);
  assign test_box_o            = bench_pkg::spread_box(test.box);
  assign test_span_o           = bench_pkg::spread_span(test.span);
  assign comparator_count_o    = bench_pkg::spread_counts(comparator_count);

  vsg_pkg::visible_segment_t segment;
  vsg_pkg::trace_decision_t decision;
  decision_processor u_decision_processor (
    .clk_i, .rst_ni, .frame_start_i, .line_start_i, .line_i(line_i[vsg_pkg::CoordW-1:0]), .decide_i, .decided_o,
    .again_o, .finish_line_i, .finished_o, .error_o(decision_error), .box_i(bench_pkg::make_box(decision_box_i)),
    .intersect_o, .intersect_done_i, .crossing_i(crossing_i[vsg_pkg::XW-1:0]), .span_i(span), .clear_left_o,
    .set_implied_o, .implied_point_o(implied_point), .subdivide_o, .new_right_o(new_right), .restore_o, .implied_o,
    .implied_done_i, .implied_full_i, .implied_point_i(bench_pkg::make_point(implied_point_i)), .store_o, .valid_o,
    .ready_i, .segment_o(segment), .count_o(decision_count), .trace_o(decision)
  );
  assign decision_error_o     = 32'(decision_error);
  assign implied_point_o      = bench_pkg::spread_point(implied_point);
  assign new_right_o          = 32'(new_right);
  assign segment_y_o          = 32'(segment.y);
  assign segment_x_end_o      = 32'(segment.x_end);
  assign segment_polygon_o    = 32'(segment.polygon);
  assign decision_o           = decision.valid;
  assign decision_kind_o      = 32'(decision.decision);
  assign decision_segments_o  = 32'(decision.segments);
  assign decision_new_right_o = 32'(decision.new_right);
  assign decision_span_o      = bench_pkg::spread_span(decision.span);
  assign decision_count_o     = bench_pkg::spread_counts(decision_count);

  tally u_tally (
    .clk_i, .rst_ni, .frame_start_i, .count_i(bench_pkg::make_counts(tally_count_i)),
    .port_access_i(tally_port_access_i), .select_i(tally_select_i), .counter_o(tally_counter_o),
    .trace_o(tally_counters_o)
  );

endmodule
