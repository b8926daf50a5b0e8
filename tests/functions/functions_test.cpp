// Microcode of the mathematical functions against their native versions: hard values and random bits, on the golden
// array.

#include "cmodel/pixelflow/native/functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/microcode/library.h"
#include "tests/accuracy/hard_pairs.h"

namespace {

using namespace pixelflow;

constexpr int kLanes = 1024;
constexpr int kRandomRounds = 24;

std::uint64_t seed() {
  const char* text = std::getenv("PIXELFLOW_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 20;
}

struct Function {
  Code code;
  int published;  ///< cycles of table 3; 0 where there is none
};

constexpr Function kFunctions[] = {
    {Code::Sin, 8136},
    {Code::Cos, 8136},
    {Code::Tan, 9325},
    {Code::Asin, 7852},
    {Code::Acos, 7852},
    {Code::Atan, 6641},
    {Code::Exp, 5337},
    {Code::Exp2, 5109},
    {Code::Log, 5776},
    {Code::Log2, 5768},
    {Code::InverseSquareRoot, 0},
    {Code::FastSin, 4564},
    {Code::FastCos, 4877},
    {Code::FastTan, 5265},
    {Code::FastAsin, 4750},
    {Code::FastAcos, 4750},
    {Code::FastAtan, 3534},
    {Code::FastExp, 3786},
    {Code::FastExp2, 3558},
    {Code::FastLog, 2157},
    {Code::FastLog2, 2149},
    {Code::Atan2, 6617},
    {Code::FastAtan2, 3515},
    {Code::Pow, 0},
};

bool is_binary(Code code) { return code == Code::Atan2 || code == Code::FastAtan2 || code == Code::Pow; }

using Words = std::vector<std::uint32_t>;

Words native_results(Code code, const Words& a, const Words& b) {
  Words result(a.size());
  if (is_binary(code)) {
    const auto which = static_cast<std::size_t>(code) - static_cast<std::size_t>(Code::Atan2);
    native::binary_functions()[which].batch(a.data(), b.data(), result.data(), a.size());
  } else {
    const auto which = static_cast<std::size_t>(code) - static_cast<std::size_t>(Code::Sin);
    native::unary_functions()[which].batch(a.data(), result.data(), a.size());
  }
  return result;
}

/// The array's memory as a test sees it: words of four bytes a lane.
class Array {
 public:
  Array() : array_(make_golden_array(Level::Model, kLanes)), bytes_(kLanes) {}

  void put(int address, const Words& words) {
    for (int n = 0; n < 4; ++n) {
      for (int i = 0; i < kLanes; ++i) bytes_[i] = static_cast<std::uint8_t>(words[i] >> (8 * n));
      array_->write(address + n, bytes_);
    }
  }
  Words get(int address) {
    Words words(kLanes);
    for (int n = 0; n < 4; ++n) {
      array_->read(address + n, bytes_);
      for (int i = 0; i < kLanes; ++i) words[i] |= std::uint32_t{bytes_[i]} << (8 * n);
    }
    return words;
  }
  std::vector<std::uint8_t> byte(int address) {
    array_->read(address, bytes_);
    return bytes_;
  }
  void run(const Program& program) { array_->run(program); }

 private:
  std::unique_ptr<PixelArray> array_;
  std::vector<std::uint8_t> bytes_;
};

constexpr int kA = 0, kB = 4, kD = 8, kWork = 16;

Operation operation(Code code) {
  Operation o;
  o.code = code;
  o.a.address = kA;
  o.b.address = kB;
  o.d.address = kD;
  o.work = kWork;
  return o;
}

Program program_of(const Operation& o) {
  Program program;
  append_instructions(program, [](Assembler& a) { a.flag(Flag::E, Bit::One); });
  append(program, o);
  return program;
}

/// Compares lane by lane; false, with a message, at the first difference.
bool same(const Words& a, const Words& b, const Words& got, const Words& wanted) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (got[i] == wanted[i]) continue;
    ADD_FAILURE() << std::hex << "of " << a[i] << ", " << b[i] << ": " << got[i] << ", native " << wanted[i];
    return false;
  }
  return true;
}

class FunctionsOfTwo : public testing::TestWithParam<Function> {};
class Functions : public testing::TestWithParam<Function> {};

TEST_P(Functions, EqualNativeOnHardValues) {
  const Code code = GetParam().code;
  const Program program = program_of(operation(code));
  const accuracy::Pairs pairs = accuracy::hard_pairs();
  Array array;
  std::size_t compared = 0;
  for (std::size_t first = 0; first < pairs.x.size(); first += kLanes) {
    Words a(kLanes), b(kLanes);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t n = std::min(first + i, pairs.x.size() - 1);
      a[i] = pairs.x[n];
      b[i] = pairs.y[n];
    }
    array.put(kA, a);
    array.put(kB, b);
    array.run(program);
    if (!same(a, b, array.get(kD), native_results(code, a, b))) break;
    compared += kLanes;
  }
  EXPECT_GE(compared, pairs.x.size());
}

TEST_P(Functions, EqualNativeOnRandomBits) {
  const Code code = GetParam().code;
  SCOPED_TRACE("PIXELFLOW_SEED=" + std::to_string(seed()));
  std::mt19937_64 random(seed());
  const Program program = program_of(operation(code));
  Array array;
  for (int round = 0; round < kRandomRounds; ++round) {
    const std::string_view kind = code == Code::Pow ? "pow" : "atan2";
    const accuracy::Pairs pairs = accuracy::random_pairs(kind, random(), 0, kLanes);
    array.put(kA, pairs.x);
    array.put(kB, pairs.y);
    array.run(program);
    if (!same(pairs.x, pairs.y, array.get(kD), native_results(code, pairs.x, pairs.y))) break;
  }
}

