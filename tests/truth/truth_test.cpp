// The oracle on cases that can be worked out by hand, and the golden model against the oracle.
#include <gtest/gtest.h>

#include <sstream>

#include "scanline/golden_generator.h"
#include "tests/truth/comparison.h"
#include "tests/truth/random_frames.h"
#include "tests/truth/visible_spans.h"

namespace truth {

bool operator==(const VisibleSpan& a, const VisibleSpan& b) {
  return a.first == b.first && a.last == b.last && a.polygons == b.polygons;
}
void PrintTo(const VisibleSpan& span, std::ostream* out) {
  *out << span.first << ".." << span.last << ":";
  for (const auto p : span.polygons) *out << " " << p;
}

namespace {

using Spans = std::vector<VisibleSpan>;

ExactFrame read(const std::string& text) {
  std::istringstream in("vsgframe 1\nsize 32 16\n" + text);
  return read_exact_frame(in);
}

Spans line_of(const std::string& text, int line, bool keep_back_faces = true) {
  const ExactFrame frame = read(text);
  return visible_spans(Cutter(frame, keep_back_faces).cuts(line), frame.width);
}

// A rectangle over lines 3 to 12, clockwise, with its own depth at the left and at the right.
std::string rectangle(const char* left, const char* right, const char* left_z, const char* right_z) {
  const auto v = [](const char* x, const char* y, const char* z) {
    return std::string("v ") + x + " " + y + " " + z + "\n";
  };
  return v(left, "2.5", left_z) + v(left, "12.5", left_z) + v(right, "12.5", right_z) + v(right, "2.5", right_z);
}

TEST(TruthOracle, EmptyLinesAreBackground) {
  EXPECT_EQ(line_of(rectangle("4.5", "9.5", "1", "1") + "p 1 2 3 4\n", 13), (Spans{{1, 32, {}}}));
  EXPECT_EQ(line_of(rectangle("4.5", "9.5", "1", "1") + "p 1 2 3 4\n", 2), (Spans{{1, 32, {}}}));
}

TEST(TruthOracle, ARectangleCoversWhatLiesBetweenItsSides) {
  const std::string text = rectangle("4.5", "9.5", "1", "1") + "p 1 2 3 4\n";
  for (const int line : {3, 12}) EXPECT_EQ(line_of(text, line), (Spans{{1, 4, {}}, {5, 9, {1}}, {10, 32, {}}}));
}

TEST(TruthOracle, ASideOnASampleBelongsToTheLeft) {
  EXPECT_EQ(line_of(rectangle("4", "9", "1", "1") + "p 1 2 3 4\n", 5), (Spans{{1, 4, {}}, {5, 9, {1}}, {10, 32, {}}}));
}

TEST(TruthOracle, TheNearerPolygonHidesTheOther) {
  const std::string text =
      rectangle("4.5", "20.5", "5", "5") + rectangle("8.5", "12.5", "2", "2") + "p 1 2 3 4\np 5 6 7 8\n";
  EXPECT_EQ(line_of(text, 6), (Spans{{1, 4, {}}, {5, 8, {1}}, {9, 12, {2}}, {13, 20, {1}}, {21, 32, {}}}));
}

TEST(TruthOracle, PenetratingPolygonsChangeWhereTheyCross) {
  // Depths 0 to 16 and 8 everywhere over the same 16 pixels: they meet at x = 12, where both are seen.
  const std::string text = rectangle("4", "20", "0", "16") + rectangle("4", "20", "8", "8") + "p 1 2 3 4\np 5 6 7 8\n";
  EXPECT_EQ(line_of(text, 6), (Spans{{1, 4, {}}, {5, 11, {1}}, {12, 12, {1, 2}}, {13, 20, {2}}, {21, 32, {}}}));
}

TEST(TruthOracle, ACrossingBetweenSamplesIsExact) {
  // 0 to 3 against 1 over three pixels' width from 4: they meet at x = 5, and at 4 + 1 / 3 * 3 exactly.
  const std::string text =
      rectangle("4", "7", "0", "3") + rectangle("4", "7", "1.000001", "1.000001") + "p 1 2 3 4\np 5 6 7 8\n";
  EXPECT_EQ(line_of(text, 6), (Spans{{1, 4, {}}, {5, 5, {1}}, {6, 7, {2}}, {8, 32, {}}}));
}

TEST(TruthOracle, CoincidentPolygonsAreBothVisible) {
  const std::string text =
      rectangle("4.5", "9.5", "3", "3") + rectangle("6.5", "12.5", "3", "3") + "p 1 2 3 4\np 5 6 7 8\n";
  EXPECT_EQ(line_of(text, 6), (Spans{{1, 4, {}}, {5, 6, {1}}, {7, 9, {1, 2}}, {10, 12, {2}}, {13, 32, {}}}));
}

TEST(TruthOracle, ANonConvexPolygonHasSeveralSpans) {
  const std::string w = "v 2.5 2.5 1\nv 2.5 12.5 1\nv 10.5 4.5 1\nv 18.5 12.5 1\nv 18.5 2.5 1\np 1 2 3 4 5\n";
  EXPECT_EQ(line_of(w, 10), (Spans{{1, 2, {}}, {3, 5, {1}}, {6, 16, {}}, {17, 18, {1}}, {19, 32, {}}}));
  EXPECT_EQ(line_of(w, 3), (Spans{{1, 2, {}}, {3, 18, {1}}, {19, 32, {}}}));
}

TEST(TruthOracle, BackFacesAreLeftOut) {
  const std::string text = rectangle("4.5", "9.5", "1", "1") + "p 4 3 2 1\n";
  EXPECT_EQ(line_of(text, 6, false), (Spans{{1, 32, {}}}));
  EXPECT_EQ(line_of(text, 6, true), (Spans{{1, 4, {}}, {5, 9, {1}}, {10, 32, {}}}));
}

TEST(TruthOracle, BadFramesAreRefused) {
  for (const char* text : {"v 1 2\n", "p 1 2 3\n", "v 1 2 3\nv 1 3 3\np 1 2\n", "w\n"}) {
    EXPECT_THROW(read(text), std::runtime_error) << text;
  }
}

// Answers with a planted fault are told apart from right ones, and the fault is given its kind.
TEST(TruthComparison, PlantedFaultsAreCounted) {
  const ExactFrame frame =
      read(rectangle("4.5", "9.5", "1", "1") + rectangle("20.5", "25.5", "1", "1") + "p 1 2 3 4\np 5 6 7 8\n");
  const auto answer = [](int line_of_fault, int first_end) {
    std::vector<vsg::VisibleSegment> segments;
    for (int line = 1; line <= 16; ++line) {
      if (line < 3 || line > 12) {
        segments.push_back({line, 32, 0});
        continue;
      }
      const int end = line == line_of_fault ? first_end : 4;
      for (const auto& s :
           {vsg::VisibleSegment{line, end, 0}, {line, 9, 1}, {line, 20, 0}, {line, 25, 2}, {line, 32, 0}})
        segments.push_back(s);
    }
    return segments;
  };
  const Comparison right = compare(frame, false, answer(0, 4));
  EXPECT_EQ(right.wrong_total(), 0);
  EXPECT_EQ(right.covered, 100);
  EXPECT_EQ(right.pixels, 512);
  const Comparison start = compare(frame, false, answer(7, 3));
  EXPECT_EQ(start.wrong_total(), 1);
  EXPECT_EQ(start.of(Difference::kStart), 1);
  const Comparison other = compare(frame, false, answer(7, 7));
  EXPECT_EQ(other.wrong_total(), 3);
  EXPECT_EQ(other.of(Difference::kEdge), 1) << "pixel 5 lies beside the edge";
  EXPECT_EQ(other.of(Difference::kOther), 2);
  EXPECT_EQ(other.longest_run, 3);
}

class GoldenModelAgainstTruth : public testing::TestWithParam<std::tuple<FrameKind, int>> {};

TEST_P(GoldenModelAgainstTruth, DiffersOnlyForKnownReasons) {
  const auto [kind, seed] = GetParam();
  const bool keep = keeps_back_faces(kind);
  const scanline::Frame frame = random_frame(kind, static_cast<std::uint64_t>(seed), 96, 24);
  SCOPED_TRACE("seed " + std::to_string(seed));
  scanline::GoldenGenerator generator;
  const auto answer = generator.generate(scanline::make_blocks(frame, generator.parameters(), keep));
  std::stringstream text;
  scanline::write_frame(text, frame);
  const Comparison c = compare(read_exact_frame(text), keep, answer.segments);
  EXPECT_GT(c.covered, 300);
  EXPECT_EQ(c.of(Difference::kOther), 0);
  EXPECT_LT(c.wrong_total(), c.covered / 20);
}

INSTANTIATE_TEST_SUITE_P(Random, GoldenModelAgainstTruth,
                         testing::Combine(testing::Values(FrameKind::kTriangles, FrameKind::kBoxes, FrameKind::kSheets,
                                                          FrameKind::kStars),
                                          testing::Range(1, 51)));

}  // namespace
}  // namespace truth
