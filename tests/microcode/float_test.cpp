// Float microcode against MPFR: every pair of hard values, and random ones, correctly rounded, subnormals and NaN
// included.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <sstream>

#include "cmodel/pixelflow/macro.h"
#include "tests/microcode/float_oracle.h"
#include "tests/microcode/machine.h"

using namespace pixelflow;
using namespace pixelflow_test;

namespace {

struct Case {
  Code code;
  bool flush;
};

class Float : public testing::TestWithParam<Case> {};

std::string text(const Operation& o, std::uint32_t a, std::uint32_t b) {
  std::ostringstream out;
  out << name(o.code) << (o.flush ? " flushing " : " ") << std::hex << a << " " << b << std::dec << " ("
      << std::bit_cast<float>(a) << ", " << std::bit_cast<float>(b) << ")";
  return out.str();
}

class Tried {
 public:
  Tried(Code code, bool flush) {
    o_.code = code;
    o_.flush = flush;
    o_.d.address = 20;
    o_.a.address = 40;
    o_.b.address = 60;
    o_.work = 100;
    append(program_, o_);
    compares_ = is_comparison(code);
  }
  void check(std::uint32_t a, std::uint32_t b) {
    machine_.put(40, 4, a);
    machine_.put(60, 4, b);
    machine_.run(program_);
    if (compares_) {
      ASSERT_EQ(machine_.element.registers.k, oracle_.compares(o_.code, a, b, o_.flush)) << text(o_, a, b);
    } else {
      ASSERT_EQ(machine_.get(20, 4), oracle_.rounded(o_.code, a, b, o_.flush)) << text(o_, a, b);
    }
  }
  const Program& program() const { return program_; }
  const Operation& operation() const { return o_; }

 private:
  Operation o_;
  Program program_;
  Machine machine_;
  FloatOracle oracle_;
  bool compares_ = false;
};

TEST_P(Float, HardPairs) {
  Tried tried(GetParam().code, GetParam().flush);
  for (const std::uint32_t a : hard_floats()) {
    for (const std::uint32_t b : hard_floats()) {
      tried.check(a, b);
      if (HasFatalFailure()) return;
      if (GetParam().code == Code::FloatSquareRoot) break;
    }
  }
}

TEST_P(Float, RandomPairs) {
  std::mt19937_64 random(seed() + static_cast<unsigned>(GetParam().code));
  Tried tried(GetParam().code, GetParam().flush);
  for (int n = 0; n < 60000; ++n) {
    const auto [a, b] = random_floats(random);
    tried.check(a, b);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Microcode, Float,
    testing::Values(Case{Code::FloatAdd, false}, Case{Code::FloatSub, false}, Case{Code::FloatMultiply, false},
                    Case{Code::FloatDivide, false}, Case{Code::FloatSquareRoot, false}, Case{Code::FloatLess, false},
                    Case{Code::FloatLessEqual, false}, Case{Code::FloatEqual, false}, Case{Code::FloatAdd, true},
                    Case{Code::FloatSub, true}, Case{Code::FloatMultiply, true}, Case{Code::FloatDivide, true},
                    Case{Code::FloatSquareRoot, true}, Case{Code::FloatLess, true}, Case{Code::FloatLessEqual, true},
                    Case{Code::FloatEqual, true}),
    [](const auto& chosen) { return std::string(name(chosen.param.code)) + (chosen.param.flush ? "_flush" : ""); });

/// Operands in place, uniform ones, and E clear.
TEST(FloatOperands, PlacesDoNotMatter) {
  std::mt19937_64 random(seed());
  FloatOracle oracle;
  const Code codes[] = {Code::FloatAdd, Code::FloatSub, Code::FloatMultiply, Code::FloatDivide};
  for (int n = 0; n < 4000; ++n) {
    const auto [a, b] = random_floats(random);
    Operation o;
    o.code = codes[random() % 4];
    o.d.address = 20;
    o.a.address = 40;
    o.b.address = 60;
    o.work = 100;
    const int place = static_cast<int>(random() % 5);
    if (place == 1) o.d.address = 40;
    if (place == 2) o.d.address = 60;
    if (place == 3) o.a.uniform = true, o.a.constant = a;
    if (place == 4) o.b.uniform = true, o.b.constant = b;
    Program program;
    append(program, o);
    Machine machine;
    for (auto& byte : machine.element.memory) byte = static_cast<std::uint8_t>(random());
    machine.put(40, 4, a);
    machine.put(60, 4, b);
    const auto before = machine.element.memory;
    Machine off = machine;
    off.element.registers.e = false;
    off.run(program);
    EXPECT_EQ(off.element.memory, before);
    machine.run(program);
    ASSERT_EQ(machine.get(o.d.address, 4), oracle.rounded(o.code, a, b, false)) << text(o, a, b) << " place " << place;
    for (int byte = 0; byte < kMemoryBytes; ++byte) {
      if ((byte >= o.d.address && byte < o.d.address + 4) || (byte >= 100 && byte < 100 + workspace_bytes(o))) continue;
      ASSERT_EQ(machine.element.memory[static_cast<std::size_t>(byte)], before[static_cast<std::size_t>(byte)])
          << text(o, a, b) << " byte " << byte;
    }
  }
}

TEST(Conversion, FixedToFloat) {
  std::mt19937_64 random(seed());
  FloatOracle oracle;
  for (int round = 0; round < 20000; ++round) {
    Operation o;
    o.code = Code::FixedToFloat;
    o.d.address = 20;
    o.a = {40, static_cast<std::uint8_t>(1 + random() % 8), random() % 2 == 0, false, 0};
    o.scale = static_cast<int>(random() % 193) - 64;
    if (random() % 4 == 0) o.scale = 128;
    o.work = 100;
    const std::uint64_t raw = hard_number(random, 8 * o.a.bytes);
    Program program;
    append(program, o);
    Machine machine;
    machine.put(40, o.a.bytes, raw);
    machine.run(program);
    ASSERT_EQ(machine.get(20, 4), oracle.from_fixed(raw, o.a, o.scale))
        << +o.a.bytes << (o.a.is_signed ? "s " : "u ") << std::hex << raw << std::dec << " scale " << o.scale;
  }
}

TEST(Conversion, FloatToFixed) {
  std::mt19937_64 random(seed() + 1);
  FloatOracle oracle;
  for (int round = 0; round < 20000; ++round) {
    Operation o;
    o.code = Code::FloatToFixed;
    o.a.address = 40;
    o.d = {20, static_cast<std::uint8_t>(1 + random() % 8), random() % 2 == 0, false, 0};
    o.scale = static_cast<int>(random() % 193) - 64;
    o.work = 100;
    std::uint32_t a = random_floats(random).first;
    if (random() % 2) {  // near the ends of d's range
      const int exponent = 127 + 8 * o.d.bytes - o.scale - static_cast<int>(random() % 40);
      a = static_cast<std::uint32_t>(std::min(std::max(exponent, 0), 255)) << 23 | (a & 0x807FFFFF);
    }
    if (random() % 8 == 0) {  // the greatest numbers, moved the furthest
      o.scale = 128 - static_cast<int>(random() % 4);
      a |= 0x7E800000;
      if (random() % 2) a &= 0xFF800000;
    }
    Program program;
    append(program, o);
    Machine machine;
    machine.put(40, 4, a);
    machine.run(program);
    ASSERT_EQ(machine.get(20, o.d.bytes), oracle.to_fixed(a, o.d, o.scale))
        << +o.d.bytes << (o.d.is_signed ? "s " : "u ") << std::hex << a << std::dec << " scale " << o.scale;
  }
}

}  // namespace