// Every exponent with three fractions and both signs.
TEST_P(Functions, EqualNativeOnEveryExponent) {
  const Code code = GetParam().code;
  const Program program = program_of(operation(code));
  Array array;
  std::mt19937_64 random(seed());
  for (int part = 0; part < 3; ++part) {
    Words a(kLanes), b(kLanes);
    for (std::uint32_t i = 0; i < kLanes; ++i) {
      const auto bits = static_cast<std::uint32_t>(random());
      a[i] = (i & 0x1FFu) << 23 | (part == 0 ? 0u : part == 1 ? 0x7FFFFFu : bits & 0x7FFFFFu);
      b[i] = part == 2 ? bits : 0x3F800000u + (bits >> 5);
    }
    array.put(kA, a);
    array.put(kB, b);
    array.run(program);
    if (!same(a, b, array.get(kD), native_results(code, a, b))) break;
  }
}

// The result may take an operand's place.
TEST_P(Functions, ResultInPlace) {
  const Code code = GetParam().code;
  const accuracy::Pairs pairs = accuracy::random_pairs("pow", seed(), 0, kLanes);
  for (const int address : {kA, kB}) {
    if (address == kB && !is_binary(code)) continue;
    Operation o = operation(code);
    o.d.address = static_cast<std::uint8_t>(address);
    Array array;
    array.put(kA, pairs.x);
    array.put(kB, pairs.y);
    array.run(program_of(o));
    EXPECT_TRUE(same(pairs.x, pairs.y, array.get(address), native_results(code, pairs.x, pairs.y)));
  }
}

TEST_P(FunctionsOfTwo, UniformOperands) {
  const Code code = GetParam().code;
  const accuracy::Pairs pairs = accuracy::random_pairs("pow", seed(), 0, kLanes);
  for (const std::uint32_t value : {0x40000000u, 0x3FC00000u, 0x80000000u, 0xC0400000u, 0x7F800000u}) {
    for (const bool first : {true, false}) {
      Operation o = operation(code);
      Operand& uniform = first ? o.a : o.b;
      uniform.uniform = true;
      uniform.constant = value;
      Words a = pairs.x, b = pairs.y;
      std::ranges::fill(first ? a : b, value);
      Array array;
      array.put(kA, pairs.x);
      array.put(kB, pairs.y);
      array.run(program_of(o));
      ASSERT_TRUE(same(a, b, array.get(kD), native_results(code, a, b)));
    }
  }
}

// Only the result and the workspace change, and those only where E is set.
TEST_P(Functions, WriteOnlyWhatTheyMay) {
  const Code code = GetParam().code;
  const accuracy::Pairs pairs = accuracy::random_pairs("pow", seed(), 0, kLanes);
  const Operation o = operation(code);
  Program program;
  append_instructions(program, [](Assembler& a) {
    a.alu(Alu::Or, To::M, P::Zero, Q::Port, {.imm = kPortX});
    a.flag_of(Flag::E, P::M, 0);  // every other column
  });
  append(program, o);
  Array array;
  std::mt19937_64 random(seed());
  for (int address = 0; address < kMemoryBytes; address += 4) {
    Words words(kLanes);
    for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(random());
    array.put(address, words);
  }
  array.put(kA, pairs.x);
  array.put(kB, pairs.y);
  std::vector<std::vector<std::uint8_t>> before;
  for (int address = 0; address < kMemoryBytes; ++address) before.push_back(array.byte(address));
  array.run(program);
  const Words wanted = native_results(code, pairs.x, pairs.y);
  const Words got = array.get(kD);
  const int work = workspace_bytes(o);
  for (int address = 0; address < kMemoryBytes; ++address) {
    const std::vector<std::uint8_t> now = array.byte(address);
    const bool may = (address >= kD && address < kD + 4) || (address >= kWork && address < kWork + work);
    for (int i = 0; i < kLanes; ++i) {
      const bool enabled = (i & 1) != 0;
      if (!enabled || !may) {
        ASSERT_EQ(now[i], before[address][i]) << "byte " << address << " of lane " << i;
      }
      if (enabled) {
        ASSERT_EQ(got[i], wanted[i]) << "lane " << i;
      }
    }
  }
}

TEST_P(Functions, CostNoMoreThanHalfOfThePublishedCycles) {
  const Operation o = operation(GetParam().code);
  Program program;
  append(program, o);
  EXPECT_LE(workspace_bytes(o), 40);
  EXPECT_GT(program.cycles(), 0u);
  if (GetParam().published != 0) {
    EXPECT_LE(2 * program.cycles(), static_cast<std::uint64_t>(GetParam().published));
  }
}

INSTANTIATE_TEST_SUITE_P(Microcode, FunctionsOfTwo, testing::ValuesIn(std::end(kFunctions) - 3, std::end(kFunctions)),
                         [](const auto& tested) { return std::string(name(tested.param.code)); });
INSTANTIATE_TEST_SUITE_P(Microcode, Functions, testing::ValuesIn(kFunctions),
                         [](const auto& tested) { return std::string(name(tested.param.code)); });

}  // namespace
