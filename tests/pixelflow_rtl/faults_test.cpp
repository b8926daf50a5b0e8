// Faults planted in the RTL of the pixel processors must be caught by lock-step on random programs, with and without
// packets; the chip without a fault must pass the same programs.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Vpixel_chip_faulty.h"
#include "Vpixel_chip_faulty___024root.h"
#include "tb/pixelflow/pixel_chip_driver.h"
#include "tests/pixelflow_rtl/chip_lockstep.h"

namespace {
int g_fault = 0;
}

extern "C" int chosen_fault() { return g_fault; }

namespace pixelflow_tests {
namespace {

constexpr std::uint64_t kFirstSeed = 7000;
constexpr int kPrograms = 60;

const nlohmann::json& faults() {
  static const nlohmann::json all = nlohmann::json::parse(std::ifstream(PIXELFLOW_FAULTS));
  return all;
}

/// What lock-step says about the chip with a fault; empty when it passes all programs.
std::string verdict(int fault, int& programs_needed) {
  g_fault = fault;
  tb::PixelChipDriver<Vpixel_chip_faulty> chip(pixelflow::kMultiplierBits);
  ChipLockstep lockstep(chip);
  for (programs_needed = 1; programs_needed <= kPrograms; ++programs_needed) {
    try {
      lockstep.run(kFirstSeed + programs_needed,
                   {.every = programs_needed % 4 == 0, .ports = programs_needed % 2 == 0, .length = 300});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  return {};
}

TEST(PixelFaults, TheTrueChipPasses) {
  int programs = 0;
  EXPECT_EQ(verdict(0, programs), "");
  EXPECT_EQ(programs, kPrograms + 1);
}

class PixelPlantedFault : public testing::TestWithParam<int> {};

TEST_P(PixelPlantedFault, IsCaught) {
  const auto& fault = faults()[static_cast<std::size_t>(GetParam() - 1)];
  int programs = 0;
  const std::string caught = verdict(GetParam(), programs);
  EXPECT_NE(caught, "") << "not caught in " << kPrograms << " programs from seed " << kFirstSeed << ": "
                        << fault["name"].get<std::string>() << " (" << fault["file"].get<std::string>() << ")";
  std::printf("%s: %s: caught in program %d: %s\n", fault["file"].get<std::string>().c_str(),
              fault["name"].get<std::string>().c_str(), programs, caught.c_str());
}

INSTANTIATE_TEST_SUITE_P(All, PixelPlantedFault, testing::Range(1, 1 + static_cast<int>(faults().size())));

}  // namespace
}  // namespace pixelflow_tests
