// Shaders compiled from text, and regions of pixels for them.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/shading_node.h"

namespace pfman_tests {

inline std::unique_ptr<pfman::CompiledUnit> compiled(const std::string& text) {
  pfman::Diagnostics diagnostics;
  auto unit = pfman::compile_text(text, "test.pfman", {}, diagnostics);
  if (diagnostics.has_errors()) throw std::invalid_argument(diagnostics.text());
  return unit;
}

/// Pixel memory: a row an address.
class Region {
 public:
  explicit Region(int lanes)
      : rows_(pixelflow::kMemoryBytes, std::vector<std::uint8_t>(static_cast<std::size_t>(lanes))) {}

  /// Bytes that no shader may rely on.
  void fill(std::mt19937_64& random) {
    for (auto& row : rows_) {
      for (std::uint8_t& byte : row) byte = static_cast<std::uint8_t>(random());
    }
  }
  void put(std::size_t lane, int address, int bytes, std::uint64_t value) {
    for (int n = 0; n < bytes; ++n) {
      rows_[static_cast<std::size_t>(address + n)][lane] = static_cast<std::uint8_t>(value >> 8 * n);
    }
  }
  void put_float(std::size_t lane, int address, float value) {
    put(lane, address, 4, std::bit_cast<std::uint32_t>(value));
  }
  void put_id(std::size_t lane, int id) {
    put(lane, pfman::kShaderIdAt, pfman::kShaderIdBytes, static_cast<std::uint64_t>(id));
  }
  std::uint64_t get(std::size_t lane, int address, int bytes) const {
    std::uint64_t value = 0;
    for (int n = 0; n < bytes; ++n) {
      value |= static_cast<std::uint64_t>(rows_[static_cast<std::size_t>(address + n)][lane]) << 8 * n;
    }
    return value;
  }
  int colour(std::size_t lane, int component) const {
    return static_cast<int>(get(lane, pfman::kColorAt + component, 1));
  }

  void write(pixelflow::PixelArray& array) const {
    for (int a = 0; a < pixelflow::kMemoryBytes; ++a) array.write(a, rows_[static_cast<std::size_t>(a)]);
  }
  void read(const pixelflow::PixelArray& array) {
    for (int a = 0; a < pixelflow::kMemoryBytes; ++a) array.read(a, rows_[static_cast<std::size_t>(a)]);
  }
  friend bool operator==(const Region&, const Region&) = default;

 private:
  std::vector<std::vector<std::uint8_t>> rows_;
};

inline Region shaded(pfman::ShadingNode& node, const Region& region, pixelflow::PixelArray& array) {
  region.write(array);
  node.shade(array);
  Region after = region;
  after.read(array);
  return after;
}

}  // namespace pfman_tests
