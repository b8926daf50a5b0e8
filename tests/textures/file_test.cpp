// Images from files: channels, formats, rows, MIP levels, and what cannot be read.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <random>

#include "scanline/error.h"
#include "tests/pixelflow_model/seed.h"
#include "watkins/texture_file.h"

namespace {

using Image = pfman::TextureMemory::Image;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;
using watkins::read_texture_file;

class TextureFiles : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("vsg_texture_files_") + test->name() + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  /// Values of 0 to 1, the top row first.
  std::filesystem::path write(const std::string& name, int width, int height, int channels, OIIO::TypeDesc format,
                              const std::vector<float>& values) const {
    const std::filesystem::path file = path(name);
    auto out = OIIO::ImageOutput::create(file.string());
    EXPECT_TRUE(out) << name;
    OIIO::ImageSpec spec(width, height, channels, format);
    if (channels == 2) spec.alpha_channel = 1;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_TRUE(out->open(file.string(), spec)) << out->geterror();
    EXPECT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, values.data())) << out->geterror();
    out->close();
    return file;
  }
  std::string mistake(const std::filesystem::path& file) const {
    try {
      read_texture_file(file);
    } catch (const scanline::UserError& error) {
      EXPECT_EQ(error.diagnostics().size(), 1u);
      EXPECT_EQ(error.diagnostics()[0].file, file.string());
      EXPECT_EQ(error.diagnostics()[0].message.find('\n'), std::string::npos);
      return error.diagnostics()[0].message;
    }
    return "";
  }

 private:
  std::filesystem::path folder_;
};

/// Of texel and component as the file has them: the channels of a texel of one, two, three or four or more.
float component_of(const float* texel, int channels, int component) {
  if (channels <= 2) return component < 3 ? texel[0] : channels == 2 ? texel[1] : 1.0f;
  return component < channels ? texel[component] : 1.0f;
}

struct Format {
  std::string suffix;
  OIIO::TypeDesc type;
  int steps;  ///< values between 0 and 1
};

TEST_F(TextureFiles, HaveAnyChannelsFormatsAndSizes) {
  const std::uint64_t seed = seed_or(111);
  std::mt19937_64 random(seed);
  const Format formats[] = {{".png", OIIO::TypeDesc::UINT8, 255},     {".png", OIIO::TypeDesc::UINT16, 65535},
                            {".tif", OIIO::TypeDesc::UINT16, 65535},  {".tif", OIIO::TypeDesc::FLOAT, 1 << 20},
                            {".exr", OIIO::TypeDesc::FLOAT, 1 << 20}, {".exr", OIIO::TypeDesc::HALF, 1024}};
  int number = 0;
  for (const Format& format : formats) {
    for (int channels = 1; channels <= (format.suffix == ".png" ? 4 : 6); ++channels) {
      for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {8, 2}}) {
        std::vector<float> values;
        for (int n = 0; n < width * height * channels; ++n) {
          values.push_back(static_cast<float>(random() % static_cast<unsigned>(format.steps + 1)) /
                           static_cast<float>(format.steps));
        }
        const auto file = write(std::to_string(number++) + format.suffix, width, height, channels, format.type, values);
        const std::vector<Image> levels = read_texture_file(file);
        ASSERT_EQ(levels[0].width, width);
        ASSERT_EQ(levels[0].height, height);
        for (int row = 0; row < height; ++row) {
          for (int column = 0; column < width; ++column) {
            const float* const texel = values.data() + (row * width + column) * channels;
            for (int c = 0; c < 4; ++c) {
              const double exact = 255.0 * component_of(texel, channels, c);
              const int at = ((height - 1 - row) * width + column) * 4 + c;
              ASSERT_LE(std::fabs(levels[0].rgba[static_cast<std::size_t>(at)] - exact), 0.5 + 255.0 / 2048)
                  << file << ", " << channels << " channels, column " << column << ", row " << row << ", " << c << ", "
                  << replay(seed);
            }
          }
        }
        pfman::TextureMemory memory;
        memory.set(1, levels);
        EXPECT_EQ(levels.back().rgba.size(), 4u);
      }
    }
  }
}

