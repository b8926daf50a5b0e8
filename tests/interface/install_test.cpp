// The installed library as another project finds it: a copy of the example, built against it and run.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace interface_tests {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

struct Image {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  const unsigned char* at(int column, int row) const {
    return &rgb[3 *
                (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column))];
  }
};

Image read_ppm(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string magic;
  int most = 0;
  Image image;
  in >> magic >> image.width >> image.height >> most;
  in.get();
  if (magic != "P6" || most != 255 || image.width < 1 || image.height < 1) return {};
  image.rgb.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
  in.read(reinterpret_cast<char*>(image.rgb.data()), static_cast<std::streamsize>(image.rgb.size()));
  return in ? image : Image{};
}

/// By the ratios of the colours, as light differs from place to place: red bricks 0.62 : 0.16 : 0.10, yellow ones
/// 0.80 : 0.66 : 0.22.
enum class Kind { Red, Yellow, Other };
Kind kind(const unsigned char* c) {
  if (c[0] < 10) return Kind::Other;
  const double green = double{c[1] * 1.0} / c[0], blue = double{c[2] * 1.0} / c[0];
  if (green < 0.4 && blue < 0.35) return Kind::Red;
  if (green > 0.65 && green < 0.95 && blue < 0.45) return Kind::Yellow;
  return Kind::Other;
}

class InterfaceInstalled : public testing::Test {
 protected:
  InterfaceInstalled() : folder_(fs::temp_directory_path() / ("watkins_install_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~InterfaceInstalled() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  /// Runs a command with an environment of its own; what it prints goes to log().
  bool run(const std::string& command) const {
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "/usr/bin:/bin";
    return std::system(("cd " + quoted(folder_) + " && env -i HOME=" + quoted(folder_) + " PATH='" + path + "' " +
                        command + " >> " + quoted(folder_ / "log") + " 2>&1")
                           .c_str()) == 0;
  }
  std::string log() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "log").rdbuf();
    return text.str();
  }
  fs::path folder_;
};

TEST_F(InterfaceInstalled, IsFoundByAnotherProject) {
  const fs::path prefix = folder_ / "prefix";
  ASSERT_TRUE(run(std::string(VSG_CMAKE) + " --install '" VSG_BUILD_DIR "' --prefix " + quoted(prefix))) << log();
  fs::copy(fs::path(VSG_SOURCE_DIR) / "examples" / "walls", folder_ / "walls");
  ASSERT_TRUE(run(std::string(VSG_CMAKE) + " -S walls -B built -DCMAKE_PREFIX_PATH=" + quoted(prefix) +
                  " -DCMAKE_CXX_COMPILER='" VSG_COMPILER "' -DCMAKE_CXX_FLAGS='" VSG_FLAGS "'"))
      << log();
  ASSERT_TRUE(run(std::string(VSG_CMAKE) + " --build built")) << log();
  ASSERT_TRUE(run("built/walls first.ppm")) << log();

  const Image image = read_ppm(folder_ / "first.ppm");
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.height, 200);
  int red[2] = {0, 0}, yellow[2] = {0, 0}, joints[2] = {0, 0};
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const int side = column < image.width / 2 ? 0 : 1;
      const Kind found = kind(image.at(column, row));
      red[side] += found == Kind::Red ? 1 : 0;
      yellow[side] += found == Kind::Yellow ? 1 : 0;
      // From brick to joint, upwards.
      if (row > 0 && (column == 120 || column == 200)) {
        const Kind above = kind(image.at(column, row - 1));
        if (found != Kind::Other && above == Kind::Other) ++joints[side];
      }
    }
  }
  const int half = image.width * image.height / 2;
  EXPECT_GT(red[0], half / 5);
  EXPECT_EQ(yellow[0], 0);
  EXPECT_GT(yellow[1], half / 5);
  EXPECT_EQ(red[1], 0);
  EXPECT_GT(joints[0], 3);
  EXPECT_GT(joints[1], joints[0] + 3);  // thin bricks have more of them

  // It is the installed shaders that are read: where they are others, so is the picture.
  const fs::path brick = prefix / "share" / "watkins" / "shaders" / "simple_brick.pfman";
  ASSERT_TRUE(fs::is_regular_file(brick));
  std::ostringstream text;
  text << std::ifstream(brick).rdbuf();
  std::string changed = text.str();
  const std::size_t at = changed.find("surface_color = mortar_color;");
  ASSERT_NE(at, std::string::npos);
  changed.replace(at, 13, "surface_color = brick_color; //");
  std::ofstream(brick) << changed;
  ASSERT_TRUE(run("built/walls second.ppm")) << log();
  const Image second = read_ppm(folder_ / "second.ppm");
  ASSERT_EQ(second.rgb.size(), image.rgb.size());
  EXPECT_NE(second.rgb, image.rgb);
  EXPECT_TRUE(run("prefix/bin/vsg --version")) << log();
  EXPECT_TRUE(run("prefix/bin/vsg shader " + quoted(brick))) << log();
}

/// Nothing but the public interface's symbols can be seen from outside.
TEST_F(InterfaceInstalled, ShowsItsHeadersSymbolsAlone) {
  ASSERT_TRUE(run("nm -DC --defined-only '" VSG_BUILD_DIR "/libwatkins.so'")) << log();
  std::istringstream lines(log());
  int seen = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool ours = line.find("watkins::Context::") != std::string::npos ||
                      line.find("watkins::Error") != std::string::npos ||
                      line.find("watkins::Picture::bytes") != std::string::npos;
    seen += ours ? 1 : 0;
    for (const char* hidden : {"scanline::", "pfman::", "pixelflow::", "vsg::", "Verilated", "watkins::Renderer"}) {
      EXPECT_EQ(line.find(hidden), std::string::npos) << line;
    }
  }
  EXPECT_GT(seen, 30);
}

}  // namespace
}  // namespace interface_tests
