// Structures of vsg_pkg spread out to fields of 64 bits, and back, as the C++ testbenches read and drive them. Field i lies
// in bits 64 i to 64 i + 63; values are cut to their width here and sign extended there. Simulation only.

package bench_pkg;

  typedef logic [15:0][63:0] word_t;      // segment block
  typedef logic [18:0][63:0] request_t;   // valid, block, groups, segment block
  typedef logic [36:0][31:0] counts_t;    // what a block counts in a cycle, in the order of count_t
  typedef logic [2:0][63:0]  point_t;     // pixel, block, side
  typedef logic [7:0][63:0]  span_t;      // left, right, two points
  typedef logic [6:0][63:0]  candidate_t;
  typedef logic [13:0][63:0] box_t;

  function automatic bench_pkg::word_t spread_word(input vsg_pkg::segment_t w);
    spread_word[0]  = 64'(w.x_previous);
    spread_word[1]  = 64'(w.x_next);
    spread_word[2]  = 64'(w.polygon);
    spread_word[3]  = 64'(w.polygon_next);
    spread_word[4]  = 64'(w.left_lines);
    spread_word[5]  = 64'(w.left.x);
    spread_word[6]  = 64'(w.left.dx);
    spread_word[7]  = 64'(w.left.z);
    spread_word[8]  = 64'(w.left.dz);
    spread_word[9]  = 64'(w.right_lines);
    spread_word[10] = 64'(w.right.x);
    spread_word[11] = 64'(w.right.dx);
    spread_word[12] = 64'(w.right.z);
    spread_word[13] = 64'(w.right.dz);
    spread_word[14] = 64'(w.implied);
    spread_word[15] = 64'(w.active_next);
  endfunction

  function automatic vsg_pkg::segment_t make_word(input bench_pkg::word_t f);
    make_word.x_previous   = f[0][vsg_pkg::PtrW-1:0];
    make_word.x_next       = f[1][vsg_pkg::PtrW-1:0];
    make_word.polygon      = f[2][vsg_pkg::OwnerW-1:0];
    make_word.polygon_next = f[3][vsg_pkg::PtrW-1:0];
    make_word.left_lines   = f[4][vsg_pkg::CoordW+1:0];
    make_word.left.x       = f[5][vsg_pkg::XW-1:0];
    make_word.left.dx      = f[6][vsg_pkg::XW-1:0];
    make_word.left.z       = f[7][vsg_pkg::ZW-1:0];
    make_word.left.dz      = f[8][vsg_pkg::ZW-1:0];
    make_word.right_lines  = f[9][vsg_pkg::CoordW+1:0];
    make_word.right.x      = f[10][vsg_pkg::XW-1:0];
    make_word.right.dx     = f[11][vsg_pkg::XW-1:0];
    make_word.right.z      = f[12][vsg_pkg::ZW-1:0];
    make_word.right.dz     = f[13][vsg_pkg::ZW-1:0];
    make_word.implied      = f[14][0];
    make_word.active_next  = f[15][vsg_pkg::PtrW-1:0];
  endfunction

  function automatic bench_pkg::request_t spread_request(input vsg_pkg::memory_request_t r);
    spread_request[0]    = 64'(r.valid);
    spread_request[1]    = 64'(r.block);
    spread_request[2]    = 64'(r.groups);
    spread_request[18:3] = spread_word(r.word);
  endfunction

  function automatic vsg_pkg::memory_request_t make_request(input bench_pkg::request_t f);
    make_request.valid  = f[0][0];
    make_request.block  = f[1][vsg_pkg::PtrW-1:0];
    make_request.groups = f[2][vsg_pkg::Groups-1:0];
    make_request.word   = make_word(f[18:3]);
  endfunction

  function automatic bench_pkg::counts_t spread_counts(input vsg_pkg::count_t c);
    spread_counts[0]  = 32'(c.slopes);
    spread_counts[1]  = 32'(c.intercepts);
    spread_counts[2]  = 32'(c.samples_stored);
    spread_counts[3]  = 32'(c.subdivisions);
    spread_counts[4]  = 32'(c.depth_tests);
    spread_counts[5]  = 32'(c.samples_deleted);
    spread_counts[6]  = 32'(c.steps_back);
    spread_counts[7]  = 32'(c.output_segments);
    spread_counts[8]  = 32'(c.intersections);
    spread_counts[9]  = 32'(c.halvings);
    spread_counts[10] = 32'(c.pipeline);
    spread_counts[11] = 32'(c.polygon_reads);
    spread_counts[12] = 32'(c.polygon_writes);
    spread_counts[13] = 32'(c.edge_reads);
    spread_counts[14] = 32'(c.edge_writes);
    spread_counts[15] = 32'(c.segment_reads);
    spread_counts[16] = 32'(c.segment_writes);
    spread_counts[17] = 32'(c.blocks_taken);
    spread_counts[18] = 32'(c.blocks_returned);
    spread_counts[19] = 32'(c.bucket_reads);
    spread_counts[20] = 32'(c.crossings);
    spread_counts[21] = 32'(c.implied_edges);
    spread_counts[22] = 32'(c.insertions);
    spread_counts[23] = 32'(c.not_at_end);
    spread_counts[24] = 32'(c.stale_samples);
    spread_counts[25] = 32'(c.unclosed_polygons);
    spread_counts[26] = 32'(c.polygons);
    spread_counts[27] = 32'(c.front_polygons);
    spread_counts[28] = 32'(c.edges);
    spread_counts[29] = 32'(c.front_edges);
    spread_counts[30] = 32'(c.entered_edges);
    spread_counts[31] = 32'(c.involved_lines);
    spread_counts[32] = 32'(c.mark);
    spread_counts[33] = 32'(c.account);
    spread_counts[34] = 32'(c.tested);
    spread_counts[35] = 32'(c.add_cycles);
    spread_counts[36] = 32'(c.density);
  endfunction

  function automatic vsg_pkg::count_t make_counts(input bench_pkg::counts_t f);
    make_counts.slopes            = f[0][0];
    make_counts.intercepts        = f[1][0];
    make_counts.samples_stored    = f[2][0];
    make_counts.subdivisions      = f[3][0];
    make_counts.depth_tests       = f[4][0];
    make_counts.samples_deleted   = f[5][0];
    make_counts.steps_back        = f[6][0];
    make_counts.output_segments   = f[7][0];
    make_counts.intersections     = f[8][0];
    make_counts.halvings          = f[9][0];
    make_counts.pipeline          = f[10][0];
    make_counts.polygon_reads     = f[11][0];
    make_counts.polygon_writes    = f[12][0];
    make_counts.edge_reads        = f[13][0];
    make_counts.edge_writes       = f[14][0];
    make_counts.segment_reads     = f[15][1:0];
    make_counts.segment_writes    = f[16][1:0];
    make_counts.blocks_taken      = f[17][0];
    make_counts.blocks_returned   = f[18][0];
    make_counts.bucket_reads      = f[19][0];
    make_counts.crossings         = f[20][0];
    make_counts.implied_edges     = f[21][0];
    make_counts.insertions        = f[22][0];
    make_counts.not_at_end        = f[23][0];
    make_counts.stale_samples     = f[24][0];
    make_counts.unclosed_polygons = f[25][0];
    make_counts.polygons          = f[26][0];
    make_counts.front_polygons    = f[27][0];
    make_counts.edges             = f[28][0];
    make_counts.front_edges       = f[29][0];
    make_counts.entered_edges     = f[30][0];
    make_counts.involved_lines    = f[31][0];
    make_counts.mark              = f[32][0];
    make_counts.account           = f[33][0];
    make_counts.tested            = f[34][0];
    make_counts.add_cycles        = f[35][vsg_pkg::AddW-1:0];
    make_counts.density           = f[36][vsg_pkg::IntegerBits-1:0];
  endfunction

  function automatic bench_pkg::point_t spread_point(input vsg_pkg::sample_point_t p);
    spread_point[0] = 64'(p.pixel);
    spread_point[1] = 64'(p.address.block);
    spread_point[2] = 64'(p.address.side);
  endfunction

  function automatic vsg_pkg::sample_point_t make_point(input bench_pkg::point_t f);
    make_point.pixel         = f[0][vsg_pkg::IntegerBits-1:0];
    make_point.address.block = f[1][vsg_pkg::PtrW-1:0];
    make_point.address.side  = f[2][0];
  endfunction

  function automatic bench_pkg::span_t spread_span(input vsg_pkg::span_t s);
    spread_span[0]   = 64'(s.left);
    spread_span[1]   = 64'(s.right);
    spread_span[4:2] = spread_point(s.at_left);
    spread_span[7:5] = spread_point(s.at_right);
  endfunction

  function automatic vsg_pkg::span_t make_span(input bench_pkg::span_t f);
    make_span.left     = f[0][vsg_pkg::IntegerBits-1:0];
    make_span.right    = f[1][vsg_pkg::IntegerBits-1:0];
    make_span.at_left  = make_point(f[4:2]);
    make_span.at_right = make_point(f[7:5]);
  endfunction

  function automatic vsg_pkg::candidate_t make_candidate(input bench_pkg::candidate_t f);
    make_candidate.block       = f[0][vsg_pkg::PtrW-1:0];
    make_candidate.polygon     = f[1][vsg_pkg::PolyW-1:0];
    make_candidate.x_left      = f[2][vsg_pkg::XW-1:0];
    make_candidate.x_right     = f[3][vsg_pkg::XW-1:0];
    make_candidate.z_left      = f[4][vsg_pkg::ZW-1:0];
    make_candidate.z_right     = f[5][vsg_pkg::ZW-1:0];
    make_candidate.edge_inside = f[6][vsg_pkg::IntegerBits-1:0];
  endfunction

  function automatic bench_pkg::box_t spread_box(input vsg_pkg::box_t b);
    spread_box[0]  = 64'(b.segments);
    spread_box[1]  = 64'(b.x_left);
    spread_box[2]  = 64'(b.x_right);
    spread_box[3]  = 64'(b.z_min);
    spread_box[4]  = 64'(b.z_max);
    spread_box[5]  = 64'(b.left);
    spread_box[6]  = 64'(b.right);
    spread_box[7]  = 64'(b.edge_inside);
    spread_box[8]  = 64'(b.front);
    spread_box[9]  = 64'(b.other);
    spread_box[10] = 64'(b.front_polygon);
    spread_box[11] = 64'(b.other_polygon);
    spread_box[12] = 64'(b.rising);
    spread_box[13] = 64'(b.halvings);
  endfunction

  function automatic vsg_pkg::box_t make_box(input bench_pkg::box_t f);
    make_box.segments      = f[0][vsg_pkg::BoxW-1:0];
    make_box.x_left        = f[1][vsg_pkg::XW-1:0];
    make_box.x_right       = f[2][vsg_pkg::XW-1:0];
    make_box.z_min         = f[3][vsg_pkg::ZW-1:0];
    make_box.z_max         = f[4][vsg_pkg::ZW-1:0];
    make_box.left          = f[5][vsg_pkg::IntegerBits-1:0];
    make_box.right         = f[6][vsg_pkg::IntegerBits-1:0];
    make_box.edge_inside   = f[7][vsg_pkg::IntegerBits-1:0];
    make_box.front         = f[8][vsg_pkg::PtrW-1:0];
    make_box.other         = f[9][vsg_pkg::PtrW-1:0];
    make_box.front_polygon = f[10][vsg_pkg::PolyW-1:0];
    make_box.other_polygon = f[11][vsg_pkg::PolyW-1:0];
    make_box.rising        = f[12][0];
    make_box.halvings      = f[13][vsg_pkg::HalvingW-1:0];
  endfunction

endpackage
