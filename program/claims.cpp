// Statements of the thesis's text, each measured on the ten reconstructed objects (or the church of 345 blocks).
#include <algorithm>
#include <map>
#include <stdexcept>

#include "program/tables.h"

namespace program {
namespace {

constexpr double kMemoryCycle = 200e-9;  // seconds a segment reference (chapter VII.D)
constexpr std::size_t kPolygonsOfACube = 6;
constexpr int kFramesOfSequence = 8;  // of scenes/sequence.toml
constexpr int kAllReferences = 15;    // PQ(15): references to every list and block

double frames_a_second(const vsg::FrameAnswer& answer) {
  const auto references = static_cast<double>(answer.counters.segment_references);
  return references > 0 ? 1 / (references * kMemoryCycle) : 0;
}

double ratio(std::int64_t a, std::int64_t b) { return b ? static_cast<double>(a) / static_cast<double>(b) : 0; }

using Measures = std::map<std::pair<std::string, std::string>, double>;

// Least and greatest of a figure over the ten objects.
template <typename Figure>
std::pair<double, double> range(const std::map<std::string, vsg::FrameAnswer>& answers, const Figure& figure) {
  std::pair<double, double> least_most{figure(answers.begin()->second), figure(answers.begin()->second)};
  for (const auto& [name, answer] : answers) {
    least_most.first = std::min(least_most.first, figure(answer));
    least_most.second = std::max(least_most.second, figure(answer));
  }
  return least_most;
}

Measures measure_all(SceneMeter& meter, double warnock_accesses) {
  Measures m;
  std::map<std::string, vsg::FrameAnswer> answers;
  for (const std::string& name : ten_objects()) {
    const auto& answer = answers[name] = meter.measure("watkins/" + name);
    m[{name, "frames_a_second"}] = frames_a_second(answer);
  }
  const vsg::FrameAnswer church = meter.measure("church");
  m[{"church", "frames_a_second"}] = frames_a_second(church);
  m[{"church", "output_buffer"}] = static_cast<double>(church.counters.output_buffer);

  const auto back = range(answers, [](const auto& a) { return a.counters.percent_not_at_end; });
  m[{"segment_reordering", "percent_appended_least"}] = 100 - back.second;
  m[{"segment_reordering", "percent_appended_most"}] = 100 - back.first;
  const auto blocks = range(answers, [](const auto& a) { return static_cast<double>(a.counters.segment_blocks_max); });
  m[{"segment_blocks", "fewest"}] = blocks.first;
  m[{"segment_blocks", "most"}] = blocks.second;
  const auto adds = range(answers, [](const auto& a) { return a.counters.add_cycles_per_test; });
  m[{"adds_per_test", "least"}] = adds.first;
  m[{"adds_per_test", "most"}] = adds.second;

  const vsg::FrameAnswer& cube1 = answers.at("cube1");
  const vsg::FrameAnswer single = meter.measure_part("watkins/cube1", kPolygonsOfACube);
  m[{"cube2_over_cube1", "segment_references"}] =
      ratio(answers.at("cube2").counters.segment_references, cube1.counters.segment_references);
  m[{"cube1_over_single_cube", "segment_references"}] =
      ratio(cube1.counters.segment_references, single.counters.segment_references);
  m[{"cube1_over_single_cube", "all_references"}] =
      ratio(cube1.statistics.pq[kAllReferences], single.statistics.pq[kAllReferences]);

  // The first frame of a sequence has none before it: it is left out of what is compared.
  const auto saved = [&meter](const std::string& scene, int last) {
    const std::int64_t first = meter.sequence_references(scene, 1, 1, false);
    const std::int64_t without = meter.sequence_references(scene, 1, last, false) - first;
    const std::int64_t with = meter.sequence_references(scene, 1, last, true) - first;
    return std::pair(without - with, without);
  };
  const auto [moving_saved, moving_all] = saved("sequence", kFramesOfSequence);
  m[{"frame_coherence_moving", "percent_references_saved"}] = 100 * ratio(moving_saved, moving_all);
  std::int64_t still_saved = 0, still_all = 0;
  for (const std::string& name : ten_objects()) {
    const auto [object_saved, object_all] = saved("watkins/" + name, 2);
    still_saved += object_saved;
    still_all += object_all;
  }
  m[{"frame_coherence_still", "percent_references_saved"}] = 100 * ratio(still_saved, still_all);

  const auto e_s = static_cast<double>(answers.at("e_s").counters.segment_references);
  m[{"e_s", "segment_references"}] = e_s;
  m[{"warnock_over_e_s", "accesses"}] = e_s > 0 ? warnock_accesses / e_s : 0;
  return m;
}

}  // namespace

Table claims(SceneMeter& meter) {
  const auto file = read_table_file(meter.data() / "tables" / "claims.json");
  const Measures measures = measure_all(meter, file.at("warnock_accesses").get<double>());
  Table table{.name = "claims", .source = file.at("source"), .cells = {}};
  for (const auto& entry : file.at("claims")) {
    Cell cell = published_cell(entry.at("name"), entry.at("column"), entry);
    const auto found = measures.find({cell.name, cell.column});
    if (found == measures.end()) throw std::logic_error("no measure for the claim " + cell.name + " " + cell.column);
    cell.measured = found->second;
    table.cells.push_back(std::move(cell));
  }
  return table;
}

}  // namespace program
