// vsg render: which pixels, which colours, the same bits every time.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;

constexpr char kRectangle[] =
    "[[object]]\ngeometry = \"mesh\"\nfile = \"r.off\"\nshader = {name = \"flat\", parameters = {color = [1, 0.2, "
    "0]}}\n";
constexpr char kSphere[] =
    "[[object]]\ngeometry = \"shape\"\nshape = \"sphere\"\nradius = 0.75\nsegments = 32\n"
    "shader = {name = \"flat\", parameters = {color = [0, 1, 0]}}\n";

class Render : public ProgramTest {
 protected:
  void render(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--vsg", "model", "--pe", "macro"});
    const Outcome result = run(arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "") << "no progress bar where there is no terminal";
  }
};

void expect_color(const Image& image, int column, int row, const std::vector<float>& color) {
  for (int k = 0; k < 3; ++k) EXPECT_EQ(image.at(column, row, k), color[k]) << column << ", " << row << ", " << k;
}

TEST_F(Render, ARectangleCoversExactlyItsPixels) {
  // In a picture of 8 x 8, pixel column i reaches from x = i / 4 - 1 to (i + 1) / 4 - 1, row j down from 1 - j / 4.
  write("scene.toml", flat_scene(8, 8, kRectangle));
  write("r.off", rectangle_off(-0.5, -0.25, 0.75, 0.5));
  render({"scene.toml", "-o", "a.png"});
  const Image image = read_image(path("a.png"));
  ASSERT_EQ(image.width, 8);
  ASSERT_EQ(image.height, 8);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const bool inside = column >= 2 && column < 7 && row >= 2 && row < 5;
      expect_color(image, column, row, inside ? std::vector<float>{255, 51, 0} : std::vector<float>{0, 0, 255});
    }
  }
}

TEST_F(Render, AFullPictureHasNoBorder) {
  write("scene.toml", flat_scene(6, 4, kRectangle));
  write("r.off", rectangle_off(-3, -3, 3, 3));
  render({"scene.toml", "-o", "a.png"});
  const Image image = read_image(path("a.png"));
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 6; ++column) expect_color(image, column, row, {255, 51, 0});
  }
}

TEST_F(Render, ASphereIsSymmetrical) {
  write("scene.toml", flat_scene(64, 64, kSphere));
  render({"scene.toml", "-o", "a.png"});
  const Image image = read_image(path("a.png"));
  int covered = 0, differing = 0;
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      const bool here = image.at(column, row, 1) > 0;
      covered += here;
      differing += here != (image.at(63 - column, row, 1) > 0);
    }
  }
  // Each end of a row may be a pixel off: the machine fills the pixel in which a left edge starts a span.
  EXPECT_LE(differing, 2 * 64);
  const double circle = 3.14159265 * 24 * 24;
  EXPECT_NEAR(covered, circle, 0.04 * circle);
  EXPECT_EQ(image.at(32, 7, 1), 0);
  EXPECT_GT(image.at(32, 9, 1), 0);
  EXPECT_GT(image.at(32, 54, 1), 0);
  EXPECT_EQ(image.at(32, 56, 1), 0);
}

TEST_F(Render, TheNearerRectangleHidesTheOther) {
  write("scene.toml",
        flat_scene(8, 8,
                   std::string(kRectangle) + "[[object]]\ngeometry = \"mesh\"\nfile = \"far.off\"\n"
                                             "shader = {name = \"flat\", parameters = {color = [1, 1, 1]}}\n"));
  write("r.off", rectangle_off(-0.5, -0.5, 0.5, 0.5, 1));
  write("far.off", rectangle_off(-0.75, -0.75, 0.75, 0.75, -1));
  render({"scene.toml", "-o", "a.png"});
  const Image image = read_image(path("a.png"));
  expect_color(image, 1, 1, {255, 255, 255});
  expect_color(image, 4, 4, {255, 51, 0});
  expect_color(image, 0, 4, {0, 0, 255});
}

TEST_F(Render, FacesThatPointAwayAreNotSeen) {
  write("scene.toml", flat_scene(8, 8, kRectangle));
  write("r.off", rectangle_off(0.5, -0.5, -0.5, 0.5));  // left and right swapped: clockwise
  render({"scene.toml", "-o", "a.png"});
  expect_color(read_image(path("a.png")), 4, 4, {0, 0, 255});
}

TEST_F(Render, DiffuseLightFollowsTheAngle) {
  std::string scene = flat_scene(8, 8, kRectangle);
  scene += "[[light]]\ndirection = [0, -1, -1]\nintensity = 0.5\n";
  scene.replace(scene.find("intensity = 1"), 13, "intensity = 0.25");
  write("scene.toml", scene);
  write("r.off", rectangle_off(-1, -1, 1, 1));
  render({"scene.toml", "-o", "a.png"});
  // 0.25 + 0.5 cos 45 degrees = 0.60355; U(8,8) is the floor of 256 times that, and of a fifth of it.
  expect_color(read_image(path("a.png")), 4, 4, {154, 30, 0});
}

