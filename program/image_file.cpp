#include "program/image_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "program/refuse.h"

namespace program {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) { refuse(why, path.string()); }

bool is_exr(const fs::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix == ".exr";
}

void save(const fs::path& path, OIIO::ImageSpec spec, OIIO::TypeDesc type, const void* pixels) {
  spec.attribute("DateTime", "");  // otherwise some formats write the time of day, and no two files are the same
  const auto out = OIIO::ImageOutput::create(path.string());
  if (!out) fail(path, "cannot write: " + OIIO::geterror());
  // An empty time of day would be all of the Exif data, which libtiff complains about.
  if (std::string_view(out->format_name()) == "tiff") spec.attribute("tiff:write_exif", 0);
  if (!out->open(path.string(), spec) || !out->write_image(type, pixels) || !out->close()) {
    fail(path, "cannot write: " + out->geterror());
  }
}

void write_bytes(const fs::path& path, const scanline::Picture& picture) {
  const OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::UINT8);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.colors().size());
  for (const float value : picture.colors()) bytes.push_back(static_cast<std::uint8_t>(std::lround(value)));
  save(path, spec, OIIO::TypeDesc::UINT8, bytes.data());
}

// All channels are 32 bits wide, floats or unsigned numbers: a pixel is a row of words.
void write_exr(const fs::path& path, const scanline::Picture& picture, const std::vector<std::string>& shader_names) {
  OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  const std::size_t pixels = static_cast<std::size_t>(picture.width()) * picture.height();
  if (!picture.channels) {
    std::vector<float> values;
    values.reserve(3 * pixels);
    for (const float value : picture.colors()) values.push_back(value / 255.0f);
    save(path, spec, OIIO::TypeDesc::FLOAT, values.data());
    return;
  }

  const scanline::PictureChannels& c = *picture.channels;
  using OIIO::TypeDesc;
  spec.channelnames = {"R", "G", "B", "Z", "polygon", "shader", "normal.x", "normal.y", "normal.z"};
  spec.channelformats = {TypeDesc::FLOAT,  TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::UINT32,
                         TypeDesc::UINT32, TypeDesc::FLOAT, TypeDesc::FLOAT, TypeDesc::FLOAT};
  spec.nchannels = static_cast<int>(spec.channelnames.size());
  spec.z_channel = 3;
  for (std::size_t i = 0; i < shader_names.size(); ++i) {
    spec.attribute("vsg:shader" + std::to_string(i + 1), shader_names[i]);
  }
  std::vector<std::uint32_t> words;
  words.reserve(pixels * spec.nchannels);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (int k = 0; k < 3; ++k) words.push_back(std::bit_cast<std::uint32_t>(picture.colors()[3 * i + k] / 255.0f));
    words.push_back(std::bit_cast<std::uint32_t>(c.depth[i]));
    words.push_back(c.polygon[i]);
    words.push_back(c.shader[i]);
    for (const auto* normal : {&c.normal_x, &c.normal_y, &c.normal_z}) {
      words.push_back(std::bit_cast<std::uint32_t>((*normal)[i]));
    }
  }
  save(path, spec, TypeDesc::UNKNOWN, words.data());  // UNKNOWN: each channel in its own format
}

}  // namespace

void check_image_format(const fs::path& path, bool with_channels) {
  if (!OIIO::ImageOutput::create(path.string())) {
    OIIO::geterror();  // fetched, so that it is not reported later
    fail(path, "no picture format has the suffix '" + path.extension().string() + "' (try .png or .exr)");
  }
  if (with_channels && !is_exr(path)) fail(path, "--channels needs a format that holds them: .exr");
}

void write_image(const fs::path& path, const scanline::Picture& picture, const std::vector<std::string>& shader_names) {
  if (is_exr(path)) {
    write_exr(path, picture, shader_names);
  } else {
    write_bytes(path, picture);
  }
}

}  // namespace program
