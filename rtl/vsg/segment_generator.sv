// Segment Generator (chapter III.A): takes the edges of this scan line's bucket and enters each into the segment lists of
// its polygons, the second polygon first.
//
// Latency: 2 cycles for the bucket, 2 an edge, 2 a polygon and the insertion. Refuses: an edge that enters outside the
// frame (error_o), segment memory full (error_o).

module segment_generator (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   frame_start_i,
  input  vsg_pkg::pixel_t        width_i,
  // control
  input  logic                   start_i,
  output logic                   done_o,
  output vsg_pkg::error_e        error_o,
  // edge memory
  output logic                   bucket_read_o,
  input  vsg_pkg::edge_ptr_t     bucket_edge_i,
  output logic                   edge_read_o,
  output vsg_pkg::edge_ptr_t     edge_number_o,
  input  vsg_pkg::edge_t         edge_i,
  input  vsg_pkg::edge_ptr_t     edge_next_i,
  // polygon memory
  output logic                   polygon_read_o,
  output vsg_pkg::poly_ptr_t     polygon_o,
  output logic                   polygon_mark_o,
  input  logic                   polygon_front_i,
  input  logic                   polygon_active_i,
  // polygon segment lists
  output vsg_pkg::poly_ptr_t     enter_polygon_o,
  output logic                   insert_o,
  input  logic                   insert_done_i,
  input  logic                   insert_full_i,
  // to the tally, and lock-step
  output vsg_pkg::count_t        count_o,
  output vsg_pkg::trace_edge_t   trace_o
);

  typedef enum logic [2:0] {
    StIdle,
    StBucket,
    StEdge,       // is there an edge?
    StEdgeWord,
    StPolygon,    // the polygon's word
    StInsert
  } state_e;

  state_e state_d, state_q;
  vsg_pkg::edge_ptr_t number_d, number_q;
  logic first_d, first_q;   // the first polygon of the edge is being entered (the second is done)
  vsg_pkg::error_e error_d, error_q;

  logic after_polygon;  // this polygon is done
  vsg_pkg::pixel_t edge_pixel;
  assign edge_pixel = vsg_pkg::pixel_of(edge_i.x);

  // The second polygon is read with the edge, the first when the second is done.
  assign polygon_o      = (state_q == StEdgeWord && edge_i.second_polygon != '0) ? edge_i.second_polygon
                                                                                  : edge_i.first_polygon;
  assign enter_polygon_o = first_q ? edge_i.first_polygon : edge_i.second_polygon;
  assign edge_number_o = number_q;

  always_comb begin
    state_d        = state_q;
    number_d       = number_q;
    first_d        = first_q;
    error_d        = error_q;
    done_o         = 1'b0;
    bucket_read_o  = 1'b0;
    edge_read_o    = 1'b0;
    polygon_read_o = 1'b0;
    polygon_mark_o = 1'b0;
    insert_o       = 1'b0;
    after_polygon  = 1'b0;
    count_o        = '0;
    trace_o        = '0;
    case (state_q)
      StIdle: begin
        if (start_i) begin
          count_o.bucket_reads = 1'b1;
          bucket_read_o        = 1'b1;
          state_d              = StBucket;
        end
      end
      StBucket: begin
        number_d = bucket_edge_i;
        state_d  = StEdge;
      end
      StEdge: begin
        if (number_q == '0) begin
          done_o  = 1'b1;
          state_d = StIdle;
        end else begin
          edge_read_o = 1'b1;
          state_d     = StEdgeWord;
        end
      end
      StEdgeWord: begin
        count_o.edge_reads = 1'b1;
        count_o.slopes     = 1'b1;
        if (!vsg_pkg::inside_frame(edge_pixel, width_i)) begin
          error_d = vsg_pkg::ErrorOutOfFrame;
          state_d = StIdle;
        end else begin
          polygon_read_o = 1'b1;
          first_d        = (edge_i.second_polygon == '0);
          state_d        = StPolygon;
        end
      end
      StPolygon: begin
        count_o.polygon_reads = 1'b1;
        if (polygon_front_i) begin
          count_o.polygon_writes = 1'b1;
          polygon_mark_o         = !polygon_active_i;
          insert_o               = 1'b1;
          trace_o.valid          = 1'b1;
          trace_o.number         = number_q;
          trace_o.polygon        = enter_polygon_o;
          trace_o.x              = edge_i.x;
          state_d                = StInsert;
        end else begin
          after_polygon = 1'b1;
        end
      end
      StInsert: begin
        if (insert_full_i) begin
          error_d = vsg_pkg::ErrorSegmentMemoryFull;
          state_d = StIdle;
        end
        after_polygon = insert_done_i;
      end
      default: state_d = StIdle;
    endcase
    if (after_polygon) begin
      if (first_q) begin
        number_d = edge_next_i;
        state_d  = StEdge;
      end else begin
        polygon_read_o = 1'b1;
        first_d        = 1'b1;
        state_d        = StPolygon;
      end
    end
    if (frame_start_i) begin
      state_d = StIdle;
      error_d = vsg_pkg::ErrorNone;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= StIdle;
      number_q <= '0;
      first_q  <= 1'b0;
      error_q  <= vsg_pkg::ErrorNone;
    end else begin
      state_q  <= state_d;
      number_q <= number_d;
      first_q  <= first_d;
      error_q  <= error_d;
    end
  end

  assign error_o = error_q;

endmodule
