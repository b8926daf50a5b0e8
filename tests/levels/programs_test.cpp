// Random programs of the microcode library leave the same bytes and count the same cycles at every level of modelling:
// every operation, numbers of all sizes and signs, results that are operands of what follows, elements enabled and not.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cmodel/pixelflow/macro.h"
#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/microcode/library.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

using namespace pixelflow;

namespace {

constexpr int kLanes = kElements;
constexpr int kSlots = 9;  // places of numbers, 16 bytes each: three coordinates of a noise fit
constexpr int kSlotBytes = 16;
constexpr int kWork = kSlots * kSlotBytes;
constexpr int kPrograms = 1500;

std::uint64_t seed() {
  const char* text = std::getenv("PIXELFLOW_SEED");
  const std::uint64_t chosen = text ? std::strtoull(text, nullptr, 0) : 19980719u;
  std::printf("seed %llu (PIXELFLOW_SEED replays it)\n", static_cast<unsigned long long>(chosen));
  return chosen;
}

struct LevelArray {
  std::string name;
  std::unique_ptr<PixelArray> array;
};

std::vector<LevelArray> levels() {
  std::vector<LevelArray> all;
  all.push_back({"macro", make_golden_array(Level::Macro, kLanes)});
  all.push_back({"model", make_golden_array(Level::Model, kLanes)});
#ifdef VSG_HAVE_RTL
  all.push_back({"rtl", tb::make_rtl_array(kLanes)});
#endif
  return all;
}

class Programs {
 public:
  explicit Programs(std::uint64_t seed) : random_(seed) {}

  std::mt19937_64& random() { return random_; }
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

  /// One operation that the library takes; what it refuses is thrown again.
  Operation append_random(Program& program) {
    for (;;) {
      const Operation o = operation(static_cast<Code>(below(static_cast<int>(Code::Count))));
      try {
        append(program, o);
        return o;
      } catch (const std::invalid_argument&) {
      }
    }
  }

 private:
  Operand operand() {
    Operand x;
    x.address = static_cast<std::uint8_t>(below(kSlots) * kSlotBytes);
    x.bytes = static_cast<std::uint8_t>(below(2) ? 4 : 1 + below(8));
    x.is_signed = below(2) == 1;
    return x;
  }

  Operation operation(Code code) {
    Operation o;
    o.code = code;
    o.d = operand();
    o.a = operand();
    o.b = operand();
    o.flush = below(3) == 0;
    o.work = kWork;
    switch (code) {
      case Code::Multiply:
      case Code::Divide: o.scale = below(5); break;
      case Code::ShiftLeft:
      case Code::ShiftRight: o.scale = below(40); break;
      case Code::SquareRoot: o.scale = below(8 * o.a.bytes + 1); break;
      case Code::Wrap:
      case Code::Saturate: o.scale = 1 + below(8 * o.d.bytes); break;
      case Code::FixedToFloat:
      case Code::FloatToFixed: o.scale = below(60) - 20; break;
      case Code::NoiseFixed: o.a.bytes = o.d.bytes = 2; [[fallthrough]];
      case Code::NoiseFloat: o.scale = 1 + below(3); break;
      default: break;
    }
    if (below(6) == 0) {
      Operand& x = below(2) ? o.a : o.b;
      x.uniform = true;
      const int unused = 64 - 8 * x.bytes;
      x.constant = random_() << unused >> unused;
      if (x.is_signed)
        x.constant = static_cast<std::uint64_t>(static_cast<std::int64_t>(x.constant << unused) >> unused);
    }
    return o;
  }

  std::mt19937_64 random_;
};

TEST(Levels, ProgramsOfTheLibraryAgree) {
  Programs programs(seed());
  const std::vector<LevelArray> all = levels();
  std::array<int, static_cast<std::size_t>(Code::Count)> used{};
  int operations = 0;
  for (int n = 0; n < kPrograms; ++n) {
    Program program;
    // E from a random bit of the workspace's first byte, which holds what the test put there.
    append_instructions(program, [](Assembler& a) { a.flag_of_memory(Flag::E, kWork, 0); });
    std::string text;
    const int count = 4 + programs.below(12);
    bool compares = false;
    for (int i = 0; i < count; ++i) {
      const Operation o = programs.append_random(program);
      ++used[static_cast<std::size_t>(o.code)];
      ++operations;
      text += std::string(text.empty() ? "" : ", ") + name(o.code);
      compares = is_comparison(o.code);
    }
    std::vector<std::vector<std::uint8_t>> rows(kMemoryBytes, std::vector<std::uint8_t>(kLanes));
    for (auto& row : rows) {
      const int style = programs.below(4);  // zeros and ones in a row make hard numbers
      for (auto& byte : row) {
        byte = static_cast<std::uint8_t>(programs.random()());
        if (style == 0 && programs.below(2)) byte = programs.below(2) ? 0xFF : 0;
      }
    }
    std::vector<std::uint64_t> cycles;
    for (const LevelArray& level : all) {
      for (int address = 0; address < kMemoryBytes; ++address)
        level.array->write(address, rows[static_cast<std::size_t>(address)]);
      const std::uint64_t before = level.array->counters().cycles;
      level.array->run(program);
      cycles.push_back(level.array->counters().cycles - before);
    }
    std::vector<std::uint8_t> first(kLanes), other(kLanes);
    for (std::size_t level = 1; level < all.size(); ++level) {
      const std::string where =
          all[0].name + " and " + all[level].name + ", program " + std::to_string(n) + ": " + text;
      ASSERT_EQ(cycles[level], cycles[0]) << where;
      for (int address = 0; address < kWork; ++address) {
        all[0].array->read(address, first);
        all[level].array->read(address, other);
        ASSERT_EQ(first, other) << "byte " << address << ", " << where;
      }
      for (int lane = 0; lane < kLanes; ++lane) {
        const Registers a = all[0].array->registers(lane), b = all[level].array->registers(lane);
        ASSERT_EQ(a.e, b.e) << where;
        if (compares && a.e) {
          ASSERT_EQ(a.k, b.k) << where << ", element " << lane;
        }
      }
    }
    ASSERT_EQ(cycles[0], program.cycles());
  }
  for (std::size_t code = 0; code < used.size(); ++code) EXPECT_GT(used[code], 0) << name(static_cast<Code>(code));
  std::printf("%d operations in %d programs at %zu levels\n", operations, kPrograms, all.size());
}

}  // namespace
