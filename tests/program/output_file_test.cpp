// An output file is complete or not there.
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/program/run_program.h"

namespace vsg_tests {
namespace {

class OutputFile : public ProgramTest {
 protected:
  void SetUp() override {
    write("scene.toml", flat_scene(16, 16, "[[object]]\ngeometry = \"mesh\"\nfile = \"r.off\"\n"));
    write("r.off", rectangle_off(-0.5, -0.5, 0.5, 0.5));
  }
};

TEST_F(OutputFile, AFailedRunLeavesAnOlderFileAsItWas) {
  write("a.png", "older");
  write("s.json", "older");
  write("broken.toml", "version = 1\nsize = \"large\"\n");
  EXPECT_EQ(run({"render", "broken.toml", "-o", "a.png", "--stats", "s.json"}).status, 1);
  EXPECT_EQ(run({"frame", "broken.toml", "-o", "a.png"}).status, 1);
  EXPECT_EQ(read("a.png"), "older");
  EXPECT_EQ(read("s.json"), "older");
  EXPECT_EQ(files(), (std::vector<std::string>{"a.png", "broken.toml", "r.off", "s.json", "scene.toml"}));

  EXPECT_EQ(run({"render", "scene.toml", "-o", "a.png", "--vsg", "model"}).status, 0);
  EXPECT_EQ(read("a.png").substr(1, 3), "PNG");
}

TEST_F(OutputFile, EveryPlaceOfASequenceIsCheckedBeforeTheFirstPicture) {
  std::filesystem::create_directory(path("a-0003.png"));
  const auto before = files();
  const Outcome folder = run({"render", "scene.toml", "-o", "a-%04d.png", "--frames", "1-3", "--vsg", "model"});
  EXPECT_EQ(folder.status, 1);
  EXPECT_NE(folder.err.find("a-0003.png: error: "), std::string::npos) << folder.err;
  const Outcome twice = run({"render", "scene.toml", "-o", "b-%04d.png", "--frames", "1-2", "--stats", "b-0002.png"});
  EXPECT_EQ(twice.status, 1);
  EXPECT_NE(twice.err.find("named twice"), std::string::npos) << twice.err;
  EXPECT_EQ(files(), before);
}

TEST_F(OutputFile, AnInterruptedRunLeavesNothing) {
  const auto before = files();
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t process = start({"render", "scene.toml", "-o", "a.png", "--vsg", "model", "--size", "1024x1024",
                                 "--samples", "7", "--show", "tests"});
    for (int i = 0; i < 2000 && files() == before; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(process, signal);
    EXPECT_EQ(wait_for(process), 128 + signal);
    EXPECT_EQ(files(), before);
  }
}

TEST_F(OutputFile, ADeviceIsWrittenNotReplaced) {
  EXPECT_EQ(run({"frame", "scene.toml", "-o", "/dev/null"}).status, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(OutputFile, ALinkStaysALink) {
  write("target.frame", "older");
  std::filesystem::create_symlink("target.frame", path("link.frame"));
  EXPECT_EQ(run({"frame", "scene.toml", "-o", "link.frame"}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.frame")));
  EXPECT_EQ(read("target.frame").substr(0, 10), "vsgframe 1");
}

}  // namespace
}  // namespace vsg_tests
