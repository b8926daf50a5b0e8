// Runs the built program as a user would, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vsg_tests {

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal when a signal ended it
  std::string out, err;
};

/// An empty folder for each test, removed afterwards. The program runs inside it.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  Outcome run(const std::vector<std::string>& arguments) const;
  /// Begins a run without waiting for it, output thrown away.
  pid_t start(const std::vector<std::string>& arguments) const;
  static int wait_for(pid_t process);

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  /// Names in the folder, hidden ones too, in order.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path folder_;
};

/// A file of the project.
std::string project_file(const std::string& name);

/// An orthographic scene of the given size that looks along -z at [-1, 1] x [-1, 1], with ambient light only, and the
/// objects that `objects` holds as TOML.
std::string flat_scene(int width, int height, const std::string& objects);

/// A rectangle facing that camera, as an OFF file.
std::string rectangle_off(double left, double bottom, double right, double top, double z = 0);

struct Image {
  int width = 0, height = 0;
  std::vector<std::string> names;
  std::vector<std::string> formats;
  std::vector<float> values;  ///< as stored, channel after channel; bytes as 0 to 255
  float at(int column, int row, int channel) const {
    return values[(static_cast<std::size_t>(row) * width + column) * names.size() + channel];
  }
};

Image read_image(const std::filesystem::path& path);

}  // namespace vsg_tests
