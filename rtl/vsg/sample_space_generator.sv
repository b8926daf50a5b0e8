// Sample Space Generator (chapter III.E): the span between two sample points and the edges that lie on its borders.
// Latency: a span 2 cycles after next_i, 3 when the sample list has to be read. Refuses nothing.

module sample_space_generator (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // control
  input  logic                    line_start_i,
  input  logic                    next_i,
  output logic                    done_o,
  // sample list
  output logic                    read_o,
  output vsg_pkg::pixel_t         from_pixel_o,
  input  logic                    sample_valid_i,
  input  vsg_pkg::pixel_t         sample_i,
  // from the depth comparator
  input  logic                    set_left_i,
  input  vsg_pkg::sample_point_t  left_point_i,
  input  logic                    set_right_i,
  input  vsg_pkg::sample_point_t  right_point_i,
  // from the decision processor
  input  logic                    clear_left_i,
  input  logic                    set_implied_i,
  input  vsg_pkg::sample_point_t  implied_point_i,
  input  logic                    subdivide_i,
  input  vsg_pkg::pixel_t         new_right_i,
  // to the depth sorter
  output vsg_pkg::span_t          span_o
);

  vsg_pkg::span_t span_d, span_q;
  logic waiting_d, waiting_q;

  assign from_pixel_o = span_q.right + 1'b1;
  assign read_o       = next_i;
  assign done_o       = waiting_q && sample_valid_i;
  assign span_o       = span_q;

  always_comb begin
    span_d    = span_q;
    waiting_d = waiting_q;
    if (line_start_i) begin
      span_d.right          = '0;
      span_d.right[0]       = 1'b1;  // the left border of the screen
      span_d.at_right.pixel = '0;
    end
    if (next_i) begin
      span_d.left           = span_q.right + 1'b1;
      span_d.at_left        = span_q.at_right;
      span_d.at_right.pixel = '0;
      waiting_d             = 1'b1;
    end
    if (waiting_q && sample_valid_i) begin
      span_d.right = sample_i;
      waiting_d    = 1'b0;
    end
    if (set_left_i) span_d.at_left = left_point_i;
    if (set_right_i) span_d.at_right = right_point_i;
    if (set_implied_i) span_d.at_left = implied_point_i;
    if (clear_left_i) span_d.at_left.pixel = '0;
    if (subdivide_i) begin
      span_d.at_right.pixel = '0;
      span_d.right          = new_right_i;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      span_q    <= '0;
      waiting_q <= 1'b0;
    end else begin
      span_q    <= span_d;
      waiting_q <= waiting_d;
    end
  end

endmodule
