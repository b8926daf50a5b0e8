#include "program/render_statistics.h"

#include <algorithm>
#include <string>

#include "pixelflow/compiler/memory_layout.h"
#include "program/answer_json.h"

namespace program {
namespace {

using nlohmann::ordered_json;

// The real machines: chapter VII.D of the thesis; sections 5.2 and 6.2 of the paper, its array at 100 MHz.
constexpr double kReference = 200e-9;        // seconds of a segment reference
constexpr double kArrayCycle = 10e-9;        // seconds
constexpr double kCompositionBytes = 6.4e9;  // a second
constexpr int kBudget = 142;                 // bytes a pixel at 30 frames of 1280 x 1024 a second
constexpr int kPublishedNodes[] = {4, 16};

ordered_json generator_statistics(const vsg::FrameAnswer& answer) {
  ordered_json node;
  node["counters"] = counters_json(answer.counters);
  node["depth_tests"] = answer.depth_tests;
  node["samples_stored"] = answer.samples_stored;
  node["subdivisions"] = answer.subdivisions;
  node["intersections"] = answer.intersections;
  node["stale_samples"] = answer.stale_samples;
  node["unclosed_polygons"] = answer.unclosed_polygons;
  node["coherence_samples"] = answer.coherence_samples;
  add_rtl_counts(node, answer);
  auto& references = node["lines"]["references"] = ordered_json::array();
  for (const vsg::LineCounts& line : answer.lines) references.push_back(line.references);
  auto& segments = node["lines"]["segments"] = ordered_json::array();
  for (const vsg::LineCounts& line : answer.lines) segments.push_back(line.segments);
  return node;
}

ordered_json region_statistics(const watkins::FrameCounts& counts) {
  const pfman::RegionCounts& sum = counts.sum;
  const auto busiest =
      counts.region_cycles.empty() ? 0 : *std::max_element(counts.region_cycles.begin(), counts.region_cycles.end());
  return {{"all", counts.regions},
          {"covered", counts.covered_regions},
          {"samples", counts.samples},
          {"covered_samples", counts.covered_samples},
          {"surfaces_executed", sum.executions},
          {"surfaces_sharing_illum", sum.shared},
          {"texture_lookups", sum.lookups},
          {"streams_made", counts.streams_made},
          {"streams_reused", counts.streams_reused},
          {"cycles",
           {{"compose", sum.compose},
            {"receive", sum.receive},
            {"pre_shade", sum.pre_shade},
            {"pre_illum", sum.pre},
            {"lights", sum.lights},
            {"illum", sum.illum},
            {"post_illum", sum.post},
            {"send", sum.send},
            {"slowest_region", busiest}}},
          {"bytes_a_pixel",
           {{"largest_transfer_map", counts.largest_map},
            {"packets", sum.packets},
            {"sent", sum.packets * pixelflow::kPacketBytes},
            {"payload", sum.packets * pfman::kPacketPayload},
            {"budget", kBudget}}}};
}

ordered_json field_statistics(const scanline::FieldCost& cost) {
  return {{"rays", cost.rays}, {"evaluations", cost.evaluations}, {"missed", cost.missed}};
}

/// What the frame would take on the real machines, in seconds: the slowest of their stages sets the frame rate.
ordered_json machine_statistics(const watkins::RenderedFrame& frame, int shading_nodes) {
  double visible = 0;
  for (const vsg::FrameAnswer& answer : frame.answers) {
    visible = std::max(visible, static_cast<double>(answer.counters.segment_references) * kReference);
  }
  const double composition = static_cast<double>(frame.counts.packet_bytes) / kCompositionBytes;
  ordered_json result = {{"visible_segments", visible}, {"composition", composition}};
  std::vector<int> numbers(std::begin(kPublishedNodes), std::end(kPublishedNodes));
  if (std::find(numbers.begin(), numbers.end(), shading_nodes) == numbers.end()) numbers.push_back(shading_nodes);
  auto& nodes = result["shading"] = ordered_json::array();
  for (const int number : numbers) {
    const double shading = static_cast<double>(watkins::busiest_node(frame.counts, number)) * kArrayCycle;
    const double slowest = std::max({visible, composition, shading});
    nodes.push_back({{"nodes", number}, {"busiest", shading}, {"frames_a_second", slowest > 0 ? 1 / slowest : 0.0}});
  }
  return result;
}

}  // namespace

ordered_json frame_statistics(int moment, const watkins::RenderedFrame& frame, int shading_nodes, double writing) {
  ordered_json result;
  result["frame"] = moment;
  if (frame.answers.size() == 1) {
    result.update(generator_statistics(frame.answers.front()));
  } else {
    auto& nodes = result["rendering_nodes"] = ordered_json::array();
    for (const vsg::FrameAnswer& answer : frame.answers) nodes.push_back(generator_statistics(answer));
  }
  result["regions"] = region_statistics(frame.counts);
  result["fields"] = field_statistics(frame.counts.fields);
  result["real_machines"] = machine_statistics(frame, shading_nodes);
  result["times"] = {{"pre_frame", frame.times.pre_frame},
                     {"visible_segments", frame.times.visible_segments},
                     {"surfaces", frame.times.surfaces},
                     {"shading", frame.times.shading},
                     {"writing", writing}};
  return result;
}

}  // namespace program
