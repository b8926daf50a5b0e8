// The blocks that keep lists in segment memory, each alone: only one is given commands in a test, the others stay idle
// and drive zeros, so they share the memory port and the counts as in the machine. Ports are spread out for the C++
// testbenches. Simulation only.

module lists_bench (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                frame_start_i,
  input  logic                line_start_i,
  input  logic [31:0]         width_i,
  // segment memory and tally
  output bench_pkg::request_t request_o,
  input  bench_pkg::word_t    word_i,
  output bench_pkg::counts_t  count_o,
  // free list, for those that take and return blocks
  output logic                take_o,
  input  logic [31:0]         free_block_i,
  input  logic                free_fresh_i,
  input  logic                free_full_i,
  output logic                clear_samples_o,
  output logic                return_o,
  output logic [31:0]         returned_o,
  // X-sort list, as the others command it
  output logic                sort_o,
  output logic [31:0]         sort_command_o,
  output logic [31:0]         sort_block_o,
  output logic [31:0]         sort_start_o,
  output logic [31:0]         sort_pixel_o,
  output logic [31:0]         unlink_previous_o,
  output logic [31:0]         unlink_next_o,
  input  logic                sort_done_i,
  input  logic [31:0]         sort_previous_i,
  input  logic [31:0]         sort_next_i,
  // X-sort list itself
  input  logic                x_command_valid_i,
  input  logic [31:0]         x_command_i,
  input  logic [31:0]         x_block_i,
  input  logic [31:0]         x_start_i,
  input  logic [31:0]         x_pixel_i,
  input  logic [31:0]         x_previous_i,
  input  logic [31:0]         x_next_i,
  output logic                x_done_o,
  output logic [31:0]         x_previous_o,
  output logic [31:0]         x_next_o,
  output logic [31:0]         x_front_o,
  input  logic                x_pop_i,
  input  logic [31:0]         x_pop_next_i,
  // sample list
  input  logic                sample_read_i,
  input  logic [31:0]         sample_from_i,
  output logic                sample_valid_o,
  output logic [31:0]         sample_o,
  input  logic                sample_store_i,
  input  bench_pkg::point_t   sample_point_i,
  input  logic                sample_clear_i,
  input  logic [31:0]         sample_clear_block_i,
  output logic                sample_trace_o,
  output bench_pkg::point_t   sample_trace_point_o,
  // polygon segment lists, with the edge that the segment generator reads as well
  input  logic                lists_insert_i,
  input  logic [31:0]         lists_polygon_i,
  output logic                lists_done_o,
  output logic                lists_full_o,
  input  logic [31:0]         edge_first_polygon_i,
  input  logic [31:0]         edge_second_polygon_i,
  input  logic [31:0]         edge_lines_i,
  input  logic [63:0]         edge_x_i,
  input  logic [63:0]         edge_dx_i,
  input  logic [63:0]         edge_z_i,
  input  logic [63:0]         edge_dz_i,
  // polygon memory
  input  logic [31:0]         first_segment_i,
  output logic                set_first_o,
  output logic [31:0]         set_polygon_o,
  output logic [31:0]         set_segment_o,
  // segment generator
  input  logic                generator_start_i,
  output logic                generator_done_o,
  output logic [31:0]         generator_error_o,
  output logic                bucket_read_o,
  input  logic [31:0]         bucket_edge_i,
  output logic                edge_read_o,
  output logic [31:0]         edge_number_o,
  input  logic [31:0]         edge_next_i,
  output logic                polygon_read_o,
  output logic [31:0]         polygon_o,
  output logic                polygon_mark_o,
  input  logic                polygon_front_i,
  input  logic                polygon_active_i,
  output logic [31:0]         enter_polygon_o,
  output logic                insert_o,
  input  logic                insert_done_i,
  input  logic                insert_full_i,
  output logic                taken_o,
  output logic [31:0]         taken_number_o,
  output logic [31:0]         taken_polygon_o,
  output logic [63:0]         taken_x_o,
  // segment eliminator
  input  logic                eliminator_start_i,
  output logic                eliminator_done_o,
  output logic                polygon_take_o,
  input  logic [31:0]         changing_i,
  // active list
  input  logic                active_span_start_i,
  output logic [31:0]         active_first_o,
  input  logic                active_remove_i,
  input  logic [31:0]         active_remove_previous_i,
  input  logic [31:0]         active_remove_next_i,
  input  logic                active_add_i,
  input  logic                active_add_ending_i,
  input  logic [31:0]         active_add_block_i,
  output logic [31:0]         active_link_o,
  input  logic                active_restore_i,
  // implied edges
  input  logic                implied_last_lines_i,
  input  logic                implied_line_start_i,
  output logic                implied_line_done_o,
  input  logic                implied_crossing_i,
  input  logic [31:0]         implied_left_i,
  input  logic [31:0]         implied_right_i,
  input  logic [63:0]         implied_x_i,
  output logic                implied_done_o,
  output logic                implied_full_o,
  output bench_pkg::point_t   implied_point_o,
  // sample space generator
  input  logic                space_next_i,
  output logic                space_done_o,
  output logic                space_read_o,
  output logic [31:0]         space_from_o,
  input  logic                space_sample_valid_i,
  input  logic [31:0]         space_sample_i,
  input  logic                space_set_left_i,
  input  bench_pkg::point_t   space_left_point_i,
  input  logic                space_set_right_i,
  input  bench_pkg::point_t   space_right_point_i,
  input  logic                space_clear_left_i,
  input  logic                space_set_implied_i,
  input  bench_pkg::point_t   space_implied_point_i,
  input  logic                space_subdivide_i,
  input  logic [31:0]         space_new_right_i,
  output bench_pkg::span_t    space_span_o
);

  vsg_pkg::pixel_t width;
  vsg_pkg::segment_t word;
  vsg_pkg::memory_request_t sort_request, lists_request, eliminator_request, active_request, implied_request;
  vsg_pkg::count_t sort_count, samples_count, lists_count, generator_count, eliminator_count, active_count,
                   implied_count;
  assign width     = width_i[vsg_pkg::IntegerBits-1:0];
  assign word      = bench_pkg::make_word(word_i);
  assign request_o = bench_pkg::spread_request(sort_request | lists_request | eliminator_request | active_request |
                                               implied_request);
  assign count_o   = bench_pkg::spread_counts(sort_count | samples_count | lists_count | generator_count |
                                              eliminator_count | active_count | implied_count);

  vsg_pkg::ptr_t free_block, sort_previous, sort_next;
  assign free_block    = free_block_i[vsg_pkg::PtrW-1:0];
  assign sort_previous = sort_previous_i[vsg_pkg::PtrW-1:0];
  assign sort_next     = sort_next_i[vsg_pkg::PtrW-1:0];

  vsg_pkg::edge_t edge_block;
  always_comb begin
    edge_block                = '0;
    edge_block.first_polygon  = edge_first_polygon_i[vsg_pkg::PolyW-1:0];
    edge_block.second_polygon = edge_second_polygon_i[vsg_pkg::PolyW-1:0];
    edge_block.lines          = edge_lines_i[vsg_pkg::CoordW-1:0];
    edge_block.x              = edge_x_i[vsg_pkg::XW-1:0];
    edge_block.dx             = edge_dx_i[vsg_pkg::XW-1:0];
    edge_block.z              = edge_z_i[vsg_pkg::ZW-1:0];
    edge_block.dz             = edge_dz_i[vsg_pkg::ZW-1:0];
  end

  vsg_pkg::ptr_t x_previous, x_next, front;
  x_sort u_x_sort (
    .clk_i, .rst_ni, .frame_start_i, .line_start_i, .command_valid_i(x_command_valid_i),
    .command_i(vsg_pkg::sort_command_e'(x_command_i[1:0])), .block_i(x_block_i[vsg_pkg::PtrW-1:0]),
    .start_i(x_start_i[vsg_pkg::PtrW-1:0]), .pixel_i(x_pixel_i[vsg_pkg::IntegerBits-1:0]),
    .x_previous_i(x_previous_i[vsg_pkg::PtrW-1:0]), .x_next_i(x_next_i[vsg_pkg::PtrW-1:0]), .done_o(x_done_o),
    .x_previous_o(x_previous), .x_next_o(x_next), .front_o(front), .pop_i(x_pop_i),
    .pop_next_i(x_pop_next_i[vsg_pkg::PtrW-1:0]), .request_o(sort_request), .word_i(word), .count_o(sort_count)
  );
  assign x_previous_o = 32'(x_previous);
  assign x_next_o     = 32'(x_next);
  assign x_front_o    = 32'(front);

  vsg_pkg::pixel_t sample;
  vsg_pkg::trace_sample_t sample_trace;
  sample_list u_sample_list (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .line_start_i, .read_i(sample_read_i),
    .from_pixel_i(sample_from_i[vsg_pkg::IntegerBits-1:0]), .sample_valid_o, .sample_o(sample),
    .store_i(sample_store_i), .point_i(bench_pkg::make_point(sample_point_i)), .clear_i(sample_clear_i),
    .clear_block_i(sample_clear_block_i[vsg_pkg::PtrW-1:0]), .count_o(samples_count), .trace_o(sample_trace)
  );
  assign sample_o             = 32'(sample);
  assign sample_trace_o       = sample_trace.valid;
  assign sample_trace_point_o = bench_pkg::spread_point(sample_trace.point);

  logic lists_take, lists_clear, lists_set_first;
  vsg_pkg::ptr_t lists_set_segment;
  polygon_segment_lists u_polygon_segment_lists (
    .clk_i, .rst_ni, .insert_i(lists_insert_i), .edge_i(edge_block), .polygon_i(lists_polygon_i[vsg_pkg::PolyW-1:0]),
    .first_segment_i(first_segment_i[vsg_pkg::PtrW-1:0]), .done_o(lists_done_o), .full_o(lists_full_o),
    .set_first_o(lists_set_first), .set_segment_o(lists_set_segment), .take_o(lists_take), .free_block_i(free_block),
    .free_fresh_i, .free_full_i, .clear_samples_o(lists_clear), .request_o(lists_request), .word_i(word),
    .count_o(lists_count)
  );

  vsg_pkg::error_e generator_error;
  vsg_pkg::edge_ptr_t edge_number;
  vsg_pkg::poly_ptr_t polygon, enter_polygon;
  vsg_pkg::trace_edge_t taken;
  segment_generator u_segment_generator (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .start_i(generator_start_i), .done_o(generator_done_o),
    .error_o(generator_error), .bucket_read_o, .bucket_edge_i(bucket_edge_i[vsg_pkg::EdgeW-1:0]), .edge_read_o,
    .edge_number_o(edge_number), .edge_i(edge_block), .edge_next_i(edge_next_i[vsg_pkg::EdgeW-1:0]), .polygon_read_o,
    .polygon_o(polygon), .polygon_mark_o, .polygon_front_i, .polygon_active_i, .enter_polygon_o(enter_polygon),
    .insert_o, .insert_done_i, .insert_full_i, .count_o(generator_count), .trace_o(taken)
  );
  assign generator_error_o = 32'(generator_error);
  assign edge_number_o     = 32'(edge_number);
  assign polygon_o         = 32'(polygon);
  assign enter_polygon_o   = 32'(enter_polygon);
  assign taken_o           = taken.valid;
  assign taken_number_o    = 32'(taken.number);
  assign taken_polygon_o   = 32'(taken.polygon);
  assign taken_x_o         = 64'(taken.x);

  logic eliminator_set_first, eliminator_return, eliminator_sort;
  vsg_pkg::poly_ptr_t eliminator_set_polygon;
  vsg_pkg::ptr_t eliminator_set_segment, eliminator_returned, eliminator_sort_block, sort_start, unlink_previous,
                 unlink_next;
  vsg_pkg::sort_command_e sort_command;
  vsg_pkg::pixel_t eliminator_sort_pixel;
  segment_eliminator u_segment_eliminator (
    .clk_i, .rst_ni, .frame_start_i, .start_i(eliminator_start_i), .done_o(eliminator_done_o),
    .take_o(polygon_take_o), .changing_i(changing_i[vsg_pkg::PolyW-1:0]),
    .first_segment_i(first_segment_i[vsg_pkg::PtrW-1:0]), .set_first_o(eliminator_set_first),
    .set_polygon_o(eliminator_set_polygon), .set_segment_o(eliminator_set_segment), .return_o(eliminator_return),
    .returned_o(eliminator_returned), .sort_o(eliminator_sort), .sort_command_o(sort_command),
    .sort_block_o(eliminator_sort_block), .sort_start_o(sort_start), .sort_pixel_o(eliminator_sort_pixel),
    .unlink_previous_o(unlink_previous), .unlink_next_o(unlink_next), .sort_done_i, .sort_previous_i(sort_previous),
    .sort_next_i(sort_next), .request_o(eliminator_request), .word_i(word), .count_o(eliminator_count)
  );

  vsg_pkg::ptr_t active_first, active_link;
  active_list u_active_list (
    .clk_i, .rst_ni, .line_start_i, .span_start_i(active_span_start_i), .first_o(active_first),
    .remove_i(active_remove_i), .remove_previous_i(active_remove_previous_i[vsg_pkg::PtrW-1:0]),
    .remove_next_i(active_remove_next_i[vsg_pkg::PtrW-1:0]), .add_i(active_add_i),
    .add_ending_i(active_add_ending_i), .add_block_i(active_add_block_i[vsg_pkg::PtrW-1:0]), .link_o(active_link),
    .restore_i(active_restore_i), .request_o(active_request), .count_o(active_count)
  );
  assign active_first_o = 32'(active_first);
  assign active_link_o  = 32'(active_link);

  vsg_pkg::sample_point_t implied_point;
  logic implied_take, implied_return, implied_clear, implied_sort;
  vsg_pkg::ptr_t implied_returned, implied_sort_block;
  vsg_pkg::pixel_t implied_sort_pixel;
  implied_edges u_implied_edges (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width), .last_lines_i(implied_last_lines_i),
    .line_start_i(implied_line_start_i), .line_done_o(implied_line_done_o), .crossing_i(implied_crossing_i),
    .left_i(implied_left_i[vsg_pkg::PtrW-1:0]), .right_i(implied_right_i[vsg_pkg::PtrW-1:0]),
    .x_i(implied_x_i[vsg_pkg::XW-1:0]), .done_o(implied_done_o), .full_o(implied_full_o), .point_o(implied_point),
    .take_o(implied_take), .free_block_i(free_block), .free_fresh_i, .free_full_i, .return_o(implied_return),
    .returned_o(implied_returned), .clear_samples_o(implied_clear), .sort_o(implied_sort),
    .sort_block_o(implied_sort_block), .sort_pixel_o(implied_sort_pixel), .sort_done_i, .sort_previous_i(sort_previous),
    .sort_next_i(sort_next), .request_o(implied_request), .word_i(word), .count_o(implied_count)
  );
  assign implied_point_o = bench_pkg::spread_point(implied_point);

  assign take_o            = lists_take || implied_take;
  assign clear_samples_o   = lists_clear || implied_clear;
  assign return_o          = eliminator_return || implied_return;
  assign returned_o        = eliminator_return ? 32'(eliminator_returned) : 32'(implied_returned);
  assign sort_o            = eliminator_sort || implied_sort;
  assign sort_command_o    = eliminator_sort ? 32'(sort_command) : 32'(vsg_pkg::SortInsertNext);
  assign sort_block_o      = eliminator_sort ? 32'(eliminator_sort_block) : 32'(implied_sort_block);
  assign sort_pixel_o      = eliminator_sort ? 32'(eliminator_sort_pixel) : 32'(implied_sort_pixel);
  assign sort_start_o      = 32'(sort_start);
  assign unlink_previous_o = 32'(unlink_previous);
  assign unlink_next_o     = 32'(unlink_next);
  assign set_first_o       = lists_set_first || eliminator_set_first;
  assign set_polygon_o     = 32'(eliminator_set_polygon);
  assign set_segment_o     = lists_set_first ? 32'(lists_set_segment) : 32'(eliminator_set_segment);

  vsg_pkg::pixel_t space_from;
  vsg_pkg::span_t span;
  sample_space_generator u_sample_space_generator (
    .clk_i, .rst_ni, .line_start_i, .next_i(space_next_i), .done_o(space_done_o), .read_o(space_read_o),
    .from_pixel_o(space_from), .sample_valid_i(space_sample_valid_i),
    .sample_i(space_sample_i[vsg_pkg::IntegerBits-1:0]), .set_left_i(space_set_left_i),
    .left_point_i(bench_pkg::make_point(space_left_point_i)), .set_right_i(space_set_right_i),
    .right_point_i(bench_pkg::make_point(space_right_point_i)), .clear_left_i(space_clear_left_i),
    .set_implied_i(space_set_implied_i), .implied_point_i(bench_pkg::make_point(space_implied_point_i)),
    .subdivide_i(space_subdivide_i), .new_right_i(space_new_right_i[vsg_pkg::IntegerBits-1:0]), .span_o(span)
  );
  assign space_from_o = 32'(space_from);
  assign space_span_o = bench_pkg::spread_span(span);

endmodule
