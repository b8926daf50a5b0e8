// The verilated chips beside the golden model: what is equal, and mistakes that are caught.
#include <gmock/gmock.h>

#include "cmodel/vsg/answer.h"
#include "pixelflow/microcode/library.h"
#include "tb/pixelflow/lockstep_array.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/regions/scene.h"

namespace region_tests {
namespace {

using namespace pixelflow;
using pixelflow_tests::replay;
using pixelflow_tests::seed_or;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kLanes = 2 * kElements;

TEST(LockstepArray, WorksRegionsOfTheChipsAndTheModelTogether) {
  const std::uint64_t seed = seed_or(91);
  std::mt19937_64 random(seed);
  auto array = tb::make_lockstep_array(kLanes, "again");
  const auto& watched = dynamic_cast<const tb::LockstepArray&>(*array);
  Scene scene(std::move(array)), macro(make_golden_array(Level::Macro, kLanes));
  for (const unsigned of_256 : {2u, 5u, 1u, 4u}) {  // one chip or two
    const std::vector<pfman::RegionPixels> sources{random_pixels(random, {kWide, kWhere, kRed, kSpots}, of_256),
                                                   random_pixels(random, {kPlain, kSpots}, of_256, 1)};
    const std::uint64_t before = watched.matched_programs();
    EXPECT_EQ(scene.work(sources, 128, 64).colors, macro.work(sources, 128, 64).colors) << replay(seed);
    EXPECT_GT(watched.matched_programs(), before + 10);
  }
  EXPECT_GT(watched.matched_bytes(), watched.matched_programs() * kMemoryBytes);
}

/// A golden model that makes one mistake after one of its programs.
class Mistaken final : public PixelArray {
 public:
  enum class Mistake { None, Memory, Enable, Packet, Cycles };
  explicit Mistaken(Mistake mistake) : mistake_(mistake) {}

  int lanes() const override { return array_->lanes(); }
  void cover(int elements) override { array_->cover(elements); }
  int covered() const override { return array_->covered(); }
  void write(int address, std::span<const std::uint8_t> bytes) override { array_->write(address, bytes); }
  void read(int address, std::span<std::uint8_t> bytes) const override { array_->read(address, bytes); }
  void place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) override {
    array_->place(columns, rows);
  }
  void places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const override {
    array_->places(columns, rows);
  }
  void run(const Program& program) override {
    array_->run(program);
    if (++programs_ < 2) return;
    std::vector<std::uint8_t> row(static_cast<std::size_t>(covered()));
    if (mistake_ == Mistake::Memory) {
      array_->read(21, row);
      row[130] ^= 4;
      array_->write(21, row);
    }
  }
  void load(std::span<const std::uint8_t> packets) override { array_->load(packets); }
  void compose(Compose mode, std::span<const std::uint8_t> upstream) override { array_->compose(mode, upstream); }
  void sent(std::span<std::uint8_t> packets) const override {
    array_->sent(packets);
    if (wrong(Mistake::Packet)) packets[130 * kPacketBytes + 7] ^= 4;
  }
  Registers registers(int lane) const override {
    Registers r = array_->registers(lane);
    if (wrong(Mistake::Enable) && lane == 130) r.e = !r.e;
    return r;
  }
  ArrayCounters counters() const override {
    ArrayCounters counters = array_->counters();
    if (wrong(Mistake::Cycles)) ++counters.cycles;
    return counters;
  }

 private:
  bool wrong(Mistake mistake) const { return programs_ >= 2 && mistake_ == mistake; }

  std::unique_ptr<PixelArray> array_ = make_golden_array(Level::Model, kLanes);
  Mistake mistake_;
  int programs_ = 0;
};

/// Three steps: E everywhere, bytes 20 and 21 from the element's column, byte 21 sent.
Program program() {
  Program made;
  append_instructions(made, [](Assembler& out) { out.flag(Flag::E, Bit::One); });
  append_instructions(made, [](Assembler& out) {
    out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = 20, .imm = kPortX});
    out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = 21, .imm = kPortX});
  });
  append_instructions(made, [](Assembler& out) {
    out.load_m(21);
    out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = 7});
    out.control(Control::Send);
  });
  return made;
}

/// What the second program is told, nothing where both agree.
std::string told(Mistaken::Mistake mistake) {
  tb::LockstepArray array(std::make_unique<Mistaken>(mistake), make_golden_array(Level::Model, kLanes), "vsg again");
  array.cover(200);
  array.run(program());
  EXPECT_EQ(array.matched_programs(), 1u);
  EXPECT_EQ(array.matched_bytes(), 200u * (kMemoryBytes + kPacketBytes));
  try {
    array.run(program());
  } catch (const vsg::LockstepError& error) {
    return error.what();
  }
  return {};
}

TEST(LockstepArray, CatchesMistakes) {
  using Mistake = Mistaken::Mistake;
  EXPECT_EQ(told(Mistake::None), "");
  const auto where =
      AllOf(HasSubstr("program 1"), HasSubstr("element 130 (column 2, row 1)"), HasSubstr("replay: vsg again"));
  EXPECT_THAT(told(Mistake::Memory),
              AllOf(where, HasSubstr("byte 21 of memory"), HasSubstr("step 1 of 3"), HasSubstr("golden 2, RTL 6")));
  EXPECT_THAT(told(Mistake::Packet), AllOf(where, HasSubstr("byte 7 of the packet sent"), HasSubstr("step 2 of 3"),
                                           HasSubstr("golden 2, RTL 6")));
  EXPECT_THAT(told(Mistake::Enable),
              AllOf(where, HasSubstr("enable flag"), HasSubstr("step 0 of 3"), HasSubstr("golden 1, RTL 0")));
  const std::uint64_t cycles = 2 * program().cycles();
  EXPECT_THAT(told(Mistake::Cycles), AllOf(HasSubstr("golden " + std::to_string(cycles) + " cycles"),
                                           HasSubstr("RTL " + std::to_string(cycles + 1) + " cycles")));
}

TEST(LockstepArray, RefusesArraysOfDifferentSizes) {
  EXPECT_THROW(tb::LockstepArray(make_golden_array(Level::Model, 256), make_golden_array(Level::Model, 512), ""),
               std::invalid_argument);
}

}  // namespace
}  // namespace region_tests
