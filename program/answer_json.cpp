#include "program/answer_json.h"

#include <cmath>

namespace program {
namespace {

double four_decimals(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

nlohmann::ordered_json counters_json(const vsg::Counters& c) {
  return {{"polygon_blocks", c.polygon_blocks},
          {"edge_blocks", c.edge_blocks},
          {"edge_crossings", c.edge_crossings},
          {"implied_edges", c.implied_edges},
          {"output_segments", c.output_segments},
          {"segment_blocks_total", c.segment_blocks_total},
          {"segment_blocks_max", c.segment_blocks_max},
          {"segment_references", c.segment_references},
          {"reference_ratio", four_decimals(c.reference_ratio)},
          {"add_cycles", c.add_cycles},
          {"add_cycles_per_test", four_decimals(c.add_cycles_per_test)},
          {"percent_not_at_end", four_decimals(c.percent_not_at_end)},
          {"output_buffer", c.output_buffer},
          {"add_cycles_listed", c.add_cycles_listed}};
}

void add_rtl_counts(nlohmann::ordered_json& object, const vsg::FrameAnswer& answer) {
  if (!answer.cycles) return;
  object["cycles"] = *answer.cycles;
  object["port_accesses"] = answer.port_accesses;
}

std::string segments_json(const vsg::FrameAnswer& answer) {
  nlohmann::ordered_json object;
  object["size"] = {answer.width, answer.height};
  auto& segments = object["segments"] = nlohmann::ordered_json::array();
  for (const vsg::VisibleSegment& s : answer.segments) segments.push_back({s.y, s.x_end, s.polygon});
  object["counters"] = counters_json(answer.counters);
  add_rtl_counts(object, answer);
  return object.dump() + "\n";
}

}  // namespace program
