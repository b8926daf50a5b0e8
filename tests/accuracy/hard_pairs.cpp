#include "tests/accuracy/hard_pairs.h"

#include <bit>
#include <cmath>

namespace accuracy {
namespace {

// SplitMix64: the n-th number of a seed without those before it.
uint64_t random_bits(uint64_t seed, uint64_t n) {
  uint64_t z = seed + (n + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

uint32_t bits(double value) { return std::bit_cast<uint32_t>(static_cast<float>(value)); }
double number(uint32_t pattern) { return static_cast<double>(std::bit_cast<float>(pattern)); }

// Sign and fraction of r, exponent within `reach` of zero.
uint32_t moderate(uint64_t r, uint32_t reach) {
  const uint32_t exponent = 127u - reach + static_cast<uint32_t>((r >> 32) % (2u * reach));
  return static_cast<uint32_t>(r & 0x807FFFFFu) | (exponent << 23);
}

}  // namespace

std::vector<uint32_t> hard_values() {
  std::vector<uint32_t> magnitudes = {
      0x00000000u, 0x00000001u, 0x00000002u, 0x00000003u, 0x00000100u, 0x003FFFFFu, 0x00400000u,
      0x007FFFFFu,                                                                                // subnormal
      0x00800000u, 0x00800001u, 0x00FFFFFFu, 0x01000000u, 0x7F000000u, 0x7F7FFFFEu, 0x7F7FFFFFu,  // extremes
      0x7F800000u, 0x7FC00000u, 0x7F800001u, 0x7FFFFFFFu,                                         // no numbers
      0x33800000u, 0x34000000u, 0x39800000u, 0x3F7FFFFEu, 0x3F7FFFFFu, 0x3F800000u, 0x3F800001u,
      0x3F800002u,  // near 1
      0x3F000000u, 0x3EFFFFFFu, 0x3F000001u, 0x3F400000u, 0x3F3FFFFFu, 0x3FC00000u, 0x3FBFFFFFu,
      0x3FC00001u, 0x4B000000u, 0x4AFFFFFFu, 0x4B000001u, 0x4B7FFFFFu, 0x4B7FFFFEu, 0x4B800000u,
      0x4B800001u, 0x4A7FFFFFu,                                                                   // parity
      0x43000000u, 0x42FFFFFFu, 0x43150000u, 0x43160000u, 0x43150001u, 0x42FC0000u, 0x42FE0000u,  // 128, 149...
      0x3F490FDBu, 0x3FC90FDBu, 0x40490FDBu, 0x3F317218u, 0x402DF854u, 0x3FB8AA3Bu, 0x3EAAAAABu,
      0x3DCCCCCDu,  // constants
  };
  for (const double value : {2.0,  3.0,  4.0, 5.0,  7.0,   10.0, 16.0, 100.0, 1000.0, 1.5,  2.5,
                             0.25, 0.75, 0.1, 1e-3, 1e-10, 1e10, 1e20, 1e38,  1e-38,  1e-44}) {
    magnitudes.push_back(bits(value));
  }
  std::vector<uint32_t> values;
  for (const uint32_t magnitude : magnitudes) {
    values.push_back(magnitude);
    values.push_back(magnitude | 0x80000000u);
  }
  return values;
}

Pairs hard_pairs() {
  Pairs pairs;
  const std::vector<uint32_t> values = hard_values();
  for (const uint32_t x : values) {
    for (const uint32_t y : values) {
      pairs.x.push_back(x);
      pairs.y.push_back(y);
    }
  }
  return pairs;
}

Pairs random_pairs(std::string_view function, uint64_t seed, uint64_t first, uint64_t count) {
  Pairs pairs;
  pairs.x.resize(count);
  pairs.y.resize(count);
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t r = random_bits(seed, 2 * (first + i));
    const uint64_t s = random_bits(seed, 2 * (first + i) + 1);
    uint32_t x = static_cast<uint32_t>(r);
    uint32_t y = static_cast<uint32_t>(s);
    const uint64_t kind = (first + i) % 4;
    if (kind != 0) {
      x = moderate(r, kind == 1 ? 8 : 64);
      y = moderate(s, 8);
    }
    if (kind >= 2 &&
        function == "pow") {  // positive, near 1 in half of them; 2^y log2 x from the smallest to the largest
      x &= 0x7FFFFFFFu;
      if (kind == 3) x = 0x3F800000u + static_cast<uint32_t>(static_cast<int32_t>(r) >> (8 + (r >> 32) % 24));
      const double log = std::log2(number(x));
      if (log != 0) y = bits((static_cast<double>(s >> 11) * 0x1p-53 * 290.0 - 155.0) / log);
    }
    pairs.x[i] = x;
    pairs.y[i] = y;
  }
  return pairs;
}

}  // namespace accuracy
