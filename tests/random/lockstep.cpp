// Random frames through golden model and RTL in lock-step. `vsg_random_lockstep --frames 10000` is the long run; a seed that
// it prints is replayed with --seed SEED --frames 1.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>

#include "tb/verilated_generator.h"
#include "tests/random/random_frames.h"

int main(int argc, char** argv) {
  std::uint64_t seed = 1;
  int frames = 300, lines = 128;
  bool small = false, wait = false;
  std::string write, trace;
  CLI::App app{"Random frames through golden model and RTL, compared at every transaction"};
  app.add_option("--frames", frames, "how many frames")->capture_default_str();
  app.add_option("--seed", seed, "seed of the first frame; the next ones count up")->capture_default_str();
  app.add_option("--lines", lines, "most scan lines of a frame")->capture_default_str();
  app.add_flag("--small", small, "the small machine of other widths instead of the default one");
  app.add_flag("--wait", wait, "the receiver of visible segments is ready in one cycle of three, at random");
  app.add_option("--write", write, "write the first frame to this file");
  app.add_option("--trace", trace, "FST waveform of the run");
  CLI11_PARSE(app, argc, argv);

  std::printf("seeds %llu to %llu, %s machine\n", static_cast<unsigned long long>(seed),
              static_cast<unsigned long long>(seed + frames - 1), small ? "small" : "default");
  tb::VerilatedGenerator generator(small ? tb::make_small_rtl_machine(trace) : tb::make_rtl_machine(trace),
                                   {.lockstep = true, .trace = {}, .replay = {}});
  std::mt19937_64 patience;
  if (wait) generator.machine().receiver_ready = [&patience] { return patience() % 3 == 0; };
  int refused = 0;
  std::int64_t cycles = 0, segments = 0;
  for (int i = 0; i < frames; ++i) {
    const std::uint64_t s = seed + static_cast<std::uint64_t>(i);
    patience.seed(s);
    const vsg_tests::RandomFrame random = vsg_tests::random_frame(s, lines);
    if (i == 0 && !write.empty()) {
      std::ofstream out(write);
      scanline::write_frame(out, random.frame);
      std::printf("wrote %s%s\n", write.c_str(), random.keep_back_faces ? " (run it with --keep-back-faces)" : "");
    }
    try {
      const auto answer = generator.generate(
          scanline::make_blocks(random.frame, generator.parameters(), random.keep_back_faces));
      cycles += *answer.cycles;
      segments += static_cast<std::int64_t>(answer.segments.size());
    } catch (const vsg::FrameError&) {
      ++refused;  // by both, for the same reason on the same line
    } catch (const std::exception& error) {
      std::printf("seed %llu (%s): %s\n  replay: vsg_random_lockstep --seed %llu --frames 1%s --trace mismatch.fst\n",
                  static_cast<unsigned long long>(s), random.kinds.c_str(), error.what(), static_cast<unsigned long long>(s),
                  small ? " --small" : wait ? " --wait" : "");
      return 2;
    }
  }
  std::printf("%d frames, %d of them refused alike; %lld transactions matched, no mismatch; %lld segments, %lld cycles\n",
              frames, refused, static_cast<long long>(generator.matched()), static_cast<long long>(segments),
              static_cast<long long>(cycles));
  return generator.matched() > 0 ? 0 : 2;
}