/// Every level is the mean of the texels that it covers, of the values before they are rounded to bytes.
TEST_F(TextureFiles, GetLevelsByABoxFilter) {
  const std::uint64_t seed = seed_or(112);
  std::mt19937_64 random(seed);
  for (const auto& [width, height] : {std::pair{16, 16}, {32, 4}, {1, 8}}) {
    std::vector<float> values;
    for (int n = 0; n < width * height * 4; ++n) values.push_back(static_cast<float>(random() % 65536) / 65535);
    const auto file = write("levels.tif", width, height, 4, OIIO::TypeDesc::UINT16, values);
    const std::vector<Image> levels = read_texture_file(file);
    ASSERT_EQ(levels.size(), 1 + static_cast<std::size_t>(std::lround(std::log2(std::max(width, height)))));
    for (std::size_t n = 0; n < levels.size(); ++n) {
      const int columns = std::min(1 << n, width), rows = std::min(1 << n, height);
      ASSERT_EQ(levels[n].width, width / columns);
      ASSERT_EQ(levels[n].height, height / rows);
      for (int y = 0; y < levels[n].height; ++y) {
        for (int x = 0; x < levels[n].width; ++x) {
          for (int c = 0; c < 4; ++c) {
            double sum = 0;
            for (int j = 0; j < rows; ++j) {
              for (int i = 0; i < columns; ++i)
                sum +=
                    values[static_cast<std::size_t>(((height - 1 - y * rows - j) * width + x * columns + i) * 4 + c)];
            }
            const double found = levels[n].rgba[static_cast<std::size_t>((y * levels[n].width + x) * 4 + c)];
            ASSERT_LE(std::fabs(found - 255 * sum / (rows * columns)), 0.501) << n << ", " << replay(seed);
          }
        }
      }
    }
  }
  // Odd sizes: a plane stays one.
  for (const auto& [width, height] : {std::pair{5, 3}, {7, 1}, {9, 13}}) {
    const auto file = write("plane.tif", width, height, 1, OIIO::TypeDesc::UINT8,
                            std::vector<float>(static_cast<std::size_t>(width * height), 77.0f / 255));
    int last = width;
    for (const Image& level : read_texture_file(file)) {
      EXPECT_EQ(level.width, last);
      for (std::size_t n = 0; n < level.rgba.size(); ++n) EXPECT_EQ(level.rgba[n], n % 4 == 3 ? 255 : 77);
      last = std::max(1, last / 2);
    }
  }
}

/// A file of tiles with its own levels, all of one grey, a different one each.
std::filesystem::path write_levels(const std::filesystem::path& file, int width, int height, int rounding) {
  auto out = OIIO::ImageOutput::create(file.string());
  float grey = 0.25f;
  for (bool first = true;; first = false, grey += 0.125f) {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::HALF);
    spec.tile_width = spec.tile_height = 16;
    spec.attribute("textureformat", "Plain Texture");
    spec.attribute("openexr:levelmode", 1);
    spec.attribute("openexr:roundingmode", rounding);
    const auto mode = first ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel;
    EXPECT_TRUE(out->open(file.string(), spec, mode)) << out->geterror();
    const std::vector<float> values(static_cast<std::size_t>(width * height * 3), grey);
    EXPECT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, values.data())) << out->geterror();
    if (width == 1 && height == 1) break;
    width = std::max(1, (width + rounding) / 2);
    height = std::max(1, (height + rounding) / 2);
  }
  out->close();
  return file;
}

