// Fixed-point microcode against 128-bit integers: every size, sign, and scale, operands apart, in place and uniform.
#include <gtest/gtest.h>

#include <sstream>

#include "cmodel/pixelflow/macro.h"
#include "tests/microcode/machine.h"

using namespace pixelflow;
using pixelflow_test::hard_number;

namespace {

__extension__ typedef __int128 Int;
__extension__ typedef unsigned __int128 Unsigned;

Int value_of(std::uint64_t raw, const Operand& x) {
  const int bits = 8 * x.bytes;
  const std::uint64_t mask = bits == 64 ? ~0ull : (1ull << bits) - 1;
  raw &= mask;
  if (x.is_signed && raw >> (bits - 1)) return static_cast<Int>(raw) - (static_cast<Int>(1) << bits);
  return static_cast<Int>(raw);
}

Int floor_divide(Int a, Int b) {
  Int q = a / b;
  if (a % b != 0 && (a < 0) != (b < 0)) --q;
  return q;
}

Int root(Unsigned a) {
  Int r = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const Int next = r | static_cast<Int>(1) << bit;
    if (static_cast<Unsigned>(next) * static_cast<Unsigned>(next) <= a) r = next;
  }
  return r;
}

/// What the operation should give, from its description alone.
Int expected(const Operation& o, Int a, Int b) {
  const Int one = 1;
  switch (o.code) {
    case Code::Copy: return a;
    case Code::Add: return a + b;
    case Code::Sub: return a - b;
    case Code::Multiply: return static_cast<Int>(static_cast<Unsigned>(a) * static_cast<Unsigned>(b)) >> (8 * o.scale);
    case Code::Divide: return b == 0 ? 0 : floor_divide(a * (one << (8 * o.scale)), b);
    case Code::Remainder: return b == 0 ? 0 : a - b * floor_divide(a, b);
    case Code::ShiftLeft: return a * (one << o.scale);
    case Code::ShiftRight: return a >> o.scale;
    case Code::SquareRoot: return a < 0 ? 0 : root(static_cast<Unsigned>(a) << o.scale);
    case Code::Wrap: {
      const Int low = a & ((one << o.scale) - 1);
      return o.d.is_signed && low >> (o.scale - 1) ? low - (one << o.scale) : low;
    }
    case Code::Saturate: {
      const Int most = o.d.is_signed ? (one << (o.scale - 1)) - 1 : (one << o.scale) - 1;
      const Int least = o.d.is_signed ? -(one << (o.scale - 1)) : 0;
      return a < least ? least : a > most ? most : a;
    }
    case Code::Less: return a < b;
    case Code::LessEqual: return a <= b;
    case Code::Equal: return a == b;
    default: return 0;
  }
}

std::string text(const Operation& o, std::uint64_t a, std::uint64_t b) {
  std::ostringstream out;
  out << name(o.code) << " d " << +o.d.bytes << (o.d.is_signed ? "s" : "u") << "@" << +o.d.address << " a "
      << +o.a.bytes << (o.a.is_signed ? "s" : "u") << (o.a.uniform ? "!" : "@") << +o.a.address << " b " << +o.b.bytes
      << (o.b.is_signed ? "s" : "u") << (o.b.uniform ? "!" : "@") << +o.b.address << " scale " << o.scale << " values "
      << std::hex << a << " " << b;
  return out.str();
}

bool binary(Code c) {
  return is_comparison(c) || c == Code::Add || c == Code::Sub || c == Code::Multiply || c == Code::Divide ||
         c == Code::Remainder;
}

class Fixed : public testing::TestWithParam<Code> {};

