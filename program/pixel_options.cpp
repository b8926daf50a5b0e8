#include "program/pixel_options.h"

namespace program {

void add_pixel_options(CLI::App& command, PixelOptions& options) {
  options.level = watkins::has_rtl() ? "rtl" : "model";
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

}  // namespace program
