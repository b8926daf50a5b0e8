#include "cmodel/vsg/clipper.h"

namespace vsg {

// A segment wins only over what it covers: the new one over a box inside its extent, the box over a new segment inside
// the box's. At a clip point where neither is behind, the order is open.
ClipVerdict clip_verdict(const ClipExtent& extent, bool nl, bool ol, bool nr, bool orr, bool exhausted) {
  const bool open_left = !nl && !ol, open_right = !nr && !orr, open_both = open_left && open_right;
  const bool inside = extent.inside(), covers = extent.covers();

  const bool new_may_win = (ol && open_right) || (open_left && orr) || open_both;
  const bool old_may_win = (nl && open_right) || (open_left && nr) || open_both;
  const bool undecided = (!inside && new_may_win) || (!covers && old_may_win) || (extent.same() && !(nl && nr) && !(ol && orr));
  if (undecided && !exhausted) return ClipVerdict::kClip;

  const bool new_is_behind = inside && ((nl && nr) || (exhausted && ((nl && !orr) || (nr && !ol) || (!ol && !orr))));
  const bool kept_by_old = inside && ((nl && nr) || (nl && !orr) || (nr && !ol));
  const bool new_in_front = (covers && !kept_by_old && ((ol && orr) || (exhausted && ((ol && !nr) || (orr && !nl))))) ||
                            (exhausted && open_both && !inside);
  if (new_in_front) return ClipVerdict::kNewInFront;

  const bool crossing = exhausted && ((nl && !ol && !nr && orr) || (!nl && ol && nr && !orr));
  const bool boxed = crossing || (!inside && ((nl && !ol) || (nr && !orr))) || (!covers && ((ol && !nl) || (orr && !nr)));
  if (boxed) return ClipVerdict::kBoxed;
  return new_is_behind ? ClipVerdict::kNewBehind : ClipVerdict::kClip;
}

}  // namespace vsg
