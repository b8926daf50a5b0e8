// Whoever does the work: the same bytes, the same statistics.
#include <algorithm>
#include <cctype>

#include "scanline/scene.h"
#include "tests/render_levels/machines.h"

namespace render_levels {
namespace {

using vsg_tests::project_file;

/// Every scene of the project, by its place below scenes/.
std::vector<std::string> scenes() {
  const std::filesystem::path folder = project_file("scenes");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().lexically_relative(folder).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

class EveryScene : public LevelsTest, public testing::WithParamInterface<std::string> {
 protected:
  std::string file() const { return project_file("scenes/" + GetParam()); }
  std::vector<std::string> scene() const { return {file(), "--size", "128x96"}; }
};
INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(scenes()), test_name);

TEST_P(EveryScene, IsTheSameAtAllLevels) {
  Pictures reference = render(scene(), "", kReference, true);
  expect_same(render(scene(), "", lowest_pixels(), true), reference, "as PNG");
  reference.pictures.resize(1);
  for (const Machine& machine : all_machines()) expect_same(render(scene(), "", machine), reference, text(machine));
}

TEST_P(EveryScene, IsTheSameAtAllLevelsOnThreeNodes) {
  const std::vector<std::string> nodes = {file(), "--size", "128x96", "--rendering-nodes", "3"};
  const Pictures reference = render(nodes, "", kReference);
  ASSERT_EQ(reference.statistics.at("frames").at(0).at("rendering_nodes").size(), 3u);
  expect_same(render(nodes, "", lowest_machine()), reference, text(lowest_machine()));
}

TEST_P(EveryScene, IsTheSameOnAnyNumberOfShadingNodes) {
  const Pictures reference = render(scene(), "", kReference);
  for (const char* nodes : {"1", "3"}) {
    Pictures other = render({file(), "--size", "128x96", "--shading-nodes", nodes}, "", kReference);
    EXPECT_EQ(other.pictures, reference.pictures) << nodes;
    // Nothing but the time on the real machines depends on them.
    other.statistics.at("frames").at(0).at("real_machines") =
        reference.statistics.at("frames").at(0).at("real_machines");
    EXPECT_EQ(differences(other.statistics, reference.statistics), "") << nodes;
  }
}

TEST_P(EveryScene, MovesInTheSameWayAtAllLevels) {
  const scanline::Scene what = scanline::read_scene_file(file());
  if (what.first_frame == what.last_frame) GTEST_SKIP() << "nothing moves";
  const int last = std::min(what.first_frame + 2, what.last_frame);
  const std::string frames = std::to_string(what.first_frame) + "-" + std::to_string(last);
  const Pictures reference = render(scene(), frames, kReference);
  ASSERT_EQ(reference.pictures.size(), static_cast<unsigned>(last - what.first_frame + 1));
  EXPECT_NE(reference.pictures[0], reference.pictures[1]) << "something moves";
  expect_same(render(scene(), frames, lowest_machine()), reference, text(lowest_machine()));
  const Machine alone = {"--vsg", "model", "--pe", "model", "--threads", "1"};
  expect_same(render(scene(), frames, alone), reference, text(alone));
}

class RenderLevels : public LevelsTest {};

TEST_F(RenderLevels, AreTheSameOnASmallPictureOfSeveralSamples) {
  const std::vector<std::string> small = {project_file("scenes/shapes.toml"), "--size", "40x30", "--samples", "2"};
  const Pictures reference = render(small, "", kReference, true);
  for (const Machine& machine : all_machines()) expect_same(render(small, "", machine, true), reference, text(machine));
}

TEST_F(RenderLevels, DifferingCyclesAreSeen) {
  // A multiplier of eight bits a cycle gives the same bits sooner.
  const std::vector<std::string> small = {project_file("scenes/shapes.toml"), "--size", "40x30"};
  const Pictures slow = render(small, "", kReference);
  Machine quick_multiplier = kReference;
  quick_multiplier.insert(quick_multiplier.end(), {"--multiplier-bits", "8"});
  const Pictures quick = render(small, "", quick_multiplier);
  EXPECT_EQ(quick.pictures, slow.pictures);
  const std::string seen = differences(quick.statistics, slow.statistics);
  EXPECT_NE(seen.find("/frames/0/regions/cycles/illum"), std::string::npos) << seen;
}

TEST_F(RenderLevels, OneByteOrCountThatDiffersIsSeen) {
  const std::vector<std::string> small = {project_file("scenes/shapes.toml"), "--size", "16x12"};
  const Pictures run = render(small, "", kReference);
  Pictures other = run;
  nlohmann::json& count = other.statistics.at("frames").at(0).at("lines").at("segments").at(5);
  count = count.get<int>() + 1;
  EXPECT_NE(differences(other.statistics, run.statistics).find("/frames/0/lines/segments/5"), std::string::npos);
  other = run;
  other.statistics.at("frames").at(0).at("regions").erase("covered");
  EXPECT_NE(differences(other.statistics, run.statistics), "");
  EXPECT_EQ(differences(run.statistics, run.statistics), "");
}

}  // namespace
}  // namespace render_levels
