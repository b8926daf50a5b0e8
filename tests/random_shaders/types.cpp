// Random types, literals and values.
#include <algorithm>
#include <cmath>

#include "tests/random_shaders/context.h"

namespace random_shaders {

std::string spelled(const Number& number) {
  if (number.floating) return "float";
  if (number.is_bool()) return "bool";
  if (number == reference::signed_fixed(32, 0)) return "int";
  return std::string(number.is_signed ? "signed " : "") + "fixed<" + std::to_string(number.size) + "," +
         std::to_string(number.exponent) + ">";
}

Number random_fixed(Random& random) {
  if (random.one_in(8)) return reference::kBool;
  if (random.one_in(8)) return reference::signed_fixed(32, 0);
  const bool is_signed = random.one_in(2);
  const int least = is_signed ? 2 : 1;
  const int size = random.one_in(6) ? random.between(least, 64) : random.between(least, 20);
  int exponent = random.between(0, size);
  if (random.one_in(6)) exponent = random.between(-8, size + 8);
  if (random.one_in(40)) exponent = random.between(-64, 128);
  return {false, is_signed, size, exponent};
}

Number random_type(Random& random) { return random.one_in(3) ? reference::kFloat : random_fixed(random); }

std::string literal_for(Random& random, const Number& number) {
  static const std::vector<std::string> kFloats = {"0.0",     "1.0",   "0.5f", "2",       "-1.25",   "1e-3f",
                                                   "0.1",     "100",   "1e20", "-3e-20",  "1e-42",   "7/3",
                                                   "3.14159", "-0.0f", "0.3f", "(2*0.3)", "16777217"};
  if (number.floating) return random.of(kFloats);
  if (number.is_bool()) return random.one_in(2) ? "true" : "false";
  // A number of a few bits within the range, as an integer or as a quotient of one and a power of two.
  const int room = std::max(0, number.size - (number.is_signed ? 1 : 0));
  const int bits = std::min(room, random.between(1, 20));
  const auto raw = static_cast<std::int64_t>(random.bits() & ((std::uint64_t{1} << bits) - 1));
  const bool negative = number.is_signed && random.one_in(3);
  const double value = std::ldexp(static_cast<double>(raw), -number.exponent);
  std::string digits;
  if (value == std::floor(value) && value < 1e6) {
    digits = std::to_string(static_cast<std::int64_t>(value));
  } else {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.12e", value);
    digits = buffer;
  }
  return negative ? "-" + digits : digits;
}

reference::RawValues random_values(Random& random, const Number& number, int count) {
  static const std::vector<std::uint32_t> kFloats = {
      0x00000000, 0x80000000, 0x3F800000, 0xBF800000, 0x7F800000, 0xFF800000, 0x7FC00000, 0x00000001, 0x807FFFFF,
      0x00800000, 0x7F7FFFFF, 0xFF7FFFFF, 0x3F000000, 0x3F7FFFFF, 0x4B000000, 0xCB000001, 0x4F000000, 0x5F000000};
  reference::RawValues values;
  for (int n = 0; n < count; ++n) {
    if (!number.floating) {
      const std::uint64_t ends[] = {0, 1, ~std::uint64_t{0}, std::uint64_t{1} << (number.size - 1),
                                    (std::uint64_t{1} << (number.size - 1)) - 1};
      const std::uint64_t bits = random.one_in(4)   ? ends[random.below(5)]
                                 : random.one_in(3) ? random.bits() >> random.below(64)
                                                    : random.bits();
      values.push_back(reference::wrapped(bits, number));
      continue;
    }
    const int kind = random.below(8);
    if (kind == 0) {
      values.push_back(random.of(kFloats));
    } else if (kind == 1) {
      const float any = reference::as_float(random.bits() & 0xFFFFFFFF);
      values.push_back(reference::float_bits(any));
    } else {
      // Of moderate size, with some of few bits.
      const auto mantissa = static_cast<float>(static_cast<std::int64_t>(random.bits() >> 40) - (1 << 23));
      const float value =
          kind < 4 ? static_cast<float>(random.between(-64, 64)) / 8 : std::ldexp(mantissa, random.between(-26, -16));
      values.push_back(reference::float_bits(value));
    }
  }
  return values;
}

}  // namespace random_shaders