TEST_P(Fixed, EqualsWideIntegers) {
  std::mt19937_64 random(pixelflow_test::seed() + static_cast<unsigned>(GetParam()));
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int ran = 0;
  for (int round = 0; round < 4000; ++round) {
    Operation o;
    o.code = GetParam();
    o.d = {.address = 20, .bytes = static_cast<std::uint8_t>(1 + pick(8)), .is_signed = pick(2) == 1};
    o.a = {.address = 40, .bytes = static_cast<std::uint8_t>(1 + pick(8)), .is_signed = pick(2) == 1};
    o.b = {.address = 60, .bytes = static_cast<std::uint8_t>(1 + pick(8)), .is_signed = pick(2) == 1};
    o.work = 100;
    switch (o.code) {
      case Code::Multiply: o.scale = pick(5); break;
      case Code::Divide: o.scale = pick(std::min(7, 15 - o.a.bytes)); break;
      case Code::ShiftLeft: o.scale = pick(57); break;
      case Code::ShiftRight: o.scale = pick(65); break;
      case Code::SquareRoot: o.scale = pick(8 * o.a.bytes + 1); break;
      case Code::Wrap:
      case Code::Saturate: o.scale = 1 + pick(8 * o.d.bytes); break;
      default: break;
    }
    if (!is_comparison(o.code)) {
      if (pick(4) == 0) o.d.address = o.a.address;
      if (binary(o.code) && pick(4) == 0) o.d.address = o.b.address;
    }
    if (binary(o.code) && pick(5) == 0) o.b.address = o.a.address;
    const int uniform = binary(o.code) ? pick(4) : o.code == Code::Copy ? pick(2) : 3;
    const std::uint64_t raw_a = hard_number(random, 8 * o.a.bytes), raw_b = hard_number(random, 8 * o.b.bytes);
    pixelflow_test::Machine machine;
    for (auto& byte : machine.element.memory) byte = static_cast<std::uint8_t>(random());
    machine.element.registers.w = static_cast<std::uint32_t>(random());
    machine.element.registers.x = static_cast<std::uint8_t>(random());
    machine.element.registers.k = pick(2);
    machine.put(o.a.address, o.a.bytes, raw_a);
    machine.put(o.b.address, o.b.bytes, raw_b);
    Int a = value_of(machine.get(o.a.address, o.a.bytes), o.a), b = value_of(machine.get(o.b.address, o.b.bytes), o.b);
    if (uniform == 0) {
      o.a.uniform = true;
      o.a.constant = static_cast<std::uint64_t>(a);
    } else if (uniform == 1) {
      o.b.uniform = true;
      o.b.constant = static_cast<std::uint64_t>(b);
    }
    Program program;
    ASSERT_NO_THROW(append(program, o)) << text(o, raw_a, raw_b);
    const auto before = machine.element;
    machine.run(program);
    ASSERT_TRUE(machine.element.registers.e);
    Int want = expected(o, a, b);
    if (is_comparison(o.code)) {
      ASSERT_EQ(machine.element.registers.k, want != 0) << text(o, raw_a, raw_b) << " round " << round;
    } else {
      const std::uint64_t mask = o.d.bytes == 8 ? ~0ull : (1ull << (8 * o.d.bytes)) - 1;
      ASSERT_EQ(machine.get(o.d.address, o.d.bytes), static_cast<std::uint64_t>(want) & mask)
          << text(o, raw_a, raw_b) << " round " << round;
    }
    const int work = workspace_bytes(o);
    for (int n = 0; n < kMemoryBytes; ++n) {
      const bool in_d = !is_comparison(o.code) && n >= o.d.address && n < o.d.address + o.d.bytes;
      if (in_d || (n >= o.work && n < o.work + work)) continue;
      ASSERT_EQ(machine.element.memory[static_cast<std::size_t>(n)], before.memory[static_cast<std::size_t>(n)])
          << text(o, raw_a, raw_b) << " byte " << n;
    }
    // Where E is clear nothing at all is written.
    pixelflow_test::Machine off;
    off.element = before;
    off.element.registers.e = false;
    off.run(program);
    ASSERT_EQ(off.element.memory, before.memory) << text(o, raw_a, raw_b);
    ++ran;
  }
  EXPECT_EQ(ran, 4000);
}

INSTANTIATE_TEST_SUITE_P(Microcode, Fixed,
                         testing::Values(Code::Copy, Code::Add, Code::Sub, Code::Multiply, Code::Divide,
                                         Code::Remainder, Code::ShiftLeft, Code::ShiftRight, Code::SquareRoot,
                                         Code::Wrap, Code::Saturate, Code::Less, Code::LessEqual, Code::Equal),
                         [](const auto& chosen) { return std::string(name(chosen.param)); });

}  // namespace
