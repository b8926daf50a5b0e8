// Random programs through the RTL of a chip and the golden elements. A seed that it prints is replayed with
// --seed SEED --programs 1 --every and the other options as they were.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/pixelflow_rtl/chip_lockstep.h"

int main(int argc, char** argv) {
  std::uint64_t seed = 1;
  int programs = 100, elements = pixelflow::kElements, bits = pixelflow::kMultiplierBits;
  pixelflow_tests::LockstepOptions options;
  std::string trace;
  CLI::App app{"Random programs through the RTL of a chip of pixel processors and the golden elements"};
  app.add_option("--programs", programs, "how many programs")
      ->check(CLI::PositiveNumber.description(""))
      ->capture_default_str();
  app.add_option("--seed", seed, "seed of the first program; the next ones count up")->capture_default_str();
  app.add_option("--length", options.length, "instructions of a program")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--elements", elements, "elements of the chip: 256 or 16")->capture_default_str();
  app.add_option("--multiplier-bits", bits, "2 with 256 elements; 1, 4 or 8 with 16")->capture_default_str();
  app.add_flag("--every", options.every, "compare after every instruction, not only after the last");
  app.add_flag("--ports", options.ports, "packets come and go, and no stream is always ready");
  app.add_option("--trace", trace, "FST waveform of the run");
  CLI11_PARSE(app, argc, argv);

  try {
    const auto chip = tb::make_pixel_chip(elements, bits, trace);
    std::printf("seeds %llu to %llu, %d elements, %d multiplier bits\n", static_cast<unsigned long long>(seed),
                static_cast<unsigned long long>(seed + static_cast<std::uint64_t>(programs) - 1), elements, bits);
    pixelflow_tests::ChipLockstep lockstep(*chip);
    for (int i = 0; i < programs; ++i) {
      const std::uint64_t s = seed + static_cast<std::uint64_t>(i);
      try {
        lockstep.run(s, options);
      } catch (const std::runtime_error& error) {
        std::printf("seed %llu: %s\n", static_cast<unsigned long long>(s), error.what());
        if (!options.every) {  // once more, to find the instruction
          auto closer = options;
          closer.every = true;
          try {
            pixelflow_tests::ChipLockstep(*chip).run(s, closer);
          } catch (const std::runtime_error& first) {
            std::printf("first at %s\n", first.what());
          }
        }
        std::printf(
            "  replay: vsg_pixel_lockstep --seed %llu --programs 1 --every --length %d --elements %d --multiplier-bits "
            "%d%s --trace mismatch.fst\n",
            static_cast<unsigned long long>(s), options.length, elements, bits, options.ports ? " --ports" : "");
        return 2;
      }
    }
    std::printf(
        "%d programs, %llu instructions, %llu cycles, %llu element-instructions and %llu packets matched, no "
        "mismatch\n",
        programs, static_cast<unsigned long long>(lockstep.instructions()),
        static_cast<unsigned long long>(lockstep.cycles()),
        static_cast<unsigned long long>(lockstep.instructions() * static_cast<std::uint64_t>(elements)),
        static_cast<unsigned long long>(lockstep.packets()));
    return lockstep.instructions() > 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
