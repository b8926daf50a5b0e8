// The Visible Segment Generator behind a few pins, to place it on an iCE40: its inputs are shifted in bit by bit, its
// outputs shifted out. The trace ports, which serve lock-step alone, are left open, and one counter is asked for: what
// feeds the others goes away in synthesis.

module ice40_top (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic serial_i,
  input  logic load_i,
  output logic serial_o
);

  logic                      frame_start, polygon_valid, polygon_front, edge_valid, run, segment_ready;
  vsg_pkg::line_t            width, height;
  vsg_pkg::edge_t            edge_block;

  logic                      polygon_ready, edge_ready, loading, running, done, segment_valid;
  vsg_pkg::error_e           error;
  vsg_pkg::line_t            line;
  vsg_pkg::visible_segment_t segment;
  vsg_pkg::counter_t         counter;

  localparam int InW = 6 + 2 * vsg_pkg::CoordW + vsg_pkg::EdgeBlockW;
  localparam int OutW = 6 + $bits(error) + vsg_pkg::CoordW + $bits(segment) + vsg_pkg::CountW;

  logic [InW-1:0]  in_q;
  logic [OutW-1:0] out_q;

  assign {frame_start, polygon_valid, polygon_front, edge_valid, run, segment_ready, width, height, edge_block} = in_q;

  always_ff @(posedge clk_i) begin
    in_q <= {in_q[InW-2:0], serial_i};
    if (load_i) begin
      out_q <= {polygon_ready, edge_ready, loading, running, done, segment_valid, error, line, segment, counter};
    end else begin
      out_q <= out_q << 1;
    end
  end
  assign serial_o = out_q[OutW-1];

  vsg u_vsg (
    .clk_i            (clk_i),
    .rst_ni           (rst_ni),
    .frame_start_i    (frame_start),
    .width_i          (width),
    .height_i         (height),
    .polygon_valid_i  (polygon_valid),
    .polygon_ready_o  (polygon_ready),
    .polygon_front_i  (polygon_front),
    .edge_valid_i     (edge_valid),
    .edge_ready_o     (edge_ready),
    .edge_i           (edge_block),
    .run_i            (run),
    .loading_o        (loading),
    .running_o        (running),
    .done_o           (done),
    .error_o          (error),
    .line_o           (line),
    .segment_valid_o  (segment_valid),
    .segment_ready_i  (segment_ready),
    .segment_o        (segment),
    .counter_select_i ('0),
    .counter_o        (counter),
    .trace_edge_o     (),
    .trace_write_o    (),
    .trace_test_o     (),
    .trace_decision_o (),
    .trace_sample_o   (),
    .trace_phase_o    (),
    .trace_counters_o ()
  );

endmodule
