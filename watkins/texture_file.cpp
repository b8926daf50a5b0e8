#include "watkins/texture_file.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "scanline/error.h"

namespace watkins {
namespace {

using Image = pfman::TextureMemory::Image;

constexpr int kComponents = 4;

/// A level on its way: rows from the top down, four floats a texel.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> rgba;
};

[[noreturn]] void fail(const std::filesystem::path& path, std::string message) {
  throw scanline::UserError(scanline::Diagnostic{path.string(), 0, 0, std::move(message)});
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, std::string reason) {
  while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.')) reason.pop_back();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  fail(path, "cannot read the image" + (reason.empty() ? "" : ": " + reason));
}

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) fail_to_read(path, "there is no such file");
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // colours stay as they are in the file
  auto input = OIIO::ImageInput::open(path.string(), &wishes);
  if (!input) fail_to_read(path, OIIO::geterror());
  return input;
}

void check(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  if (spec.deep || spec.depth > 1) fail(path, "the image is not flat");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail(path, "the image is empty");
  const std::uint64_t most = pfman::kTextureMemoryBytes / kComponents;
  if (static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) > most) {
    fail(path, "the image has " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                   " texels, texture memory has room for " + std::to_string(most));
  }
}

FloatImage read_level(const std::filesystem::path& path, OIIO::ImageInput& input, int level) {
  const OIIO::ImageSpec spec = input.spec(0, level);
  check(path, spec);
  const int channels = std::min(spec.nchannels, kComponents);
  const auto texels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  std::vector<float> values(texels * static_cast<std::size_t>(channels));
  if (!input.read_image(0, level, 0, channels, OIIO::TypeDesc::FLOAT, values.data())) {
    fail_to_read(path, input.geterror());
  }
  FloatImage image{spec.width, spec.height, std::vector<float>(texels * kComponents, 1.0f)};
  for (std::size_t n = 0; n < texels; ++n) {
    const float* const from = values.data() + n * static_cast<std::size_t>(channels);
    float* const to = image.rgba.data() + n * kComponents;
    if (channels < 3) {
      std::fill_n(to, 3, from[0]);
      if (channels == 2) to[3] = from[1];
    } else {
      std::copy_n(from, channels, to);
    }
  }
  return image;
}

/// How many levels the file has, if each is half of the one before; otherwise 1.
int levels_in(OIIO::ImageInput& input) {
  OIIO::ImageSpec before = input.spec_dimensions(0, 0);
  int count = 1;
  for (; before.width > 1 || before.height > 1; ++count) {
    const OIIO::ImageSpec next = input.spec_dimensions(0, count);
    if (next.format == OIIO::TypeDesc::UNKNOWN) break;
    if (!pfman::is_half(next.width, before.width) || !pfman::is_half(next.height, before.height)) return 1;
    before = next;
  }
  return count;
}

FloatImage halved(const std::filesystem::path& path, FloatImage& image) {
  FloatImage half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  half.rgba.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height) * kComponents);
  const auto around = [](FloatImage& pixels) {
    return OIIO::ImageBuf(OIIO::ImageSpec(pixels.width, pixels.height, kComponents, OIIO::TypeDesc::FLOAT),
                          pixels.rgba.data());
  };
  const OIIO::ImageBuf from = around(image);
  OIIO::ImageBuf to = around(half);
  if (!OIIO::ImageBufAlgo::resize(to, from, "box")) fail(path, "no MIP level can be made: " + to.geterror());
  return half;
}

/// What is no number is black.
std::uint8_t byte_of(float value) {
  if (!(value > 0)) return 0;
  return static_cast<std::uint8_t>(std::floor(std::min(value, 1.0f) * 255.0 + 0.5));
}

Image finished(const FloatImage& image) {
  Image result{image.width, image.height, {}};
  result.rgba.reserve(image.rgba.size());
  const std::size_t row_size = static_cast<std::size_t>(image.width) * kComponents;
  for (std::size_t row = static_cast<std::size_t>(image.height); row-- > 0;) {
    for (std::size_t n = 0; n < row_size; ++n) result.rgba.push_back(byte_of(image.rgba[row * row_size + n]));
  }
  return result;
}

/// Numbers that a mean can be taken of.
void limit(FloatImage& image) {
  for (float& value : image.rgba) value = value > 0 ? std::min(value, 1.0f) : 0.0f;
}

}  // namespace

std::vector<Image> read_texture_file(const std::filesystem::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open(path);
  FloatImage level = read_level(path, *input, 0);
  std::vector<Image> levels = {finished(level)};
  const int in_file = levels_in(*input);
  for (int n = 1; n < in_file; ++n) levels.push_back(finished(read_level(path, *input, n)));
  if (in_file > 1) return levels;
  limit(level);
  while (level.width > 1 || level.height > 1) {
    level = halved(path, level);
    levels.push_back(finished(level));
  }
  return levels;
}

}  // namespace watkins
