// A render that a signal ends leaves what was finished and nothing else; a sequence needs no more memory than a frame.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

std::uint64_t seed() {
  const char* const text = std::getenv("VSG_TEST_SEED");
  return text != nullptr ? std::stoull(text) : 5;
}

class Interruption : public ProgramTest {
 protected:
  void SetUp() override {
    write("scene.toml", flat_scene(64, 48,
                                   "[[object]]\ngeometry = \"shape\"\nshape = \"sphere\"\nradius = 0.75\n"
                                   "keys = [{frame = 1}, {frame = 1000, rotate = [0, 360, 0]}]\n"));
  }
  std::vector<std::string> sequence(const std::string& image, const std::string& frames) const {
    std::vector<std::string> arguments = {"render", "scene.toml", "-o",   image,   "--frames", frames,
                                          "--vsg",  "model",      "--pe", "macro", "--stats",  "s.json"};
    if (image.ends_with("exr")) arguments.push_back("--channels");
    return arguments;
  }
};

TEST_F(Interruption, AtAnyMomentLeavesOnlyWhatIsFinished) {
  SCOPED_TRACE("seed " + std::to_string(seed()) + " (set VSG_TEST_SEED to it)");
  std::mt19937_64 random(seed());
  const auto before = files();
  // One frame, whole, for every one that a run may leave.
  ASSERT_EQ(run(sequence("whole-%04d.exr", "1-12")).status, 0);
  std::filesystem::remove(path("s.json"));
  std::vector<std::string> whole;
  for (int n = 1; n <= 12; ++n) {
    const std::string name = "whole-" + std::string(n < 10 ? "000" : "00") + std::to_string(n) + ".exr";
    whole.push_back(read(name));
    std::filesystem::remove(path(name));
  }
  int finished = 0;
  for (int attempt = 0; attempt < 18; ++attempt) {
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[static_cast<std::size_t>(attempt % 3)];
    const pid_t process = start(sequence("a-%04d.exr", "1-300"));
    // From the first unfinished file on (before it there is nothing to leave), or from the first picture on.
    const bool later = attempt % 2 == 1;
    const auto begun = [&] { return later ? std::filesystem::exists(path("a-0001.exr")) : files() != before; };
    for (int n = 0; n < 20000 && !begun(); ++n) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto wait = std::uniform_int_distribution<int>(0, 200)(random);
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    ::kill(process, signal);
    ASSERT_EQ(wait_for(process), 128 + signal);
    for (const std::string& name : files()) {
      if (name == "scene.toml") continue;
      ASSERT_TRUE(name.starts_with("a-") && name.ends_with(".exr")) << name << " is left after " << wait << " ms";
      const int frame = std::stoi(name.substr(2, 4));
      const bool known = frame <= static_cast<int>(whole.size());
      EXPECT_TRUE(!known || read(name) == whole[static_cast<std::size_t>(frame - 1)]) << name;
      EXPECT_EQ(read_image(path(name)).width, 64) << name;
      ++finished;
      std::filesystem::remove(path(name));
    }
    ASSERT_EQ(files(), before);
  }
  EXPECT_GT(finished, 8);
}

TEST_F(Interruption, OnePictureIsThereWholeOrNotAtAll) {
  SCOPED_TRACE("seed " + std::to_string(seed()) + " (set VSG_TEST_SEED to it)");
  std::mt19937_64 random(seed() + 1);
  const auto before = files();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGINT, SIGTERM, SIGHUP}) {
    const pid_t process = start({"render", "scene.toml", "-o", "a.exr", "--stats", "s.json", "--size", "2000x2000",
                                 "--vsg", "model", "--pe", "model", "--channels"});
    for (int n = 0; n < 20000 && files() == before; ++n) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution<int>(0, 200)(random)));
    ::kill(process, signal);
    ASSERT_EQ(wait_for(process), 128 + signal);
    EXPECT_EQ(files(), before);
  }
}

/// Most memory that a run of the program had, in megabytes.
double peak(const pid_t process) {
  int status = 0;
  rusage usage{};
  if (::wait4(process, &status, 0, &usage) != process || status != 0) return -1;
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

TEST_F(Interruption, AThirtiethFrameNeedsNoMoreMemoryThanTheThird) {
  std::vector<std::string> three = sequence("a-%04d.png", "1-3"), thirty = sequence("a-%04d.png", "1-30");
  for (auto* arguments : {&three, &thirty}) arguments->insert(arguments->end(), {"--threads", "2"});
  const double few = peak(start(three)), many = peak(start(thirty));
  ASSERT_GT(few, 0);
  ASSERT_GT(many, 0);
  // What a frame leaves is its statistics; its picture, frame and segments alone are more than half a megabyte.
  EXPECT_LT(many, few + 6);
}

}  // namespace
}  // namespace vsg_tests
