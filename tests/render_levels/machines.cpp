#include "tests/render_levels/machines.h"

#include <cstdio>
#include <utility>

namespace render_levels {
namespace {

using nlohmann::json;

void erase_what_may_differ(json& generator) {
  generator.erase("cycles");
  generator.erase("port_accesses");
}

}  // namespace

const Machine kReference = {"--vsg", "model", "--pe", "macro", "--threads", "2"};

std::vector<Machine> all_machines() {
  std::vector<Machine> machines;
  const auto add = [&](const char* generator, const char* pixels, const char* threads, bool lockstep = false) {
    machines.push_back({"--vsg", generator, "--pe", pixels, "--threads", threads});
    if (lockstep) machines.back().push_back("--lockstep");
  };
  add("model", "macro", "1");
  add("model", "macro", "5");
  add("model", "model", "2");
#ifdef VSG_HAVE_RTL
  add("model", "rtl", "1");
  add("rtl", "macro", "2");
  add("rtl", "model", "1");
  add("rtl", "rtl", "5");
  add("rtl", "rtl", "2", true);
#endif
  return machines;
}

#ifdef VSG_HAVE_RTL
Machine lowest_machine() { return {"--vsg", "rtl", "--pe", "rtl"}; }
Machine lowest_pixels() { return {"--vsg", "model", "--pe", "rtl"}; }
#else
Machine lowest_machine() { return {"--vsg", "model", "--pe", "model"}; }
Machine lowest_pixels() { return lowest_machine(); }
#endif

std::string text(const Machine& machine) {
  std::string all;
  for (const std::string& word : machine) all += (all.empty() ? "" : " ") + word;
  return all;
}

json comparable(json statistics) {
  for (json& frame : statistics.at("frames")) {
    frame.erase("times");
    erase_what_may_differ(frame);
    if (!frame.contains("rendering_nodes")) continue;
    for (json& node : frame.at("rendering_nodes")) erase_what_may_differ(node);
  }
  return statistics;
}

std::string differences(const json& is, const json& should) {
  std::string all;
  for (const json& step : json::diff(should, is)) all += step.dump() + "\n";
  return all;
}

Pictures LevelsTest::render(const std::vector<std::string>& arguments, const std::string& frames,
                            const Machine& machine, bool png) const {
  Pictures result;
  for (const std::string suffix : {"exr", "png"}) {
    if (suffix == "png" && !png) continue;
    const std::string place = (frames.empty() ? "picture." : "picture-%04d.") + suffix;
    std::vector<std::string> all = {"render", "-o", place, "--stats", suffix + ".json", "--quiet"};
    if (suffix == "exr") all.push_back("--channels");
    if (!frames.empty()) all.insert(all.end(), {"--frames", frames});
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), machine.begin(), machine.end());
    const vsg_tests::Outcome outcome = run(all);
    EXPECT_EQ(outcome.status, 0) << text(all) << "\n" << outcome.err;
    if (outcome.status != 0) return result;
    for (const std::string& file : files()) {
      if (file.starts_with("picture") && file.ends_with("." + suffix)) {
        result.pictures.push_back(read(file));
        std::filesystem::remove(path(file));
      }
    }
    const json statistics = comparable(json::parse(read(suffix + ".json")));
    if (suffix == "exr") result.statistics = statistics;
    EXPECT_EQ(differences(statistics, result.statistics), "") << text(all) << ": without channels";
  }
  return result;
}

void LevelsTest::expect_same(const Pictures& is, const Pictures& should, const std::string& what) {
  ASSERT_FALSE(should.pictures.empty());
  ASSERT_EQ(is.pictures.size(), should.pictures.size()) << what;
  for (std::size_t n = 0; n < is.pictures.size(); ++n) {
    EXPECT_GT(should.pictures[n].size(), 100u);
    EXPECT_TRUE(is.pictures[n] == should.pictures[n]) << what << ": the bytes of picture file " << n << " differ";
  }
  EXPECT_EQ(differences(is.statistics, should.statistics), "") << what;
}

}  // namespace render_levels
