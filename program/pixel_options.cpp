#include "program/pixel_options.h"

#include "program/generator_options.h"
#include "program/refuse.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace program {

void add_pixel_options(CLI::App& command, PixelOptions& options) {
  options.level = has_rtl() ? "rtl" : "model";
  command
      .add_option("--pe", options.level,
                  "Which pixel processors: every operation at once, every instruction, or the verilated RTL")
      ->check(CLI::IsMember({"macro", "model", "rtl"}).description(""))
      ->capture_default_str()
      ->type_name("macro|model|rtl")
      ->group("Machine");
  command
      .add_option("--multiplier-bits", options.multiplier_bits,
                  "Bits of a multiplier that an element works off in a cycle (golden model; the RTL has its own)")
      ->check(CLI::IsMember({1, 2, 4, 8}).description(""))
      ->capture_default_str()
      ->type_name("1|2|4|8")
      ->group("Machine");
}

std::unique_ptr<pixelflow::PixelArray> make_array(const PixelOptions& options, int lanes) {
  if (options.level == "macro")
    return pixelflow::make_golden_array(pixelflow::Level::Macro, lanes, options.multiplier_bits);
  if (options.level == "model")
    return pixelflow::make_golden_array(pixelflow::Level::Model, lanes, options.multiplier_bits);
  if (options.multiplier_bits != pixelflow::kMultiplierBits) {
    refuse("--multiplier-bits: the RTL was built with " + std::to_string(pixelflow::kMultiplierBits) +
           " bits; another number needs --pe model or macro");
  }
#ifdef VSG_HAVE_RTL
  return tb::make_rtl_array(lanes);
#else
  refuse("--pe rtl: this program was built without the RTL (configure with -DVSG_RTL=ON, which needs Verilator)");
#endif
}

}  // namespace program
