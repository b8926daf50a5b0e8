// The two X and two Z registers of figure 21 (chapter III.I): where two lines that change sides between the clip points
// cross. Z is the new line's less the old one's. A step is one add cycle: the sum's half replaces the end whose Z has the
// same sign. Latency: one cycle a step; finished_o when the extent, halved at each step, is used up. Refuses nothing.

module crossing_search (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         load_i,
  input  vsg_pkg::x_t                  x_left_i,     // the clip points
  input  vsg_pkg::x_t                  x_right_i,
  input  logic signed [vsg_pkg::ZW:0]  z_left_i,
  input  logic signed [vsg_pkg::ZW:0]  z_right_i,
  input  logic                         step_i,
  output logic                         finished_o,
  output vsg_pkg::x_t                  crossing_o
);

  vsg_pkg::x_t x_left_d, x_left_q, x_right_d, x_right_q, extent_d, extent_q;
  logic signed [vsg_pkg::ZW:0] z_left_d, z_left_q, z_right_d, z_right_q;

  logic signed [vsg_pkg::XW:0] x_sum;
  logic signed [vsg_pkg::ZW+1:0] z_sum;
  assign x_sum = {x_left_q[vsg_pkg::XW-1], x_left_q} + {x_right_q[vsg_pkg::XW-1], x_right_q};
  assign z_sum = {z_left_q[vsg_pkg::ZW], z_left_q} + {z_right_q[vsg_pkg::ZW], z_right_q};

  always_comb begin
    x_left_d  = x_left_q;
    x_right_d = x_right_q;
    z_left_d  = z_left_q;
    z_right_d = z_right_q;
    extent_d  = extent_q;
    if (load_i) begin
      x_left_d  = x_left_i;
      x_right_d = x_right_i;
      z_left_d  = z_left_i;
      z_right_d = z_right_i;
      extent_d  = x_right_i - x_left_i;
    end else if (step_i) begin
      extent_d = extent_q >>> 1;
      if (z_sum[vsg_pkg::ZW+1] == z_left_q[vsg_pkg::ZW]) begin
        x_left_d = x_sum[vsg_pkg::XW:1];
        z_left_d = z_sum[vsg_pkg::ZW+1:1];
      end else begin
        x_right_d = x_sum[vsg_pkg::XW:1];
        z_right_d = z_sum[vsg_pkg::ZW+1:1];
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      x_left_q  <= '0;
      x_right_q <= '0;
      z_left_q  <= '0;
      z_right_q <= '0;
      extent_q  <= '0;
    end else begin
      x_left_q  <= x_left_d;
      x_right_q <= x_right_d;
      z_left_q  <= z_left_d;
      z_right_q <= z_right_d;
      extent_q  <= extent_d;
    end
  end

  assign finished_o = (extent_q == '0);
  assign crossing_o = x_left_q;

endmodule
