// vsg render --stats: what the real machines would have taken follows from the counts, by the published figures.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

using nlohmann::json;

constexpr double kReference = 200e-9;  // seconds of a reference to a segment (chapter VII.D of the thesis)
constexpr double kCycle = 1 / 100e6;   // of the array (section 5.2 of the paper)
constexpr double kBandwidth = 6.4e9;   // bytes a second of the composition network (section 5.1)
constexpr int kPixels = 128 * 64;      // of a region
constexpr int kPacket = 32;            // bytes

/// Spheres in three regions beside one another; the fourth is empty.
constexpr char kSpheres[] = R"(
[[object]]
geometry = "shape"
shape = "sphere"
radius = 0.5
translate = [-6, 0, 0]
[[object]]
geometry = "shape"
shape = "sphere"
radius = 0.25
translate = [-2, 0, 0]
[[object]]
geometry = "shape"
shape = "sphere"
radius = 0.25
translate = [6, 0, 0]
)";

class Statistics : public ProgramTest {
 protected:
  json frame(const std::vector<std::string>& more) {
    write("scene.toml", flat_scene(4 * 128, 64, kSpheres));
    std::vector<std::string> arguments{"render", "scene.toml", "-o",    "a.png",   "--vsg",
                                       "model",  "--pe",       "macro", "--stats", "s.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(read("s.json")).at("frames").at(0);
  }
  static double shading(const json& regions) {
    double sum = 0;
    for (const char* stage : {"receive", "pre_shade", "pre_illum", "lights", "illum", "post_illum", "send"}) {
      sum += regions.at("cycles").at(stage).get<double>();
    }
    return sum;
  }
};

TEST_F(Statistics, OfTheRealMachinesFollowFromTheCounts) {
  const json frame = this->frame({"--rendering-nodes", "2", "--shading-nodes", "1"});
  const json& regions = frame.at("regions");
  EXPECT_EQ(regions.at("all"), 4);
  EXPECT_EQ(regions.at("covered"), 3);
  EXPECT_EQ(regions.at("samples"), 4 * kPixels);
  EXPECT_EQ(regions.at("surfaces_executed"), 3);
  const json& bytes = regions.at("bytes_a_pixel");
  EXPECT_EQ(bytes.at("sent").get<int>(), bytes.at("packets").get<int>() * kPacket);
  EXPECT_EQ(bytes.at("payload").get<int>(), bytes.at("packets").get<int>() * (kPacket - 4)) << "four bytes of depth";
  EXPECT_EQ(bytes.at("packets"), 1);
  EXPECT_EQ(bytes.at("largest_transfer_map"), 2 + 6);  // ID and normal of the shader `flat`
  EXPECT_EQ(bytes.at("budget"), 142);

  const json& machines = frame.at("real_machines");
  double most = 0;
  ASSERT_EQ(frame.at("rendering_nodes").size(), 2u);
  for (const json& node : frame.at("rendering_nodes")) {
    const double references = node.at("counters").at("segment_references").get<double>();
    EXPECT_GT(references, 0);
    most = std::max(most, references);
  }
  EXPECT_DOUBLE_EQ(machines.at("visible_segments").get<double>(), most * kReference);
  EXPECT_DOUBLE_EQ(machines.at("composition").get<double>(), 3.0 * kPixels * kPacket / kBandwidth);
  const double slowest = regions.at("cycles").at("slowest_region").get<double>();
  ASSERT_EQ(machines.at("shading").size(), 3u);
  for (const json& nodes : machines.at("shading")) {
    const double busiest = nodes.at("busiest").get<double>();
    EXPECT_DOUBLE_EQ(busiest, kCycle * (nodes.at("nodes") == 1 ? shading(regions) : slowest)) << nodes;
    const double longest =
        std::max({busiest, machines.at("visible_segments").get<double>(), machines.at("composition").get<double>()});
    EXPECT_DOUBLE_EQ(nodes.at("frames_a_second").get<double>(), 1 / longest) << nodes;
  }
}

/// What is counted is named as it is: a surface without lights does all its work before them.
TEST_F(Statistics, OfStagesAreThoseOfTheStages) {
  const json cycles = frame({}).at("regions").at("cycles");
  for (const char* stage : {"compose", "receive", "pre_shade", "pre_illum", "send", "slowest_region"}) {
    EXPECT_GT(cycles.at(stage).get<int>(), 0) << stage;
  }
  for (const char* stage : {"lights", "illum"}) EXPECT_EQ(cycles.at(stage), 0) << stage;
}

}  // namespace
}  // namespace vsg_tests
