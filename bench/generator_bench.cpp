// Frames a second of the Visible Segment Generators on the ten test objects and the teapot, one core each. What is
// timed is the generator alone: the blocks are made beforehand. Counter `cycles` (RTL): simulated clock cycles a frame.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>
#include <string>

#include "scanline/golden_generator.h"
#include "scanline/scene_frame.h"
#ifdef VSG_HAVE_RTL
#include "tb/verilated_generator.h"
#endif

namespace {

constexpr const char* kScenes[] = {
    "watkins/penetration", "watkins/e_s",   "watkins/low_area", "watkins/cube1",   "watkins/cube2", "watkins/shape1",
    "watkins/shape2",      "watkins/sheet", "watkins/simple1",  "watkins/simple2", "teapot"};

scanline::Frame frame_of(const std::string& scene) {
  const auto path = std::filesystem::path(VSG_DATA_DIR) / "scenes" / (scene + ".toml");
  const scanline::Scene read = scanline::read_scene_file(path);
  return scanline::make_scene_frame(read, read.first_frame, read.width, read.height).frame;
}

void work_frames(benchmark::State& state, scanline::VisibleSegmentGenerator& generator, const std::string& scene) {
  const vsg::FrameBlocks blocks = scanline::make_blocks(frame_of(scene), generator.parameters(), false);
  std::int64_t cycles = 0, references = 0, segments = 0;
  for (auto unused : state) {
    const vsg::FrameAnswer answer = generator.generate(blocks);
    benchmark::DoNotOptimize(answer.segments.data());
    cycles = answer.cycles.value_or(0);
    references = answer.counters.segment_references;
    segments = answer.counters.output_segments;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["cycles"] = static_cast<double>(cycles);
  state.counters["references"] = static_cast<double>(references);
  state.counters["segments"] = static_cast<double>(segments);
}

void golden(benchmark::State& state, const std::string& scene) {
  scanline::GoldenGenerator generator;
  work_frames(state, generator, scene);
}

#ifdef VSG_HAVE_RTL
void rtl(benchmark::State& state, const std::string& scene) {
  tb::VerilatedGenerator generator;
  work_frames(state, generator, scene);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  for (const char* path : kScenes) {
    const std::string scene = path, name = std::filesystem::path(scene).filename().string();
    benchmark::RegisterBenchmark(("golden/" + name).c_str(), golden, scene)->Unit(benchmark::kMillisecond);
#ifdef VSG_HAVE_RTL
    benchmark::RegisterBenchmark(("rtl/" + name).c_str(), rtl, scene)->Unit(benchmark::kMillisecond);
#endif
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
