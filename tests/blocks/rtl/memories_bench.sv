// The memories, each alone, with their ports spread out for the C++ testbenches. Simulation only.

module memories_bench (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                frame_start_i,
  // segment memory
  input  bench_pkg::request_t segment_request_i,
  output bench_pkg::word_t    segment_word_o,
  output bench_pkg::request_t segment_trace_o,
  // free list
  input  logic                free_take_i,
  output logic [31:0]         free_block_o,
  output logic                free_fresh_o,
  output logic                free_full_o,
  input  logic                free_return_i,
  input  logic [31:0]         free_returned_i,
  // polygon memory
  input  logic                polygon_load_i,
  input  logic                polygon_load_front_i,
  output logic                polygon_load_full_o,
  input  logic                polygon_read_i,
  input  logic [31:0]         polygon_read_polygon_i,
  input  logic                polygon_mark_i,
  input  logic                polygon_set_first_i,
  input  logic [31:0]         polygon_set_polygon_i,
  input  logic [31:0]         polygon_set_segment_i,
  input  logic                polygon_take_i,
  output logic [31:0]         polygon_changing_o,
  output logic                polygon_front_o,
  output logic                polygon_active_o,
  output logic [31:0]         polygon_first_segment_o,
  output bench_pkg::counts_t  polygon_count_o,
  // edge memory
  input  logic [31:0]         edge_height_i,
  output logic                edge_clearing_o,
  input  logic                edge_load_valid_i,
  output logic                edge_load_ready_o,
  input  logic [31:0]         edge_first_polygon_i,
  input  logic [31:0]         edge_second_polygon_i,
  input  logic [31:0]         edge_first_line_i,
  input  logic [31:0]         edge_lines_i,
  input  logic [63:0]         edge_x_i,
  input  logic [63:0]         edge_dx_i,
  input  logic [63:0]         edge_z_i,
  input  logic [63:0]         edge_dz_i,
  output logic                edge_loading_o,
  output logic [31:0]         edge_error_o,
  output logic                edge_polygon_read_o,
  output logic [31:0]         edge_polygon_o,
  input  logic                edge_polygon_front_i,
  input  logic                edge_bucket_read_i,
  input  logic [31:0]         edge_bucket_line_i,
  output logic [31:0]         edge_bucket_edge_o,
  input  logic                edge_read_i,
  input  logic [31:0]         edge_number_i,
  output logic [31:0]         edge_next_o,
  output logic [31:0]         edge_first_polygon_o,
  output logic [31:0]         edge_second_polygon_o,
  output logic [31:0]         edge_first_line_o,
  output logic [31:0]         edge_lines_o,
  output logic [63:0]         edge_x_o,
  output logic [63:0]         edge_dx_o,
  output logic [63:0]         edge_z_o,
  output logic [63:0]         edge_dz_o,
  output bench_pkg::counts_t  edge_count_o
);

  vsg_pkg::segment_t word;
  vsg_pkg::memory_request_t trace;
  segment_memory u_segment_memory (
    .clk_i, .request_i(bench_pkg::make_request(segment_request_i)), .word_o(word), .trace_o(trace)
  );
  assign segment_word_o  = bench_pkg::spread_word(word);
  assign segment_trace_o = bench_pkg::spread_request(trace);

  vsg_pkg::ptr_t free_block;
  free_list u_free_list (
    .clk_i, .rst_ni, .frame_start_i, .take_i(free_take_i), .block_o(free_block), .fresh_o(free_fresh_o),
    .full_o(free_full_o), .return_i(free_return_i), .returned_i(free_returned_i[vsg_pkg::PtrW-1:0])
  );
  assign free_block_o = 32'(free_block);

  vsg_pkg::poly_ptr_t changing;
  vsg_pkg::ptr_t first_segment;
  vsg_pkg::count_t polygon_count;
  polygon_memory u_polygon_memory (
    .clk_i, .rst_ni, .frame_start_i, .load_i(polygon_load_i), .load_front_i(polygon_load_front_i),
    .load_full_o(polygon_load_full_o), .read_i(polygon_read_i),
    .read_polygon_i(polygon_read_polygon_i[vsg_pkg::PolyW-1:0]), .mark_i(polygon_mark_i),
    .set_first_i(polygon_set_first_i), .set_polygon_i(polygon_set_polygon_i[vsg_pkg::PolyW-1:0]),
    .set_segment_i(polygon_set_segment_i[vsg_pkg::PtrW-1:0]), .take_i(polygon_take_i), .changing_o(changing),
    .front_o(polygon_front_o), .active_o(polygon_active_o), .first_segment_o(first_segment), .count_o(polygon_count)
  );
  assign polygon_changing_o      = 32'(changing);
  assign polygon_first_segment_o = 32'(first_segment);
  assign polygon_count_o         = bench_pkg::spread_counts(polygon_count);

  vsg_pkg::edge_t load_edge, edge_word;
  vsg_pkg::error_e error;
  vsg_pkg::poly_ptr_t polygon;
  vsg_pkg::edge_ptr_t bucket_edge, edge_next;
  vsg_pkg::count_t edge_count;
  always_comb begin
    load_edge.first_polygon  = edge_first_polygon_i[vsg_pkg::PolyW-1:0];
    load_edge.second_polygon = edge_second_polygon_i[vsg_pkg::PolyW-1:0];
    load_edge.first_line     = edge_first_line_i[vsg_pkg::CoordW-1:0];
    load_edge.lines          = edge_lines_i[vsg_pkg::CoordW-1:0];
    load_edge.x              = edge_x_i[vsg_pkg::XW-1:0];
    load_edge.dx             = edge_dx_i[vsg_pkg::XW-1:0];
    load_edge.z              = edge_z_i[vsg_pkg::ZW-1:0];
    load_edge.dz             = edge_dz_i[vsg_pkg::ZW-1:0];
  end
  edge_memory u_edge_memory (
    .clk_i, .rst_ni, .frame_start_i, .height_i(edge_height_i[vsg_pkg::CoordW-1:0]), .clearing_o(edge_clearing_o),
    .load_valid_i(edge_load_valid_i), .load_ready_o(edge_load_ready_o), .load_edge_i(load_edge),
    .loading_o(edge_loading_o), .error_o(error), .polygon_read_o(edge_polygon_read_o), .polygon_o(polygon),
    .polygon_front_i(edge_polygon_front_i), .bucket_read_i(edge_bucket_read_i),
    .bucket_line_i(edge_bucket_line_i[vsg_pkg::CoordW-1:0]), .bucket_edge_o(bucket_edge), .edge_read_i,
    .edge_number_i(edge_number_i[vsg_pkg::EdgeW-1:0]), .edge_o(edge_word), .edge_next_o(edge_next),
    .count_o(edge_count)
  );
  assign edge_error_o          = 32'(error);
  assign edge_polygon_o        = 32'(polygon);
  assign edge_bucket_edge_o    = 32'(bucket_edge);
  assign edge_next_o           = 32'(edge_next);
  assign edge_first_polygon_o  = 32'(edge_word.first_polygon);
  assign edge_second_polygon_o = 32'(edge_word.second_polygon);
  assign edge_first_line_o     = 32'(edge_word.first_line);
  assign edge_lines_o          = 32'(edge_word.lines);
  assign edge_x_o              = 64'(edge_word.x);
  assign edge_dx_o             = 64'(edge_word.dx);
  assign edge_z_o              = 64'(edge_word.z);
  assign edge_dz_o             = 64'(edge_word.dz);
  assign edge_count_o          = bench_pkg::spread_counts(edge_count);

endmodule
