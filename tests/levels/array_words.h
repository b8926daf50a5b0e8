// 32-bit numbers in and out of an array's elements, four bytes of memory each, least significant first.
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"

namespace pixelflow_tests {

/// One word an element; `words` holds as many as the array has.
inline void put_words(pixelflow::PixelArray& array, int address, const std::vector<std::uint32_t>& words) {
  std::vector<std::uint8_t> bytes(words.size());
  for (int n = 0; n < 4; ++n) {
    for (std::size_t i = 0; i < words.size(); ++i) bytes[i] = static_cast<std::uint8_t>(words[i] >> (8 * n));
    array.write(address + n, bytes);
  }
}

inline std::vector<std::uint32_t> get_words(const pixelflow::PixelArray& array, int address) {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(array.lanes()));
  std::vector<std::uint8_t> bytes(words.size());
  for (int n = 0; n < 4; ++n) {
    array.read(address + n, bytes);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= std::uint32_t{bytes[i]} << (8 * n);
  }
  return words;
}

}  // namespace pixelflow_tests
