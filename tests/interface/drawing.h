// What the tests of the interface draw with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "watkins/context.h"

namespace interface_tests {

constexpr int kWidth = 64, kHeight = 48;

/// The levels that take the least time; all have the same bits.
inline watkins::Machine fast() {
  watkins::Machine machine;
  machine.generator = watkins::Level::Model;
  machine.pixels = watkins::Level::Macro;
  return machine;
}

/// A small picture of what lies between -2 and 2 in x and -1.5 and 1.5 in y, without perspective.
inline void prepare(watkins::Context& context) {
  context.machine(fast());
  context.size(kWidth, kHeight);
  context.look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  context.orthographic(3, 1, 10);
}

/// A rectangle in the plane z = 0 that faces the eye, with texture coordinates from 0 to 1.
inline void rectangle(watkins::Context& context, double x0, double y0, double x1, double y1) {
  context.begin();
  context.tex_coord(0, 0);
  context.vertex(x0, y0);
  context.tex_coord(1, 0);
  context.vertex(x1, y0);
  context.tex_coord(1, 1);
  context.vertex(x1, y1);
  context.tex_coord(0, 1);
  context.vertex(x0, y1);
  context.end();
}

using Rgb = std::array<int, 3>;

/// The colour at a place of `prepare`'s picture.
inline Rgb at(const watkins::Picture& picture, double x, double y) {
  const int column = static_cast<int>((x + 2) / 4 * kWidth), row = static_cast<int>((1.5 - y) / 3 * kHeight);
  const std::size_t first = 3 * (static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(column));
  const auto bytes = picture.bytes();
  return {bytes.at(first), bytes.at(first + 1), bytes.at(first + 2)};
}

/// A file that is gone at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : folder_(std::filesystem::temp_directory_path() / ("interface_test_" + std::to_string(unique()))),
        path_(folder_ / name) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  static std::uint64_t unique();
  std::filesystem::path folder_, path_;
};

/// Shows parameters as colours: `shown`, a bound vector, plus `shade`, which may be ordinary.
extern const char* const kShowShader;

}  // namespace interface_tests