TEST_F(TextureFiles, KeepLevelsOfTheirOwn) {
  for (const auto& [width, height, rounding] : {std::array{8, 8, 0}, {5, 3, 0}, {5, 3, 1}}) {
    const std::vector<Image> levels = read_texture_file(write_levels(path("own.exr"), width, height, rounding));
    ASSERT_GE(levels.size(), 3u);
    double grey = 0.25;
    for (const Image& level : levels) {
      EXPECT_EQ(level.rgba[0], std::floor(grey * 255 + 0.5));
      grey += 0.125;
    }
    EXPECT_EQ(levels[1].width, (width + rounding) / 2);
    EXPECT_EQ(levels.back().rgba.size(), 4u);
    pfman::TextureMemory().set(1, levels);
  }
}

TEST_F(TextureFiles, LimitWhatIsNoColour) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto file = write("wild.exr", 4, 2, 1, OIIO::TypeDesc::FLOAT,
                          {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 7, -7, 1e-40f, 0.5f, 1});
  const std::vector<Image> levels = read_texture_file(file);
  const auto grey = [&](std::size_t level, std::size_t texel) {
    return static_cast<int>(levels[level].rgba[texel * 4]);
  };
  const int expected[] = {0, 0, 128, 255, 0, 255, 0, 255};  // the lower row first
  for (std::size_t n = 0; n < 8; ++n) EXPECT_EQ(grey(0, n), expected[n]) << n;
  EXPECT_EQ(grey(1, 0), 64) << "a mean of 0, 1, 0, 0";
  EXPECT_EQ(grey(1, 1), 159) << "of 0, 1, 0.5, 1";
}

/// Colours under a transparent alpha are still there.
TEST_F(TextureFiles, AreNotMultipliedByAlpha) {
  const auto file = write("alpha.png", 1, 1, 4, OIIO::TypeDesc::UINT8, {1, 0.4f, 0.2f, 0});
  EXPECT_EQ(read_texture_file(file)[0].rgba, (std::vector<std::uint8_t>{255, 102, 51, 0}));
}

TEST_F(TextureFiles, ThatCannotBeReadAreNamed) {
  EXPECT_EQ(mistake(path("missing.png")), "cannot read the image: there is no such file");
  EXPECT_EQ(mistake(path("")), "cannot read the image: there is no such file") << "a folder";
  std::ofstream(path("text.png")) << "no picture at all\n";
  std::ofstream(path("empty.exr")).close();
  std::ofstream(path("of_no_format.xyz")) << "P7";
  for (const char* name : {"text.png", "empty.exr", "of_no_format.xyz"}) {
    EXPECT_EQ(mistake(path(name)).rfind("cannot read the image", 0), 0u) << name;
  }
  std::ofstream(path("huge.pgm")) << "P5 5000 5000 255\n";
  EXPECT_EQ(mistake(path("huge.pgm")), "the image has 5000 x 5000 texels, texture memory has room for 16777216");
}

/// Cut off anywhere, or with a byte changed: an image or a mistake, nothing else.
TEST_F(TextureFiles, MayBeDamaged) {
  const std::uint64_t seed = seed_or(113);
  std::mt19937_64 random(seed);
  std::vector<float> values;
  for (int n = 0; n < 40 * 30 * 3; ++n) values.push_back(static_cast<float>(random() % 256) / 255);
  int refused = 0;
  for (const char* suffix : {".png", ".tif", ".exr"}) {
    const auto file = write(std::string("whole") + suffix, 40, 30, 3, OIIO::TypeDesc::HALF, values);
    std::ifstream in(file, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    for (int round = 0; round < 20; ++round) {
      std::string damaged = whole;
      if (round % 2 == 0) {
        damaged.resize(random() % whole.size());
      } else {
        damaged[random() % std::min<std::size_t>(whole.size(), 300)] = static_cast<char>(random());
      }
      const auto copy = path(std::string("damaged") + suffix);
      std::ofstream(copy, std::ios::binary) << damaged;
      try {
        pfman::TextureMemory().set(1, read_texture_file(copy));
      } catch (const scanline::UserError& error) {
        EXPECT_EQ(error.diagnostics().at(0).file, copy.string()) << replay(seed);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 15);
}

}  // namespace
