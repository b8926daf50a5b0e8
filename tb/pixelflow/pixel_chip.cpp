#include "tb/pixelflow/pixel_chip.h"

#include "Vpixel_chip.h"
#include "Vpixel_chip___024root.h"
#include "Vpixel_chip_r1.h"
#include "Vpixel_chip_r1___024root.h"
#include "Vpixel_chip_r4.h"
#include "Vpixel_chip_r4___024root.h"
#include "Vpixel_chip_r8.h"
#include "Vpixel_chip_r8___024root.h"
#include "tb/pixelflow/pixel_chip_driver.h"

namespace tb {

std::unique_ptr<PixelChip> make_pixel_chip(int lanes, int multiplier_bits, const std::filesystem::path& trace) {
  if (lanes == pixelflow::kElements && multiplier_bits == pixelflow::kMultiplierBits) {
    return std::make_unique<PixelChipDriver<Vpixel_chip>>(multiplier_bits, trace);
  }
  if (lanes == 16) {
    switch (multiplier_bits) {
      case 1: return std::make_unique<PixelChipDriver<Vpixel_chip_r1>>(multiplier_bits, trace);
      case 4: return std::make_unique<PixelChipDriver<Vpixel_chip_r4>>(multiplier_bits, trace);
      case 8: return std::make_unique<PixelChipDriver<Vpixel_chip_r8>>(multiplier_bits, trace);
      default: break;
    }
  }
  throw std::invalid_argument("no chip of " + std::to_string(lanes) + " elements with " +
                              std::to_string(multiplier_bits) + " multiplier bits a cycle was verilated");
}

}  // namespace tb
