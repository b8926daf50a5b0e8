// The gates of the comparator, over all inputs: against the golden model, and against the logic equations of the 1970
// program's listing (appendix I, at label 323), written out here from the statement of each.
#include <gtest/gtest.h>

#include "Vsorter_bench.h"
#include "cmodel/vsg/clipper.h"
#include "tests/blocks/bench.h"

namespace blocks {
namespace {

struct Inputs {
  bool left_le, left_ge, right_le, right_ge, nl, ol, nr, orr, exhausted;
};

Inputs inputs_of(unsigned bits) {
  const auto bit = [bits](int i) { return (bits >> i & 1) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6), bit(7), bit(8)};
}

/// Two numbers are at least in one order, and extents that overlap in part never come to the gates.
bool admissible(const Inputs& i) {
  const bool ordered = (i.left_le || i.left_ge) && (i.right_le || i.right_ge);
  return ordered && (i.left_ge || i.right_ge) && (i.left_le || i.right_le);
}

/// The four equations: JCLIP, J1BOX (the new segment is the box), JBOXES, J0BOX (the new segment is hidden).
struct Equations {
  bool clip, one_box, boxes, no_box;
};

Equations listing(const Inputs& i) {
  const bool z = i.exhausted;
  const bool a_left = i.nl, c_left = i.ol, a_right = i.nr, c_right = i.orr;  // new and old behind
  const bool sticks_out = !i.left_ge || !i.right_le;                         // of the box
  const bool box_sticks_out = !i.left_le || !i.right_ge;
  const bool in_box = i.left_ge && i.right_le, over_box = i.left_le && i.right_ge;
  const bool none = !a_left && !c_left && !a_right && !c_right;

  bool clip = sticks_out && ((c_left && !a_right && !c_right) || (!a_left && !c_left && c_right) || none);
  clip |= box_sticks_out && ((a_left && !a_right && !c_right) || (!a_left && !c_left && a_right) || none);
  clip |= in_box && over_box && !(a_left && a_right) && !(c_left && c_right);

  bool no_box = in_box && ((a_left && a_right) || (z && a_left && !c_right) || (z && a_right && !c_left) ||
                           (z && !c_left && !c_right));
  no_box |= z && none && in_box;

  const bool stays = in_box && ((a_left && a_right) || (a_left && !c_right) || (a_right && !c_left));
  bool one_box = over_box && !stays && ((c_left && c_right) || (z && c_left && !a_right) || (z && c_right && !a_left));
  one_box |= z && none && ((i.left_le && !i.right_le) || (!i.left_ge && i.right_ge));

  bool boxes = z && ((a_left && !c_left && !a_right && c_right) || (!a_left && c_left && a_right && !c_right));
  boxes |= sticks_out && ((a_left && !c_left) || (a_right && !c_right));
  boxes |= box_sticks_out && ((c_left && !a_left) || (c_right && !a_right));
  boxes |= z && none && ((!i.left_le && !i.right_le) || (!i.left_ge && !i.right_ge));

  return {clip && !z, one_box, boxes, no_box};
}

unsigned verdict_of_rtl(Bench<Vsorter_bench>& bench, unsigned bits) {
  bench->verdict_i = static_cast<std::uint16_t>(bits);
  bench.settle();
  return bench->verdict_o;
}

TEST(ClipVerdict, EqualsTheGoldenModelOnAllInputs) {
  Bench<Vsorter_bench> bench;
  int compared = 0;
  for (unsigned bits = 0; bits < 512; ++bits, ++compared) {
    const Inputs i = inputs_of(bits);
    const vsg::ClipExtent extent{i.left_le, i.left_ge, i.right_le, i.right_ge};
    ASSERT_EQ(verdict_of_rtl(bench, bits),
              static_cast<unsigned>(vsg::clip_verdict(extent, i.nl, i.ol, i.nr, i.orr, i.exhausted)))
        << "inputs " << bits;
  }
  EXPECT_EQ(compared, 512);
}

TEST(ClipVerdict, EqualsTheListingsEquationsOnAllThatCanCome) {
  Bench<Vsorter_bench> bench;
  int compared = 0;
  for (unsigned bits = 0; bits < 512; ++bits) {
    const Inputs i = inputs_of(bits);
    if (!admissible(i)) continue;
    const Equations e = listing(i);
    ASSERT_EQ(e.clip + e.one_box + e.boxes + e.no_box, 1) << "inputs " << bits;
    const unsigned expected = e.clip ? 0 : e.one_box ? 1 : e.boxes ? 2 : 3;
    ASSERT_EQ(verdict_of_rtl(bench, bits), expected) << "inputs " << bits;
    ++compared;
  }
  EXPECT_EQ(compared, 224);
}

}  // namespace
}  // namespace blocks