TEST_F(Render, SamplesAreAveraged) {
  // Three quarters of column 2 are covered: with 4 x 4 samples a pixel it is a mixture.
  write("scene.toml", flat_scene(8, 8, kRectangle));
  write("r.off", rectangle_off(-0.4375, -0.5, 0.5, 0.5));
  render({"scene.toml", "-o", "a.exr", "--samples", "4"});
  render({"scene.toml", "-o", "a.png", "--samples", "4"});
  const Image image = read_image(path("a.exr"));
  EXPECT_FLOAT_EQ(image.at(2, 4, 0), 0.75f);
  EXPECT_FLOAT_EQ(image.at(2, 4, 2), 0.25f);
  EXPECT_FLOAT_EQ(image.at(3, 4, 0), 1);
  EXPECT_FLOAT_EQ(image.at(1, 4, 0), 0);
  EXPECT_EQ(read_image(path("a.png")).at(2, 4, 0), 191);
}

TEST_F(Render, ExrHoldsTheBytesWithoutConversion) {
  write("scene.toml", flat_scene(32, 24, kSphere));
  render({"scene.toml", "-o", "a.png"});
  render({"scene.toml", "-o", "a.exr"});
  const Image png = read_image(path("a.png")), exr = read_image(path("a.exr"));
  ASSERT_EQ(png.values.size(), exr.values.size());
  EXPECT_EQ(exr.names, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(exr.formats, (std::vector<std::string>(3, "float")));
  for (std::size_t i = 0; i < png.values.size(); ++i) ASSERT_EQ(exr.values[i], png.values[i] / 255.0f) << i;
}

TEST_F(Render, ChannelsTellWhatIsBehindAPixel) {
  write("scene.toml", flat_scene(8, 8, kRectangle));
  write("r.off", rectangle_off(-0.5, -0.5, 0.5, 0.5, 1));
  render({"scene.toml", "-o", "a.exr", "--channels"});
  const Image image = read_image(path("a.exr"));
  ASSERT_EQ(image.names,
            (std::vector<std::string>{"R", "G", "B", "Z", "polygon", "shader", "normal.x", "normal.y", "normal.z"}));
  EXPECT_EQ(image.formats[4], "uint");
  EXPECT_EQ(image.formats[5], "uint");
  const auto channel = [&](int column, int k) { return image.at(column, 4, k); };
  // The camera stands at z = 5 and sees from 1 to 9 away: a distance of 4 is 3/8 of the depth range of 2^15.
  EXPECT_FLOAT_EQ(channel(4, 3), 32768.0f * 3 / 8);
  EXPECT_FLOAT_EQ(channel(0, 3), 32768.0f);
  EXPECT_EQ(channel(4, 4), 1);
  EXPECT_EQ(channel(0, 4), 0);
  EXPECT_EQ(channel(4, 5), 1);
  EXPECT_EQ(channel(0, 5), 0);
  EXPECT_FLOAT_EQ(channel(4, 8), 1);
  EXPECT_EQ(channel(0, 8), 0);
}

TEST_F(Render, TheSameBytesOnAnyNumberOfThreadsAndAtAnyTime) {
  write("scene.toml", flat_scene(64, 48, kSphere));
  for (const std::string suffix : {"png", "exr"}) {
    std::vector<std::string> extra{"--samples", "2"};
    if (suffix == "exr") extra.push_back("--channels");
    std::vector<std::string> files;
    for (const char* threads : {"1", "2", "7"}) {
      files.push_back("t" + std::string(threads) + "." + suffix);
      std::vector<std::string> arguments{"scene.toml", "-o", files.back(), "--threads", threads};
      arguments.insert(arguments.end(), extra.begin(), extra.end());
      render(arguments);
    }
    EXPECT_GT(read(files[0]).size(), 100u);
    EXPECT_EQ(read(files[1]), read(files[0]));
    EXPECT_EQ(read(files[2]), read(files[0]));
  }
}

TEST_F(Render, NothingIsSaidOfATiffPicture) {
  // Where GDAL has read a TIFF file, it prints what libtiff says.
  write("scene.toml", "version = 1\nsize = [4, 4]\n[[object]]\ngeometry = \"terrain\"\nresolution = 100\nfile = \"" +
                          project_file("scenes/terrain/jacksboro.tif") + "\"\n");
  std::string bytes;
  for (int i = 0; i < 2; ++i) {
    render({"scene.toml", "-o", "a.tif"});
    const Image image = read_image(path("a.tif"));
    EXPECT_EQ(std::make_pair(image.width, image.height), std::make_pair(4, 4));
    if (i == 1) {
      EXPECT_EQ(read("a.tif"), bytes);
    }
    bytes = read("a.tif");
  }
}

TEST_F(Render, ASequenceIsAPictureAFrame) {
  write("scene.toml", flat_scene(16, 16,
                                 kRectangle + std::string("keys = [{frame = 1, translate = [-0.5, 0, 0]}, "
                                                          "{frame = 3, translate = [0.5, 0, 0]}]\n")));
  write("r.off", rectangle_off(-0.25, -0.5, 0.25, 0.5));
  render({"scene.toml", "-o", "a-%04d.png", "--frames", "1-3", "--threads", "3", "--stats", "s.json"});
  EXPECT_EQ(files(),
            (std::vector<std::string>{"a-0001.png", "a-0002.png", "a-0003.png", "r.off", "s.json", "scene.toml"}));
  for (int frame = 1; frame <= 3; ++frame) {
    const Image image = read_image(path("a-000" + std::to_string(frame) + ".png"));
    for (int column = 0; column < 16; ++column) {
      const bool inside = column >= 4 * frame - 2 && column < 4 * frame + 2;
      EXPECT_EQ(image.at(column, 8, 0), inside ? 255 : 0) << frame << ": " << column;
    }
  }
  const json stats = json::parse(read("s.json"));
  ASSERT_EQ(stats["frames"].size(), 3u);
  EXPECT_EQ(stats["frames"][2]["frame"], 3);

  render({"scene.toml", "-o", "b-%04d.png", "--frames", "2-2"});
  EXPECT_EQ(read("b-0002.png"), read("a-0002.png"));
}

TEST_F(Render, FrameCoherenceSamplesAtEdgesOfTheFrameBefore) {
  const std::string scene = project_file("scenes/sequence.toml");
  const Outcome result = run({"render", scene, "-o", "s%04d.png", "--frames", "1-3", "--size", "64x64",
                              "--frame-coherence", "--pe", "macro", "--stats", "s.json"});
  ASSERT_EQ(result.status, 0) << result.err;  // without --vsg: the golden model, which has it
  const json frames = json::parse(read("s.json")).at("frames");
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].at("coherence_samples"), 0);
  EXPECT_GT(frames[1].at("coherence_samples").get<int>(), 0);
  EXPECT_GT(frames[2].at("coherence_samples").get<int>(), 0);

  EXPECT_EQ(run({"render", scene, "-o", "s%04d.png", "--frames", "1-2", "--frame-coherence", "--vsg", "rtl"}).status,
            1);
  EXPECT_EQ(run({"render", scene, "-o", "one.png", "--frame-coherence"}).status, 1);
}

