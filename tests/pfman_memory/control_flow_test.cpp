// Where a pixel's control flow goes, construct by construct.
#include <gtest/gtest.h>

#include <algorithm>

#include "pixelflow/compiler/lifetime.h"
#include "tests/pfman_memory/code_builder.h"

namespace pfman_tests {
namespace {

using Kind = CodeBuilder::Kind;
using Edges = std::vector<int>;

struct ControlFlow : testing::Test {
  ControlFlow() : b("flow"), x(b.variable("x", 1)) {}
  int put() { return b.put(x, 1); }
  Edges from(int i) const {
    Edges edges = pfman::successors(b.code)[static_cast<std::size_t>(i)];
    std::sort(edges.begin(), edges.end());
    return edges;
  }
  CodeBuilder b;
  int x;
};

TEST_F(ControlFlow, Straight) {
  const int one = put(), two = put();
  EXPECT_EQ(from(one), Edges{two});
  EXPECT_EQ(from(two), Edges{b.size()});
}

TEST_F(ControlFlow, BranchWithoutElse) {
  for (const Kind kind : {Kind::If, Kind::IfMasked}) {
    const int branch = b.begin_if(kind, b.use(x)), then = put();
    b.end_if(branch);
    EXPECT_EQ(from(branch), (Edges{then, then + 1}));
    EXPECT_EQ(from(then), Edges{then + 1});
  }
}

TEST_F(ControlFlow, BranchWithElse) {
  for (const Kind kind : {Kind::If, Kind::IfMasked}) {
    const int branch = b.begin_if(kind, b.use(x)), then = put();
    const int middle = b.begin_else(branch), other = put();
    b.end_if(middle);
    EXPECT_EQ(from(branch), (Edges{then, other}));
    EXPECT_EQ(from(then), Edges{middle});
    EXPECT_EQ(from(middle), Edges{other + 1});
  }
}

TEST_F(ControlFlow, EmptyBranch) {
  const int branch = b.begin_if(Kind::IfMasked, b.use(x));
  b.end_if(branch);
  EXPECT_EQ(from(branch), Edges{branch + 1});
}

TEST_F(ControlFlow, Loop) {
  const int loop = b.begin_loop();
  b.loop_test(loop, 0);
  const int body = put();
  b.loop_next(loop);
  const int step = put();
  b.end_loop(loop);
  EXPECT_EQ(from(loop + 1), (Edges{body, b.size()}));
  EXPECT_EQ(from(body), Edges{body + 1});
  EXPECT_EQ(from(step), Edges{step + 1});
  EXPECT_EQ(from(step + 1), Edges{loop});
}

TEST_F(ControlFlow, Jumps) {
  const int loop = b.begin_loop(true, true);
  b.jump(Kind::Continue, loop);
  const int continued = b.size() - 1;
  b.jump(Kind::BreakMasked, loop);
  b.jump(Kind::ContinueMasked, loop);
  b.loop_next(loop);
  const int step = b.size() - 1;
  b.loop_test(loop, 0);
  b.end_loop(loop);
  EXPECT_EQ(from(continued), Edges{step});
  EXPECT_EQ(from(continued + 1), Edges{b.size()});
  EXPECT_EQ(from(continued + 2), Edges{step});
}

/// A pixel that waits for its next iteration is still there when the host leaves the loop.
TEST_F(ControlFlow, HostLeavesLoopBehindMaskedContinue) {
  const int loop = b.begin_loop(false, true);
  b.jump(Kind::Break, loop);
  b.jump(Kind::ContinueMasked, loop);
  const int early = b.size() - 1;
  const int branch = b.begin_if(Kind::If);
  b.jump(Kind::Break, loop);
  b.end_if(branch);
  b.jump(Kind::ContinueMasked, loop);
  const int late = b.size() - 1;
  b.loop_next(loop);
  b.end_loop(loop);
  EXPECT_EQ(from(early), (Edges{late + 1, b.size()}));
  EXPECT_EQ(from(late), Edges{late + 1});
}

TEST_F(ControlFlow, IlluminanceIsALoopOverLights) {
  const int pre = put();
  b.stage(1);
  const int illum = b.size() - 1, body = put();
  b.stage(2);
  const int post = b.size() - 1;
  put();
  EXPECT_EQ(from(pre), Edges{illum});
  EXPECT_EQ(from(illum), (Edges{body, post}));
  EXPECT_EQ(from(body), (Edges{illum, post}));
  EXPECT_EQ(from(post), Edges{post + 1});
}

TEST_F(ControlFlow, IlluminanceAtTheEnd) {
  put();
  b.stage(1);
  const int illum = b.size() - 1, body = put();
  EXPECT_EQ(from(illum), (Edges{body, b.size()}));
  EXPECT_EQ(from(body), (Edges{illum, b.size()}));
}

TEST_F(ControlFlow, PredecessorsOfWhatIsNeverReached) {
  const int loop = b.begin_loop(true);
  b.jump(Kind::BreakMasked, loop);
  const int jump = b.size() - 1, behind = put();
  b.loop_next(loop);
  b.end_loop(loop);
  const auto before = pfman::predecessors(pfman::successors(b.code));
  EXPECT_EQ(before[0], (Edges{-1, b.size() - 1}));
  EXPECT_EQ(before[static_cast<std::size_t>(behind)], Edges{jump});
  EXPECT_EQ(before[static_cast<std::size_t>(b.size())], Edges{jump});
}

TEST_F(ControlFlow, MarkersNeedTheirCounterpart) {
  b.add(Kind::EndLoop);
  EXPECT_THROW(pfman::successors(b.code), std::logic_error);
}

}  // namespace
}  // namespace pfman_tests
