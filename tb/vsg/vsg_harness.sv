// The Visible Segment Generator with its ports and trace ports spread out, one signal a field and signed values extended
// to 64 bits, as the C++ driver reads them. Simulation only.

module vsg_harness (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         frame_start_i,
  input  logic [31:0]  width_i,
  input  logic [31:0]  height_i,
  input  logic         polygon_valid_i,
  output logic         polygon_ready_o,
  input  logic         polygon_front_i,
  input  logic         edge_valid_i,
  output logic         edge_ready_o,
  input  logic [31:0]  edge_first_polygon_i,
  input  logic [31:0]  edge_second_polygon_i,
  input  logic [31:0]  edge_first_line_i,
  input  logic [31:0]  edge_lines_i,
  input  logic [63:0]  edge_x_i,
  input  logic [63:0]  edge_dx_i,
  input  logic [63:0]  edge_z_i,
  input  logic [63:0]  edge_dz_i,
  input  logic         run_i,
  output logic         loading_o,
  output logic         running_o,
  output logic         done_o,
  output logic [31:0]  error_o,
  output logic [31:0]  line_o,
  output logic         segment_valid_o,
  input  logic         segment_ready_i,
  output logic [31:0]  segment_y_o,
  output logic [31:0]  segment_x_end_o,
  output logic [31:0]  segment_polygon_o,
  input  logic [5:0]   counter_select_i,
  output logic [31:0]  counter_o,
  // edge taken
  output logic         edge_taken_o,
  output logic [31:0]  edge_taken_number_o,
  output logic [31:0]  edge_taken_polygon_o,
  output logic [63:0]  edge_taken_x_o,
  // access of segment memory
  output logic         access_o,
  output logic [31:0]  access_groups_o,
  output logic [31:0]  access_block_o,
  output logic [63:0]  access_x_previous_o,
  output logic [63:0]  access_x_next_o,
  output logic [63:0]  access_polygon_o,
  output logic [63:0]  access_polygon_next_o,
  output logic [63:0]  access_left_lines_o,
  output logic [63:0]  access_left_x_o,
  output logic [63:0]  access_left_dx_o,
  output logic [63:0]  access_left_z_o,
  output logic [63:0]  access_left_dz_o,
  output logic [63:0]  access_right_lines_o,
  output logic [63:0]  access_right_x_o,
  output logic [63:0]  access_right_dx_o,
  output logic [63:0]  access_right_z_o,
  output logic [63:0]  access_right_dz_o,
  output logic [63:0]  access_implied_o,
  output logic [63:0]  access_active_next_o,
  // depth test
  output logic         test_o,
  output logic [63:0]  test_segment_o,
  output logic [63:0]  test_from_x_sort_o,
  output logic [63:0]  test_intersecting_o,
  output logic [63:0]  test_outcome_o,
  output logic [63:0]  test_add_cycles_o,
  output logic [63:0]  test_box_segments_o,
  output logic [63:0]  test_box_z_min_o,
  output logic [63:0]  test_box_z_max_o,
  output logic [63:0]  test_box_left_o,
  output logic [63:0]  test_box_right_o,
  output logic [63:0]  test_box_edge_o,
  output logic [63:0]  test_span_left_o,
  output logic [63:0]  test_span_right_o,
  // decision
  output logic         decision_o,
  output logic [63:0]  decision_kind_o,
  output logic [63:0]  decision_span_left_o,
  output logic [63:0]  decision_span_right_o,
  output logic [63:0]  decision_segments_o,
  output logic [63:0]  decision_new_right_o,
  // sample point stored
  output logic         sample_o,
  output logic [63:0]  sample_block_o,
  output logic [63:0]  sample_side_o,
  output logic [63:0]  sample_x_o,
  // phases of a line, and all counters, 32 bits each
  output logic         line_started_o,
  output logic         sort_started_o,
  output logic         line_finished_o,
  output vsg_pkg::counters_t counters_o,
  // what this machine was made with
  output logic [31:0]  fraction_bits_x_o,
  output logic [31:0]  fraction_bits_z_o,
  output logic [31:0]  integer_bits_o,
  output logic [31:0]  segment_blocks_o,
  output logic [31:0]  edge_blocks_o,
  output logic [31:0]  polygon_blocks_o,
  output logic [31:0]  coordinate_bits_o
);

  localparam int XExtend = 64 - vsg_pkg::XW;
  localparam int ZExtend = 64 - vsg_pkg::ZW;
  localparam int PixelExtend = 64 - vsg_pkg::IntegerBits;
  localparam int LinesW = vsg_pkg::CoordW + 2;
  localparam int LinesExtend = 64 - LinesW;

  vsg_pkg::edge_t edge_block;
  vsg_pkg::error_e error;
  vsg_pkg::line_t line;
  vsg_pkg::visible_segment_t segment;
  vsg_pkg::trace_edge_t taken;
  vsg_pkg::memory_request_t access;
  vsg_pkg::trace_test_t test;
  vsg_pkg::trace_decision_t decision;
  vsg_pkg::trace_sample_t sample;
  vsg_pkg::trace_phase_t phase;

  always_comb begin
    edge_block.first_polygon  = edge_first_polygon_i[vsg_pkg::PolyW-1:0];
    edge_block.second_polygon = edge_second_polygon_i[vsg_pkg::PolyW-1:0];
    edge_block.first_line     = edge_first_line_i[vsg_pkg::CoordW-1:0];
    edge_block.lines          = edge_lines_i[vsg_pkg::CoordW-1:0];
    edge_block.x              = edge_x_i[vsg_pkg::XW-1:0];
    edge_block.dx             = edge_dx_i[vsg_pkg::XW-1:0];
    edge_block.z              = edge_z_i[vsg_pkg::ZW-1:0];
    edge_block.dz             = edge_dz_i[vsg_pkg::ZW-1:0];
  end

  vsg u_vsg (
    .clk_i, .rst_ni, .frame_start_i, .width_i(width_i[vsg_pkg::CoordW-1:0]), .height_i(height_i[vsg_pkg::CoordW-1:0]),
    .polygon_valid_i, .polygon_ready_o, .polygon_front_i, .edge_valid_i, .edge_ready_o, .edge_i(edge_block), .run_i,
    .loading_o, .running_o, .done_o, .error_o(error), .line_o(line), .segment_valid_o, .segment_ready_i,
    .segment_o(segment), .counter_select_i, .counter_o, .trace_edge_o(taken), .trace_write_o(access),
    .trace_test_o(test), .trace_decision_o(decision), .trace_sample_o(sample), .trace_phase_o(phase),
    .trace_counters_o(counters_o)
  );

  assign error_o           = 32'(error);
  assign line_o            = 32'(line);
  assign segment_y_o       = 32'(segment.y);
  assign segment_x_end_o   = 32'(segment.x_end);
  assign segment_polygon_o = 32'(segment.polygon);

  assign edge_taken_o         = taken.valid;
  assign edge_taken_number_o  = 32'(taken.number);
  assign edge_taken_polygon_o = 32'(taken.polygon);
  assign edge_taken_x_o       = {{XExtend{taken.x[vsg_pkg::XW-1]}}, taken.x};

  assign access_o              = access.valid;
  assign access_groups_o       = 32'(access.groups);
  assign access_block_o        = 32'(access.block);
  assign access_x_previous_o   = (access.word.x_previous == vsg_pkg::NotSorted) ? '1 : 64'(access.word.x_previous);
  assign access_x_next_o       = 64'(access.word.x_next);
  assign access_polygon_o      = 64'(access.word.polygon);
  assign access_polygon_next_o = 64'(access.word.polygon_next);
  assign access_left_lines_o   = {{LinesExtend{access.word.left_lines[LinesW-1]}}, access.word.left_lines};
  assign access_left_x_o       = {{XExtend{access.word.left.x[vsg_pkg::XW-1]}}, access.word.left.x};
  assign access_left_dx_o      = {{XExtend{access.word.left.dx[vsg_pkg::XW-1]}}, access.word.left.dx};
  assign access_left_z_o       = {{ZExtend{access.word.left.z[vsg_pkg::ZW-1]}}, access.word.left.z};
  assign access_left_dz_o      = {{ZExtend{access.word.left.dz[vsg_pkg::ZW-1]}}, access.word.left.dz};
  assign access_right_lines_o  = {{LinesExtend{access.word.right_lines[LinesW-1]}}, access.word.right_lines};
  assign access_right_x_o      = {{XExtend{access.word.right.x[vsg_pkg::XW-1]}}, access.word.right.x};
  assign access_right_dx_o     = {{XExtend{access.word.right.dx[vsg_pkg::XW-1]}}, access.word.right.dx};
  assign access_right_z_o      = {{ZExtend{access.word.right.z[vsg_pkg::ZW-1]}}, access.word.right.z};
  assign access_right_dz_o     = {{ZExtend{access.word.right.dz[vsg_pkg::ZW-1]}}, access.word.right.dz};
  assign access_implied_o      = 64'(access.word.implied);
  assign access_active_next_o  = 64'(access.word.active_next);

  assign test_o              = test.valid;
  assign test_segment_o      = 64'(test.block);
  assign test_from_x_sort_o  = 64'(test.from_x_sort);
  assign test_intersecting_o = 64'(test.intersecting);
  assign test_outcome_o      = 64'(test.outcome);
  assign test_add_cycles_o   = 64'(test.add_cycles);
  assign test_box_segments_o = 64'(test.box.segments);
  assign test_box_z_min_o    = {{ZExtend{test.box.z_min[vsg_pkg::ZW-1]}}, test.box.z_min};
  assign test_box_z_max_o    = {{ZExtend{test.box.z_max[vsg_pkg::ZW-1]}}, test.box.z_max};
  assign test_box_left_o     = {{PixelExtend{test.box.left[vsg_pkg::IntegerBits-1]}}, test.box.left};
  assign test_box_right_o    = {{PixelExtend{test.box.right[vsg_pkg::IntegerBits-1]}}, test.box.right};
  assign test_box_edge_o     = {{PixelExtend{test.box.edge_inside[vsg_pkg::IntegerBits-1]}}, test.box.edge_inside};
  assign test_span_left_o    = {{PixelExtend{test.span.left[vsg_pkg::IntegerBits-1]}}, test.span.left};
  assign test_span_right_o   = {{PixelExtend{test.span.right[vsg_pkg::IntegerBits-1]}}, test.span.right};

  assign decision_o            = decision.valid;
  assign decision_kind_o       = 64'(decision.decision);
  assign decision_span_left_o  = {{PixelExtend{decision.span.left[vsg_pkg::IntegerBits-1]}}, decision.span.left};
  assign decision_span_right_o = {{PixelExtend{decision.span.right[vsg_pkg::IntegerBits-1]}}, decision.span.right};
  assign decision_segments_o   = 64'(decision.segments);
  assign decision_new_right_o  = {{PixelExtend{decision.new_right[vsg_pkg::IntegerBits-1]}}, decision.new_right};

  assign sample_o       = sample.valid;
  assign sample_block_o = 64'(sample.point.address.block);
  assign sample_side_o  = 64'(sample.point.address.side);
  assign sample_x_o     = {{PixelExtend{sample.point.pixel[vsg_pkg::IntegerBits-1]}}, sample.point.pixel};

  assign fraction_bits_x_o = vsg_pkg::FracX;
  assign fraction_bits_z_o = vsg_pkg::FracZ;
  assign integer_bits_o    = vsg_pkg::IntegerBits;
  assign segment_blocks_o  = vsg_pkg::SegmentBlocks;
  assign edge_blocks_o     = vsg_pkg::EdgeBlocks;
  assign polygon_blocks_o  = vsg_pkg::PolygonBlocks;
  assign coordinate_bits_o = vsg_pkg::CoordW;

  assign line_started_o  = phase.line_started;
  assign sort_started_o  = phase.sort_started;
  assign line_finished_o = phase.line_finished;

endmodule
