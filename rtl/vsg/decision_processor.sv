// Decision Processor (chapters III.H and III.J): from the box of a span it decides on output, subdivision or intersection,
// hands visible segments to the display file and enters visible edges into the sample list of the next line. Pieces of
// the same polygon that follow each other become one entry: the last entry is held until another polygon comes or the
// line ends.
//
// Latency: 2 cycles for a decision, 1 for a piece of output, more while the receiver is not ready or an intersection is
// sought. Refuses: segment memory full for an implied edge (error_o, held until the next frame).

module decision_processor (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  input  logic                       frame_start_i,
  input  logic                       line_start_i,
  input  vsg_pkg::line_t             line_i,
  // control
  input  logic                       decide_i,
  output logic                       decided_o,
  output logic                       again_o,          // with decided_o: the span was subdivided
  input  logic                       finish_line_i,
  output logic                       finished_o,
  output vsg_pkg::error_e            error_o,
  // depth comparator
  input  vsg_pkg::box_t              box_i,
  output logic                       intersect_o,
  input  logic                       intersect_done_i,
  input  vsg_pkg::x_t                crossing_i,
  // sample space generator
  input  vsg_pkg::span_t             span_i,
  output logic                       clear_left_o,
  output logic                       set_implied_o,
  output vsg_pkg::sample_point_t     implied_point_o,
  output logic                       subdivide_o,
  output vsg_pkg::pixel_t            new_right_o,
  // active list
  output logic                       restore_o,
  // implied edges
  output logic                       implied_o,
  input  logic                       implied_done_i,
  input  logic                       implied_full_i,
  input  vsg_pkg::sample_point_t     implied_point_i,
  // sample list
  output logic                       store_o,
  // display file
  output logic                       valid_o,
  input  logic                       ready_i,
  output vsg_pkg::visible_segment_t  segment_o,
  // to the tally, and lock-step
  output vsg_pkg::count_t            count_o,
  output vsg_pkg::trace_decision_t   trace_o
);

  typedef enum logic [2:0] {
    StIdle,
    StDecide,
    StBefore,      // background left of the visible segment
    StVisible,
    StAfter,       // background right of it, or the far side of an intersection
    StIntersect,
    StImplied,
    StFinish
  } state_e;

  state_e state_d, state_q;
  logic crossing_d, crossing_q;              // an intersection is being output
  logic held_valid_d, held_valid_q;
  vsg_pkg::visible_segment_t held_d, held_q;
  vsg_pkg::line_t segments_d, segments_q;    // of this line; more than one is all that matters
  vsg_pkg::error_e error_d, error_q;
  vsg_pkg::decision_e decision_kept_d, decision_kept_q;
  vsg_pkg::sample_point_t implied_d, implied_q;

  localparam logic [vsg_pkg::BoxW-1:0] One = 1;
  localparam logic [vsg_pkg::BoxW-1:0] Two = 2;

  vsg_pkg::pixel_t span_left, span_right, box_left, box_right, edge_inside, crossing_pixel, left_pixel;
  assign span_left      = span_i.left;
  assign span_right     = span_i.right;
  assign box_left       = box_i.left;
  assign box_right      = box_i.right;
  assign edge_inside    = box_i.edge_inside;
  assign crossing_pixel = vsg_pkg::pixel_of(crossing_i);
  assign left_pixel     = span_i.at_left.pixel;

  logic signed [vsg_pkg::IntegerBits:0] span_middle;
  assign span_middle = {span_left[vsg_pkg::IntegerBits-1], span_left} + {span_right[vsg_pkg::IntegerBits-1], span_right};

  vsg_pkg::decision_e decision;
  always_comb begin
    decision    = vsg_pkg::DecisionBackground;
    new_right_o = span_right;
    if (box_i.segments == One) begin
      decision = vsg_pkg::DecisionVisible;
    end else if (box_i.segments != '0) begin
      if (edge_inside < span_right) begin
        decision    = vsg_pkg::DecisionSubdivideAtEdge;
        new_right_o = edge_inside;
      end else if (box_i.segments == Two) begin
        decision = vsg_pkg::DecisionIntersection;
      end else begin
        decision    = vsg_pkg::DecisionSubdivideInMiddle;
        new_right_o = span_middle[vsg_pkg::IntegerBits:1];
      end
    end
  end

  // --- a piece of output: up to pixel piece_end, of piece_polygon
  logic piece, piece_taken, piece_merges;
  vsg_pkg::pixel_t piece_end;
  vsg_pkg::poly_ptr_t piece_polygon;
  assign piece_merges = held_valid_q && (held_q.polygon == piece_polygon);
  assign piece_taken  = piece && (piece_merges || !held_valid_q || ready_i);

  always_comb begin
    state_d    = state_q;
    crossing_d = crossing_q;
    error_d    = error_q;
    decided_o     = 1'b0;
    again_o       = 1'b0;
    finished_o    = 1'b0;
    intersect_o   = 1'b0;
    set_implied_o = 1'b0;
    subdivide_o   = 1'b0;
    restore_o     = 1'b0;
    implied_o     = 1'b0;
    count_o       = '0;
    trace_o       = '0;
    piece         = 1'b0;
    piece_end     = span_right;
    piece_polygon = '0;
    case (state_q)
      StIdle: begin
        crossing_d = 1'b0;
        if (decide_i) state_d = StDecide;
        else if (finish_line_i) state_d = StFinish;
      end
      StDecide: begin
        trace_o.valid     = 1'b1;
        trace_o.decision  = decision;
        trace_o.segments  = box_i.segments;
        trace_o.new_right = new_right_o;
        trace_o.span      = span_i;
        count_o.pipeline  = 1'b1;
        case (decision)
          vsg_pkg::DecisionBackground: begin
            count_o.samples_deleted = 1'b1;
            state_d                 = StAfter;
          end
          vsg_pkg::DecisionVisible: state_d = (box_left != span_left) ? StBefore : StVisible;
          vsg_pkg::DecisionIntersection: begin
            count_o.intersections = 1'b1;
            intersect_o           = 1'b1;
            crossing_d            = 1'b1;
            state_d               = StIntersect;
          end
          default: begin
            count_o.subdivisions = 1'b1;
            count_o.halvings     = (decision == vsg_pkg::DecisionSubdivideInMiddle);
            restore_o            = 1'b1;
            subdivide_o          = 1'b1;
            decided_o            = 1'b1;
            again_o              = 1'b1;
            state_d              = StIdle;
          end
        endcase
      end
      StBefore: begin
        piece     = 1'b1;
        piece_end = box_left;
        if (piece_taken) state_d = StVisible;
      end
      StVisible: begin
        piece         = 1'b1;
        piece_end     = crossing_q ? crossing_pixel : box_right;
        piece_polygon = box_i.front_polygon;
        if (piece_taken) begin
          count_o.density = (crossing_q ? span_right : box_right) - span_left;
          set_implied_o   = crossing_q && (implied_q.pixel != '0);
          state_d         = StAfter;
          if (!crossing_q && box_right == span_right) begin
            decided_o = 1'b1;
            state_d   = StIdle;
          end
        end
      end
      StAfter: begin
        piece         = 1'b1;
        piece_polygon = crossing_q ? box_i.other_polygon : '0;
        if (piece_taken) begin
          decided_o = 1'b1;
          state_d   = StIdle;
        end
      end

      StIntersect: begin
        if (intersect_done_i) begin
          implied_o = 1'b1;
          state_d   = StImplied;
        end
      end
      StImplied: begin
        if (implied_full_i) begin
          error_d = vsg_pkg::ErrorSegmentMemoryFull;
          state_d = StIdle;
        end else if (implied_done_i) begin
          state_d = StVisible;
        end
      end

      default: begin  // StFinish
        if (ready_i) begin
          count_o.involved_lines = (segments_q != {{vsg_pkg::CoordW-1{1'b0}}, 1'b1});
          finished_o             = 1'b1;
          state_d                = StIdle;
        end
      end
    endcase

    if (piece_taken) begin
      if (piece_merges) count_o.samples_deleted = 1'b1;
      else count_o.output_segments = 1'b1;
    end
    if (frame_start_i) begin
      state_d = StIdle;
      error_d = vsg_pkg::ErrorNone;
    end
  end

  // The edge on the left of the span becomes a sample point of the next line with the first piece that does not merge.
  assign store_o      = piece_taken && !piece_merges && (left_pixel != '0) && (decision_kept_q != vsg_pkg::DecisionBackground);
  assign clear_left_o = piece_taken && !set_implied_o;

  assign valid_o   = (piece && held_valid_q && !piece_merges) || (state_q == StFinish);
  assign segment_o = held_q;

  always_comb begin
    held_valid_d = held_valid_q;
    held_d       = held_q;
    segments_d   = segments_q;
    if (piece_taken) begin
      held_valid_d   = 1'b1;
      held_d.y       = line_i;
      held_d.x_end   = piece_end[vsg_pkg::CoordW-1:0];
      held_d.polygon = piece_polygon;
      if (!piece_merges && segments_q != '1) segments_d = segments_q + 1'b1;
    end
    if (line_start_i) begin
      held_valid_d = 1'b0;
      segments_d   = '0;
    end
  end

  assign decision_kept_d = (state_q == StDecide) ? decision : decision_kept_q;
  assign implied_d       = (state_q == StImplied) ? implied_point_i : implied_q;
  assign implied_point_o = implied_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q         <= StIdle;
      crossing_q      <= 1'b0;
      held_valid_q    <= 1'b0;
      held_q          <= '0;
      segments_q      <= '0;
      error_q         <= vsg_pkg::ErrorNone;
      decision_kept_q <= vsg_pkg::DecisionBackground;
      implied_q       <= '0;
    end else begin
      state_q         <= state_d;
      crossing_q      <= crossing_d;
      held_valid_q    <= held_valid_d;
      held_q          <= held_d;
      segments_q      <= segments_d;
      error_q         <= error_d;
      decision_kept_q <= decision_kept_d;
      implied_q       <= implied_d;
    end
  end

  assign error_o = error_q;

endmodule
