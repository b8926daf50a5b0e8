// Stepping of a segment (chapter III.F, points 1 to 3): a block taken from the X-sort list gets the X and Z of this scan
// line, enters the X-sort list of the next line when its left edge goes on, its polygon is marked as changing when an edge
// ends, and the block is written back, linked into the active list. An implied edge stays only when it made the left end
// of the span; otherwise its block is returned.
//
// Latency: 4 cycles, more when the X-sort list has to go back or an edge ends. Refuses: an edge that leaves the frame
// (error_o, one cycle, instead of done_o).

module segment_stepper (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      frame_start_i,
  input  vsg_pkg::pixel_t           width_i,
  input  vsg_pkg::pixel_t           span_left_i,
  input  vsg_pkg::pixel_t           span_right_i,
  // from the depth comparator: word_i is the word of the block
  input  logic                      start_i,
  input  vsg_pkg::ptr_t             at_i,             // held until done_o
  input  vsg_pkg::segment_t         word_i,
  output logic                      done_o,
  output logic                      present_o,        // with done_o: the segment has a width on this line
  output vsg_pkg::segment_t         block_o,          // with done_o and after: the block as it was written
  output logic                      error_o,
  // sample space generator: the implied edge at the left end of the span
  output logic                      set_left_o,
  output vsg_pkg::sample_point_t    left_point_o,
  // X-sort list
  output logic                      sort_next_o,
  output vsg_pkg::pixel_t           sort_pixel_o,
  input  logic                      sort_next_done_i,
  input  vsg_pkg::ptr_t             sort_previous_i,
  input  vsg_pkg::ptr_t             sort_following_i,
  // polygon memory
  output logic                      polygon_read_o,
  output vsg_pkg::poly_ptr_t        polygon_o,
  output logic                      polygon_mark_o,
  input  logic                      polygon_active_i,
  // active list
  output logic                      active_add_o,
  output logic                      active_add_ending_o,
  input  vsg_pkg::ptr_t             active_link_i,
  // free list
  output logic                      return_o,
  // segment memory and tally
  output vsg_pkg::memory_request_t  request_o,
  output vsg_pkg::count_t           count_o
);

  typedef enum logic [2:0] {
    StIdle,
    StStep,       // block_q holds the segment of this line
    StInsert,     // into the X-sort list of the next line
    StPolygon,    // an edge ends: the polygon's word
    StMark,
    StWrite
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::segment_t block_d, block_q;

  vsg_pkg::pixel_t left, right, next_left, next_right;
  assign left       = vsg_pkg::pixel_of(block_q.left.x);
  assign right      = vsg_pkg::pixel_of(block_q.right.x);
  assign next_left  = vsg_pkg::next_pixel(block_q.left.x, block_q.left.dx);
  assign next_right = vsg_pkg::next_pixel(block_q.right.x, block_q.right.dx);

  logic left_lives, right_lives, right_inside, implied_stays, has_width;
  assign left_lives    = block_q.left_lines[vsg_pkg::CoordW+1];
  assign right_lives   = block_q.right_lines[vsg_pkg::CoordW+1];
  assign right_inside  = vsg_pkg::inside_frame(next_right, width_i);
  assign implied_stays = (left + 1'b1 == span_left_i) && vsg_pkg::inside_frame(next_left, width_i);
  assign has_width     = (left < right);

  assign polygon_o    = block_q.polygon[vsg_pkg::PolyW-1:0];
  assign sort_pixel_o = next_left;
  assign block_o      = block_q;

  always_comb begin
    state_d             = state_q;
    block_d             = block_q;
    done_o              = 1'b0;
    present_o           = 1'b0;
    error_o             = 1'b0;
    set_left_o          = 1'b0;
    left_point_o        = '0;
    sort_next_o         = 1'b0;
    polygon_read_o      = 1'b0;
    polygon_mark_o      = 1'b0;
    active_add_o        = 1'b0;
    active_add_ending_o = 1'b0;
    return_o            = 1'b0;
    request_o           = '0;
    count_o             = '0;
    case (state_q)
      StIdle: begin
        if (start_i) begin
          count_o.intercepts  = 1'b1;
          block_d             = word_i;
          block_d.left.x      = word_i.left.x + word_i.left.dx;
          block_d.right.x     = word_i.right.x + word_i.right.dx;
          block_d.left.z      = word_i.left.z + word_i.left.dz;
          block_d.right.z     = word_i.right.z + word_i.right.dz;
          block_d.left_lines  = word_i.left_lines + 1'b1;
          block_d.right_lines = word_i.right_lines + 1'b1;
          state_d             = StStep;
        end
      end
      StStep: begin
        if (block_q.implied) begin
          if (implied_stays) begin
            set_left_o                 = 1'b1;
            left_point_o.pixel         = next_left;
            left_point_o.address.block = at_i;
            sort_next_o                = 1'b1;
            state_d                    = StInsert;
          end else begin
            return_o                = 1'b1;
            count_o.blocks_returned = 1'b1;
            done_o                  = 1'b1;
            state_d                 = StIdle;
          end
        end else begin
          count_o.crossings  = 1'b1;
          block_d.x_previous = vsg_pkg::NotSorted;
          block_d.x_next     = '0;
          if (!left_lives) begin
            state_d = StPolygon;
          end else if (vsg_pkg::inside_frame(next_left, width_i)) begin
            sort_next_o = 1'b1;
            state_d     = StInsert;
          end else begin
            error_o = 1'b1;
            state_d = StIdle;
          end
        end
      end
      StInsert: begin
        if (sort_next_done_i) begin
          block_d.x_previous = sort_previous_i;
          block_d.x_next     = sort_following_i;
          state_d            = (block_q.implied || (right_lives && right_inside)) ? StWrite : StPolygon;
        end
      end
      StPolygon: begin
        if (right_lives && !right_inside) begin
          error_o = 1'b1;
          state_d = StIdle;
        end else begin
          polygon_read_o = 1'b1;
          state_d        = StMark;
        end
      end
      StMark: begin
        count_o.polygon_reads  = 1'b1;
        count_o.polygon_writes = !polygon_active_i;
        polygon_mark_o         = !polygon_active_i;
        state_d                = StWrite;
      end
      default: begin  // StWrite
        request_o.valid = 1'b1;
        request_o.block = at_i;
        request_o.word  = block_q;
        if (block_q.implied) begin
          request_o.groups = vsg_pkg::GroupXPrevious | vsg_pkg::GroupXNext | vsg_pkg::GroupLeft;
        end else begin
          request_o.groups    = vsg_pkg::GroupAll & ~(vsg_pkg::GroupPolygon | vsg_pkg::GroupPolygonNext);
          present_o           = has_width;
          active_add_ending_o = has_width && (right <= span_right_i);
          active_add_o        = has_width && (right > span_right_i);
          if (has_width) request_o.word.active_next = active_link_i;
        end
        done_o  = 1'b1;
        state_d = StIdle;
      end
    endcase
    if (frame_start_i) state_d = StIdle;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= StIdle;
      block_q <= '0;
    end else begin
      state_q <= state_d;
      block_q <= block_d;
    end
  end

endmodule
