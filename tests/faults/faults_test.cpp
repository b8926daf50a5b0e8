// Faults planted in the RTL must be caught by lock-step on random frames and on some of the vectors; the machine without a
// fault must pass the same frames.
#include <gtest/gtest.h>

#include "tb/verilated_generator.h"
#include "tests/cmodel/vector_files.h"
#include "tests/faults/faulty_machine.h"
#include "tests/random/random_frames.h"

namespace vsg_tests {
namespace {

constexpr std::uint64_t kFirstSeed = 5000;
constexpr int kFrames = 160;

std::vector<RandomFrame> make_frames() {
  std::vector<RandomFrame> frames;
  for (const char* name : {"stars2003", "stars2055", "comb_star", "quads_penetrate"}) {
    frames.push_back({scanline::read_frame_file(vector_folder() / (std::string(name) + ".frame")), name, true});
  }
  for (int i = 0; i < kFrames; ++i) frames.push_back(random_frame(kFirstSeed + i, 64));
  return frames;
}

/// What lock-step says about the machine with a fault; empty when it passes all frames.
std::string verdict(int fault, int& frames_needed) {
  static const std::vector<RandomFrame> frames = make_frames();
  tb::VerilatedGenerator generator(make_faulty_machine(fault), {.lockstep = true, .trace = {}, .replay = {}});
  frames_needed = 0;
  for (const RandomFrame& random : frames) {
    ++frames_needed;
    try {
      generator.generate(scanline::make_blocks(random.frame, generator.parameters(), random.keep_back_faces));
    } catch (const vsg::LockstepError& error) {
      return error.what();
    } catch (const vsg::FrameError&) {
      // refused by both alike
    }
  }
  return {};
}

TEST(Faults, TheTrueMachinePasses) {
  int frames = 0;
  EXPECT_EQ(verdict(0, frames), "");
  EXPECT_EQ(frames, kFrames + 4);
}

class PlantedFault : public testing::TestWithParam<int> {};

TEST_P(PlantedFault, IsCaught) {
  const auto faults = read_json(std::filesystem::path(VSG_SOURCE_DIR) / "tests/faults/faults.json");
  const auto& fault = faults[GetParam() - 1];
  int frames = 0;
  const std::string caught = verdict(GetParam(), frames);
  EXPECT_NE(caught, "") << "not caught in " << frames << " frames from seed " << kFirstSeed << ": "
                        << fault["name"].get<std::string>() << " (" << fault["file"].get<std::string>() << ")";
  std::printf("%s: %s: caught in frame %d: %s\n", fault["file"].get<std::string>().c_str(),
              fault["name"].get<std::string>().c_str(), frames, caught.substr(0, caught.find('\n')).c_str());
}

INSTANTIATE_TEST_SUITE_P(All, PlantedFault,
                         testing::Range(1, 1 + static_cast<int>(read_json(std::filesystem::path(VSG_SOURCE_DIR) /
                                                                          "tests/faults/faults.json").size())));

}  // namespace
}  // namespace vsg_tests