TEST_F(Render, APictureIsNotLeftWithoutItsStatistics) {
  write("scene.toml", flat_scene(8, 8, kRectangle));
  write("r.off", rectangle_off(-0.5, -0.25, 0.75, 0.5));
  const auto before = files();
  const Outcome result =
      run({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--pe", "macro", "--stats", "/dev/full"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("/dev/full: error: cannot write"), std::string::npos) << result.err;
  EXPECT_EQ(files(), before);
}

TEST_F(Render, StatisticsAddUp) {
  write("scene.toml", flat_scene(32, 24, kSphere));
  render({"scene.toml", "-o", "a.png", "--stats", "s.json"});
  const json stats = json::parse(read("s.json"));
  EXPECT_EQ(stats["size"], (json{32, 24}));
  const json frame = stats["frames"][0];
  const auto sum = [](const json& numbers) {
    std::int64_t total = 0;
    for (const auto& n : numbers) total += n.get<std::int64_t>();
    return total;
  };
  ASSERT_EQ(frame["lines"]["references"].size(), 25u);
  EXPECT_EQ(sum(frame["lines"]["references"]), frame["counters"]["segment_references"]);
  EXPECT_EQ(sum(frame["lines"]["segments"]), frame["counters"]["output_segments"]);
  for (const char* key : {"pre_frame", "visible_segments", "shading", "writing"})
    EXPECT_GE(frame["times"][key], 0) << key;
}

#ifdef VSG_HAVE_RTL
TEST_F(Render, RtlInLockstepGivesTheSameBits) {
  write("scene.toml", flat_scene(32, 24, kSphere));
  render({"scene.toml", "-o", "model.png", "--stats", "model.json"});
  const Outcome result = run({"render", "scene.toml", "-o", "rtl.png", "--lockstep", "--stats", "rtl.json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read("rtl.png"), read("model.png"));
  json rtl = json::parse(read("rtl.json")), model = json::parse(read("model.json"));
  EXPECT_GT(rtl["frames"][0]["cycles"], 0);
  for (const char* key : {"cycles", "port_accesses", "times"}) {
    rtl["frames"][0].erase(key);
    model["frames"][0].erase(key);
  }
  EXPECT_EQ(rtl, model);
}

TEST_F(Render, ATraceIsAWaveformAndLeavesNothingElse) {
  write("scene.toml", flat_scene(16, 8, kRectangle));
  write("r.off", rectangle_off(-0.5, -0.5, 0.5, 0.5));
  const Outcome result = run({"render", "scene.toml", "-o", "a.png", "--vsg", "rtl", "--trace", "wave.fst"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"a.png", "r.off", "scene.toml", "wave.fst"}));
  // An FST file begins with its header block: type 0, then the block's length in eight bytes, high byte first.
  constexpr std::size_t kHeaderLength = 329;
  const std::string wave = read("wave.fst");
  ASSERT_GT(wave.size(), 1 + kHeaderLength) << "there are blocks behind the header";
  EXPECT_EQ(wave.substr(0, 9), std::string("\0\0\0\0\0\0\0\x01\x49", 9));
}
#endif

}  // namespace
}  // namespace vsg_tests
