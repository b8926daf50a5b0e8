// A quadrant of the Depth Comparator (figures 12 and 13): the ends of one line, X relative to one clip point, Z as maximum
// and minimum with the sign bit that tells which end is which. A step is one add cycle: the midpoint replaces the end that
// lies on its side of the clip point. Latency: one cycle. Refuses nothing.

module clip_quadrant (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic            load_i,
  input  vsg_pkg::x_t     x_left_i,
  input  vsg_pkg::x_t     x_right_i,
  input  vsg_pkg::z_t     z_min_i,
  input  vsg_pkg::z_t     z_max_i,
  input  logic            rising_i,   // the left end holds the minimum
  input  logic            step_i,
  output vsg_pkg::z_t     z_min_o,
  output vsg_pkg::z_t     z_max_o,
  output logic            rising_o
);

  vsg_pkg::x_t x_left_d, x_left_q, x_right_d, x_right_q;
  vsg_pkg::z_t z_min_d, z_min_q, z_max_d, z_max_q;
  logic rising_d, rising_q;

  // The two adders; the shift drops the last place.
  logic signed [vsg_pkg::XW:0] x_sum;
  logic signed [vsg_pkg::ZW:0] z_sum;
  assign x_sum = {x_left_q[vsg_pkg::XW-1], x_left_q} + {x_right_q[vsg_pkg::XW-1], x_right_q};
  assign z_sum = {z_min_q[vsg_pkg::ZW-1], z_min_q} + {z_max_q[vsg_pkg::ZW-1], z_max_q};

  vsg_pkg::x_t x_middle;
  vsg_pkg::z_t z_middle;
  logic replaces_left;
  assign x_middle      = x_sum[vsg_pkg::XW:1];
  assign z_middle      = z_sum[vsg_pkg::ZW:1];
  assign replaces_left = x_sum[vsg_pkg::XW];

  always_comb begin
    x_left_d  = x_left_q;
    x_right_d = x_right_q;
    z_min_d   = z_min_q;
    z_max_d   = z_max_q;
    rising_d  = rising_q;
    if (load_i) begin
      x_left_d  = x_left_i;
      x_right_d = x_right_i;
      z_min_d   = z_min_i;
      z_max_d   = z_max_i;
      rising_d  = rising_i;
    end else if (step_i) begin
      if (replaces_left) x_left_d = x_middle;
      else x_right_d = x_middle;
      if (replaces_left == rising_q) z_min_d = z_middle;
      else z_max_d = z_middle;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      x_left_q  <= '0;
      x_right_q <= '0;
      z_min_q   <= '0;
      z_max_q   <= '0;
      rising_q  <= 1'b0;
    end else begin
      x_left_q  <= x_left_d;
      x_right_q <= x_right_d;
      z_min_q   <= z_min_d;
      z_max_q   <= z_max_d;
      rising_q  <= rising_d;
    end
  end

  assign z_min_o  = z_min_q;
  assign z_max_o  = z_max_q;
  assign rising_o = rising_q;

`ifdef FORMAL
  // A clip point between the ends stays between them, and so do the depths.
  logic loaded_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) loaded_q <= 1'b0;
    else if (load_i) loaded_q <= (x_left_i <= 0) && (x_right_i >= 0) && (z_min_i <= z_max_i);
  end
  always_comb begin
    if (rst_ni && loaded_q) begin
      assert (x_left_q <= 0);
      assert (x_right_q >= 0);
      assert (z_min_q <= z_max_q);
    end
  end
`endif

endmodule
