// How the visible box grows when a segment is put into it (figure 15). Ends: the new segment's where it reaches farther.
// Z: with equal extents the quadrants hold both lines clipped to the span, so the box takes the nearer minimum and the
// farther maximum of these; otherwise it takes in the whole of the new segment. The segment in front at the left clip
// point becomes `front`. Combinational. Refuses nothing.

module box_growth (
  input  vsg_pkg::box_t        box_i,
  input  vsg_pkg::candidate_t  candidate_i,
  input  vsg_pkg::pixel_t      left_i,            // candidate clipped to the span
  input  vsg_pkg::pixel_t      right_i,
  input  logic                 same_i,            // equal extents
  input  logic                 left_le_i,
  input  logic                 right_ge_i,
  // quadrants: new segment and box at the left and the right clip point, and which is behind there
  input  vsg_pkg::z_t          new_left_min_i,
  input  vsg_pkg::z_t          new_left_max_i,
  input  vsg_pkg::z_t          new_right_min_i,
  input  vsg_pkg::z_t          new_right_max_i,
  input  vsg_pkg::z_t          old_left_min_i,
  input  vsg_pkg::z_t          old_left_max_i,
  input  vsg_pkg::z_t          old_right_min_i,
  input  vsg_pkg::z_t          old_right_max_i,
  input  logic                 new_rising_i,
  input  logic                 old_rising_i,
  input  logic                 new_behind_left_i,
  input  logic                 old_behind_left_i,
  input  logic                 new_behind_right_i,
  input  logic                 old_behind_right_i,
  output vsg_pkg::box_t        box_o
);

  vsg_pkg::z_t z_left, z_right, box_min, box_max, candidate_min, candidate_max;
  assign z_left        = candidate_i.z_left;
  assign z_right       = candidate_i.z_right;
  assign box_min       = box_i.z_min;
  assign box_max       = box_i.z_max;
  assign candidate_min = new_rising_i ? z_left : z_right;
  assign candidate_max = new_rising_i ? z_right : z_left;

  // Equal slopes' signs: at the side of the minima (`low`) and of the maxima (`high`) the order decides.
  vsg_pkg::z_t low_new, low_old, high_new, high_old;
  logic low_new_behind, low_old_behind, high_new_behind, high_old_behind;
  assign low_new         = new_rising_i ? new_left_min_i : new_right_min_i;
  assign low_old         = new_rising_i ? old_left_min_i : old_right_min_i;
  assign high_new        = new_rising_i ? new_right_max_i : new_left_max_i;
  assign high_old        = new_rising_i ? old_right_max_i : old_left_max_i;
  assign low_new_behind  = new_rising_i ? new_behind_left_i : new_behind_right_i;
  assign low_old_behind  = new_rising_i ? old_behind_left_i : old_behind_right_i;
  assign high_new_behind = new_rising_i ? new_behind_right_i : new_behind_left_i;
  assign high_old_behind = new_rising_i ? old_behind_right_i : old_behind_left_i;

  // Opposite signs: the minima lie at opposite clip points and are compared.
  vsg_pkg::z_t cross_new_min, cross_old_min, cross_new_max, cross_old_max;
  assign cross_new_min = new_rising_i ? new_left_min_i : new_right_min_i;
  assign cross_old_min = new_rising_i ? old_right_min_i : old_left_min_i;
  assign cross_new_max = new_rising_i ? new_right_max_i : new_left_max_i;
  assign cross_old_max = new_rising_i ? old_left_max_i : old_right_max_i;

  vsg_pkg::pixel_t box_edge, candidate_edge;
  assign box_edge       = box_i.edge_inside;
  assign candidate_edge = candidate_i.edge_inside;

  always_comb begin
    box_o          = box_i;
    box_o.segments = box_i.segments + 1'b1;
    if (!same_i) begin
      if (candidate_min < box_min) box_o.z_min = candidate_min;
      if (candidate_max > box_max) box_o.z_max = candidate_max;
    end else if (new_rising_i == old_rising_i) begin
      if (low_new_behind) box_o.z_min = low_old;
      else if (low_old_behind) box_o.z_min = low_new;
      if (high_new_behind) box_o.z_max = high_new;
      else if (high_old_behind) box_o.z_max = high_old;
    end else begin
      box_o.z_min = (cross_new_min < cross_old_min) ? cross_new_min : cross_old_min;
      box_o.z_max = (cross_new_max > cross_old_max) ? cross_new_max : cross_old_max;
    end
    if (left_le_i) box_o.left = left_i;
    if (right_ge_i) box_o.right = right_i;
    if (candidate_edge < box_edge) box_o.edge_inside = candidate_edge;
    box_o.halvings = '0;
    if (new_behind_left_i) begin
      box_o.other         = candidate_i.block;
      box_o.other_polygon = candidate_i.polygon;
    end else begin
      box_o.other         = box_i.front;
      box_o.other_polygon = box_i.front_polygon;
      box_o.front         = candidate_i.block;
      box_o.front_polygon = candidate_i.polygon;
    end
  end

endmodule
