// Figure 33 (statistics of VSG6 for the ten test objects) and figure 32 (Penetration under six algorithms).
#include <fmt/format.h>

#include <array>
#include <utility>

#include "program/tables.h"

namespace program {
namespace {

double per_test(std::int64_t adds, const vsg::FrameAnswer& answer) {
  return answer.depth_tests ? static_cast<double>(adds) / static_cast<double>(answer.depth_tests) : 0;
}

struct Row {
  const char* column;  // key of tables/figure33.json; the listed counts share the key of the real ones
  const char* published;
  const char* label;
  double (*measure)(const vsg::FrameAnswer&);
};

// The thesis's thirteen rows; rows 10 and 11 twice.
constexpr std::array kRows{
    Row{"polygon_blocks", "polygon_blocks", " 1 polygon blocks",
        [](const vsg::FrameAnswer& a) { return double(a.counters.polygon_blocks); }},
    Row{"edge_blocks", "edge_blocks", " 2 edge blocks",
        [](const vsg::FrameAnswer& a) { return double(a.counters.edge_blocks); }},
    Row{"edge_crossings", "edge_crossings", " 3 edges cross scan lines",
        [](const vsg::FrameAnswer& a) { return double(a.counters.edge_crossings); }},
    Row{"implied_edges", "implied_edges", " 4 implied lines",
        [](const vsg::FrameAnswer& a) { return double(a.counters.implied_edges); }},
    Row{"output_segments", "output_segments", " 5 output segments",
        [](const vsg::FrameAnswer& a) { return double(a.counters.output_segments); }},
    Row{"segment_blocks_total", "segment_blocks_total", " 6 segment blocks in all",
        [](const vsg::FrameAnswer& a) { return double(a.counters.segment_blocks_total); }},
    Row{"segment_blocks_max", "segment_blocks_max", " 7 segment blocks at once",
        [](const vsg::FrameAnswer& a) { return double(a.counters.segment_blocks_max); }},
    Row{"segment_references", "segment_references", " 8 segment references",
        [](const vsg::FrameAnswer& a) { return double(a.counters.segment_references); }},
    Row{"reference_ratio", "reference_ratio", " 9 row 8 over row 3",
        [](const vsg::FrameAnswer& a) { return a.counters.reference_ratio; }},
    Row{"add_cycles", "add_cycles", "10 add cycles, real",
        [](const vsg::FrameAnswer& a) { return double(a.counters.add_cycles); }},
    Row{"add_cycles_listed", "add_cycles", "10 add cycles, as listed",
        [](const vsg::FrameAnswer& a) { return double(a.counters.add_cycles_listed); }},
    Row{"add_cycles_per_test", "add_cycles_per_test", "11 adds a test, real",
        [](const vsg::FrameAnswer& a) { return a.counters.add_cycles_per_test; }},
    Row{"add_cycles_per_test_listed", "add_cycles_per_test", "11 adds a test, as listed",
        [](const vsg::FrameAnswer& a) { return per_test(a.counters.add_cycles_listed, a); }},
    Row{"percent_not_at_end", "percent_not_at_end", "12 % not put at the end",
        [](const vsg::FrameAnswer& a) { return a.counters.percent_not_at_end; }},
    Row{"output_buffer", "output_buffer", "13 output segment buffer",
        [](const vsg::FrameAnswer& a) { return double(a.counters.output_buffer); }},
};
constexpr const char* kCycles = "cycles";

const Cell* find(const Table& table, const std::string& name, const std::string& column) {
  for (const Cell& cell : table.cells) {
    if (cell.name == name && cell.column == column) return &cell;
  }
  return nullptr;
}

}  // namespace

Table figure33(SceneMeter& meter) {
  const auto file = read_table_file(meter.data() / "tables" / "figure33.json");
  Table table{.name = "fig33", .source = file.at("source"), .cells = {}};
  for (const std::string& name : ten_objects()) {
    const vsg::FrameAnswer answer = meter.measure("watkins/" + name);
    for (const Row& row : kRows) {
      Cell cell = published_cell(name, row.column, file.at("rows").at(name).at(row.published));
      cell.measured = row.measure(answer);
      table.cells.push_back(std::move(cell));
    }
    if (answer.cycles) {
      table.cells.push_back({.name = name,
                             .column = kCycles,
                             .published = {},
                             .confidence = {},
                             .measured = static_cast<double>(*answer.cycles),
                             .note = "clock cycles of the RTL"});
    }
  }
  return table;
}

std::string figure33_text(const Table& table) {
  std::string text = "Figure 33: statistics of VSG6 for the ten test objects\n" + table.source +
                     "\nPublished cells marked ~ are likely readings, ? unreadable ones. The objects are "
                     "reconstructions (docs/ten_objects.md).\n\n";
  const auto line = [&](const std::string& label, const auto& of_object) {
    text += fmt::format("{:38}", label);
    for (const std::string& name : ten_objects()) text += fmt::format("{:>13}", of_object(name));
    text += "\n";
  };
  line("", [](const std::string& name) { return name + " "; });
  for (const Row& row : kRows) {
    const auto cell = [&](const std::string& name) -> const Cell& { return *find(table, name, row.column); };
    const auto ratio = [&](const std::string& name) {
      const auto r = cell(name).ratio();
      return r ? fmt::format("{:.2f} ", *r) : std::string("- ");
    };
    line(fmt::format("{:27} published", row.label), [&](const std::string& n) { return published_text(cell(n)); });
    line(fmt::format("{:27} measured", ""), [&](const std::string& n) { return number_text(cell(n).measured) + " "; });
    line(fmt::format("{:27} ratio", ""), ratio);
  }
  if (find(table, ten_objects().front(), kCycles)) {
    line(fmt::format("{:27} measured", "   clock cycles of the RTL"),
         [&](const std::string& n) { return number_text(find(table, n, kCycles)->measured) + " "; });
  }
  return text;
}

Table figure32(SceneMeter& meter) {
  const auto file = read_table_file(meter.data() / "tables" / "figure32.json");
  const vsg::FrameAnswer answer = meter.measure("watkins/penetration");
  const std::vector<std::pair<const char*, std::int64_t>> measured{
      {"1_memory_references", answer.counters.segment_references},
      {"2_total_memory_blocks", answer.counters.segment_blocks_total},
      {"3_maximum_blocks_at_a_time", answer.counters.segment_blocks_max},
      {"6_add_cycles", answer.counters.add_cycles}};
  Table table{.name = "fig32", .source = file.at("source"), .cells = {}};
  for (const auto& [name, columns] : file.at("rows").items()) {
    for (const auto& [column, entry] : columns.items()) {
      Cell cell = published_cell(name, column, entry);
      if (column == "vsg6") {
        for (const auto& [row, value] : measured) {
          if (name == row) cell.measured = static_cast<double>(value);
        }
      } else if (cell.note.empty()) {
        cell.note = "published only: this algorithm is not modelled here";
      }
      table.cells.push_back(std::move(cell));
    }
  }
  return table;
}

}  // namespace program
