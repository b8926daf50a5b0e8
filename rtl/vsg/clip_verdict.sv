// The gates of the Depth Comparator (chapter III.G): what the order of the new segment and the visible box at the two clip
// points means. Each wins only over what it covers: the new segment over a box inside its extent, the box over a segment
// inside the box's. Where neither is behind at a clip point the order is open, and clipping goes on until it is
// exhausted. Combinational. Refuses nothing; extents that are neither inside nor covering never come here.

module clip_verdict (
  input  logic                new_left_le_i,     // new left end against the box's
  input  logic                new_left_ge_i,
  input  logic                new_right_le_i,    // and the right ends
  input  logic                new_right_ge_i,
  input  logic                new_behind_left_i,
  input  logic                old_behind_left_i,
  input  logic                new_behind_right_i,
  input  logic                old_behind_right_i,
  input  logic                exhausted_i,
  output vsg_pkg::verdict_e   verdict_o
);

  logic nl, ol, nr, olr, is_inside, covers, same, open_left, open_right, open_both;
  assign nl         = new_behind_left_i;
  assign ol         = old_behind_left_i;
  assign nr         = new_behind_right_i;
  assign olr        = old_behind_right_i;
  assign is_inside     = new_left_ge_i && new_right_le_i;
  assign covers     = new_left_le_i && new_right_ge_i;
  assign same       = is_inside && covers;
  assign open_left  = !nl && !ol;
  assign open_right = !nr && !olr;
  assign open_both  = open_left && open_right;

  logic new_may_win, old_may_win, undecided;
  assign new_may_win = (ol && open_right) || (open_left && olr) || open_both;
  assign old_may_win = (nl && open_right) || (open_left && nr) || open_both;
  assign undecided   = (!is_inside && new_may_win) || (!covers && old_may_win) ||
                       (same && !(nl && nr) && !(ol && olr));

  logic kept_by_old, new_in_front, crossing, boxed, new_behind;
  assign kept_by_old  = is_inside && ((nl && nr) || (nl && !olr) || (nr && !ol));
  assign new_in_front = (covers && !kept_by_old &&
                         ((ol && olr) || (exhausted_i && ((ol && !nr) || (olr && !nl))))) ||
                        (exhausted_i && open_both && !is_inside);
  assign crossing     = exhausted_i && ((nl && !ol && !nr && olr) || (!nl && ol && nr && !olr));
  assign boxed        = crossing || (!is_inside && ((nl && !ol) || (nr && !olr))) ||
                        (!covers && ((ol && !nl) || (olr && !nr)));
  assign new_behind   = is_inside && ((nl && nr) || (exhausted_i && ((nl && !olr) || (nr && !ol) || (!ol && !olr))));

  always_comb begin
    verdict_o = vsg_pkg::VerdictClip;
    if (undecided && !exhausted_i) verdict_o = vsg_pkg::VerdictClip;
    else if (new_in_front) verdict_o = vsg_pkg::VerdictNewInFront;
    else if (boxed) verdict_o = vsg_pkg::VerdictBoxed;
    else if (new_behind) verdict_o = vsg_pkg::VerdictNewBehind;
  end

endmodule
