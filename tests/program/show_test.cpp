// vsg render --show and vsg explain: what the processor did, drawn and told.
#include <set>
#include <tuple>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

class Show : public ProgramTest {
 protected:
  void SetUp() override {
    write("scene.toml", flat_scene(16, 16,
                                   "[[object]]\ngeometry = \"mesh\"\nfile = \"near.off\"\n"
                                   "[[object]]\ngeometry = \"mesh\"\nfile = \"far.off\"\n"));
    write("near.off", rectangle_off(-0.5, -0.5, 0, 0.5, 1));
    write("far.off", rectangle_off(-0.25, -0.5, 0.5, 0.5, -1));
  }
  Image show(const std::string& what) {
    const Outcome result = run({"render", "scene.toml", "-o", what + ".png", "--vsg", "model", "--show", what});
    EXPECT_EQ(result.status, 0) << result.err;
    return read_image(path(what + ".png"));
  }
};

using Color = std::tuple<float, float, float>;

Color color(const Image& image, int column, int row) {
  return {image.at(column, row, 0), image.at(column, row, 1), image.at(column, row, 2)};
}

constexpr Color kBlack{0, 0, 0};

TEST_F(Show, SegmentsHaveAColourAPolygonAndADarkLastPixel) {
  const Image image = show("segments");
  EXPECT_EQ(color(image, 0, 8), kBlack);
  EXPECT_EQ(color(image, 15, 8), kBlack);
  EXPECT_EQ(color(image, 4, 8), color(image, 6, 8));
  EXPECT_EQ(color(image, 8, 8), color(image, 10, 8));
  EXPECT_NE(color(image, 4, 8), color(image, 8, 8));
  EXPECT_LT(image.at(7, 8, 0), image.at(6, 8, 0)) << "the near rectangle's last pixel";
  EXPECT_LT(image.at(11, 8, 0), image.at(10, 8, 0)) << "the far rectangle's last pixel";
}

TEST_F(Show, SamplesLieOnTheVisibleEdges) {
  const Image image = show("samples");
  constexpr Color kWhite{255, 255, 255};
  // Once the edges are known (below the first line), spans end before each left edge that is visible; the far
  // rectangle's right end is not one, and the last span ends in the guard column beside the picture.
  std::set<int> columns;
  for (int column = 0; column < 16; ++column) {
    if (color(image, column, 8) == kWhite) columns.insert(column);
  }
  EXPECT_EQ(columns, (std::set<int>{3, 7}));
}

TEST_F(Show, TestsAreCountedWhereTheyAreMade) {
  const Image image = show("tests");
  EXPECT_EQ(color(image, 2, 8), kBlack) << "nothing to compare left of the rectangles";
  EXPECT_NE(color(image, 5, 8), kBlack);
  EXPECT_EQ(color(image, 8, 1), kBlack) << "nothing on the lines above them";
}

TEST_F(Show, ReferencesAreCountedWhereTheyAreMade) {
  const Image image = show("references");
  EXPECT_NE(color(image, 5, 8), kBlack);
  EXPECT_EQ(color(image, 8, 1), kBlack);
}

TEST_F(Show, ExplainTellsALine) {
  // A small triangle pierces a large one that slopes away from left to right.
  write("cross.frame",
        "vsgframe 1\nsize 64 64\n"
        "v 4 4 10\nv 4 60 10\nv 60 60 50\nv 60 4 50\n"
        "v 10 4 40\nv 10 60 40\nv 50 60 20\nv 50 4 20\n"
        "p 1 2 3 4\np 5 6 7 8\n");
  const Outcome result = run({"explain", "cross.frame", "--line", "5"});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string& text = result.out;
  for (const char* words :
       {"Scan line 5\n", "Words used here", "1. The Segment Generator", "Edge 1 enters for polygon 1 at x = 4.00.",
        "becomes a segment of polygon 2.", "x 4.00 to 60.00, z 10.00 to 50.00",
        "the first in the span: in front so far (2 add cycles)",
        "neither in front nor behind over the whole span: boxed (2 segments", "they cross",
        "Block 1 is taken from the free list: it becomes an implied edge",
        "They cross at pixel 31: up to there polygon 1 is visible.", "4. Sample points for the next line",
        "     32 to    50  polygon 2\n"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
  const Outcome empty = run({"explain", "cross.frame", "--line", "2"});
  EXPECT_NE(empty.out.find("None begins here."), std::string::npos) << empty.out;
  EXPECT_NE(empty.out.find("    1 to    64  background\n"), std::string::npos) << empty.out;
}

}  // namespace
}  // namespace vsg_tests
