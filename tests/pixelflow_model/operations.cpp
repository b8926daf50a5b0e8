#include "tests/pixelflow_model/operations.h"

namespace pixelflow_tests {

using namespace pixelflow;

std::uint64_t low_bytes(Number value, int bytes) {
  const auto low = static_cast<std::uint64_t>(value);
  return bytes == 8 ? low : low & ((std::uint64_t{1} << (8 * bytes)) - 1);
}

Number number(std::uint64_t raw, int bytes, bool is_signed) {
  const Number value = low_bytes(raw, bytes);
  return is_signed && value >> (8 * bytes - 1) != 0 ? value - (Number{1} << (8 * bytes)) : value;
}

std::vector<std::uint64_t> hard_numbers(std::mt19937_64& random, int count, int bytes) {
  std::vector<std::uint64_t> values;
  for (int n = 0; n < count; ++n) {
    std::uint64_t value = random();
    const std::uint64_t kind = random() % 8, near = random() % 5 - 2;
    if (kind == 0) value = near;
    if (kind == 1) value = (std::uint64_t{1} << random() % 64) + near;
    if (kind == 2) value = (std::uint64_t{1} << (8 * bytes - 1)) + near;
    if (kind == 3) value >>= random() % 64;
    values.push_back(low_bytes(value, bytes));
  }
  return values;
}

std::vector<std::uint64_t> hard_floats(std::mt19937_64& random, int count) {
  constexpr std::uint32_t kSpecial[] = {0x00000000, 0x80000000, 0x00000001, 0x807FFFFF, 0x00800000,
                                        0x3F800000, 0xBF800001, 0x7F7FFFFF, 0xFF7FFFFF, 0x7F800000,
                                        0xFF800000, 0x7FC00000, 0x7F800001, 0xFFFFFFFF, 0x4B000000,
                                        0x3F000000, 0x4F000000, 0xCF000000, 0x33800000, 0x34000000};
  std::vector<std::uint64_t> values;
  for (int n = 0; n < count; ++n) {
    std::uint32_t value = static_cast<std::uint32_t>(random());
    const std::uint64_t kind = random() % 8;
    if (kind == 0) value = kSpecial[random() % std::size(kSpecial)];
    if (kind == 1) value = kSpecial[random() % std::size(kSpecial)] + static_cast<std::uint32_t>(random() % 9) - 4;
    if (kind == 2) value &= 0x807FFFFF;                                    // subnormal
    if (kind >= 3 && kind < 6) value = (value & 0x8FFFFFFF) | 0x38000000;  // near one
    values.push_back(value);
  }
  return values;
}

Elements::Elements(int lanes, Level level) : array_(make_golden_array(level, lanes)) {}

void Elements::put(int address, int bytes, const std::vector<std::uint64_t>& values) {
  std::vector<std::uint8_t> row(values.size());
  for (int byte = 0; byte < bytes; ++byte) {
    for (std::size_t n = 0; n < row.size(); ++n) row[n] = static_cast<std::uint8_t>(values[n] >> (8 * byte));
    array_->write(address + byte, row);
  }
}

std::vector<std::uint64_t> Elements::get(int address, int bytes) const {
  std::vector<std::uint8_t> row(static_cast<std::size_t>(array_->lanes()));
  std::vector<std::uint64_t> values(row.size());
  for (int byte = 0; byte < bytes; ++byte) {
    array_->read(address + byte, row);
    for (std::size_t n = 0; n < row.size(); ++n) values[n] |= static_cast<std::uint64_t>(row[n]) << (8 * byte);
  }
  return values;
}

void Elements::enable(const std::vector<std::uint64_t>& values) {
  put(kEnable, 1, values);
  const Instruction load{.kind = Kind::Flag,
                         .fn = static_cast<std::uint8_t>(Bit::OfQ),
                         .dest = static_cast<std::uint8_t>(Flag::E),
                         .addr = kEnable};
  array_->run({.instructions = {load}, .steps = {Step{.operation = {}, .first = 0, .count = 1}}});
}

void Elements::enable_all() { enable(std::vector<std::uint64_t>(static_cast<std::size_t>(array_->lanes()), 1)); }

void Elements::run(const Operation& operation) {
  array_->run({.instructions = {}, .steps = {Step{.operation = operation}}});
}

}  // namespace pixelflow_tests
