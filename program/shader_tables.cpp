#include "program/shader_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/shading_node.h"
#include "pixelflow/shading/test_surface.h"
#include "pixelflow/shading/test_textures.h"
#include "program/shader_file.h"
#include "program/tables.h"

namespace program {
namespace {

using pixelflow::Code;

class Shaders {
 public:
  explicit Shaders(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const pfman::CompiledShader& operator[](const std::string& name) {
    std::unique_ptr<ShaderFile>& file = files_[name];
    if (!file) file = read_shader_file((folder_ / (name + ".pfman")).string(), {});
    return file->shader(name);
  }

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::unique_ptr<ShaderFile>> files_;
};

/// The surfaces, in the order in which the documents show them.
const std::vector<std::string>& surfaces() {
  static const std::vector<std::string> names{"simple_brick", "fancy_brick",    "ripple_mirror",    "wood_planks",
                                              "volume_wood",  "bowling_pin",    "data_contours",    "data_height",
                                              "data_blend",   "opengl_surface", "mandelbrot_float", "mandelbrot_fixed"};
  return names;
}

const char* kind_of(Code code) {
  switch (code) {
    case Code::Copy:
    case Code::Wrap:
    case Code::Saturate:
    case Code::ShiftLeft:
    case Code::ShiftRight: return "moves";
    case Code::Add:
    case Code::Sub: return "fixed_add";
    case Code::Multiply: return "fixed_multiply";
    case Code::Divide:
    case Code::Remainder:
    case Code::SquareRoot: return "fixed_divide_sqrt";
    case Code::Less:
    case Code::LessEqual:
    case Code::Equal:
    case Code::FloatLess:
    case Code::FloatLessEqual:
    case Code::FloatEqual: return "comparisons";
    case Code::FloatAdd:
    case Code::FloatSub: return "float_add";
    case Code::FloatMultiply: return "float_multiply";
    case Code::FloatDivide:
    case Code::FloatSquareRoot:
    case Code::InverseSquareRoot: return "float_divide_sqrt";
    case Code::FixedToFloat:
    case Code::FloatToFixed: return "conversions";
    case Code::NoiseFixed:
    case Code::NoiseFloat: return "noise";
    default: return "functions";
  }
}

using Counts = std::map<std::string, int>;

void count_operations(const pfman::Stream& stream, Counts& counts) {
  for (const pfman::Stream::Part& part : stream.parts) {
    for (const pixelflow::Step& step : part.program.steps) {
      if (step.operation) ++counts[kind_of(step.operation->code)];
    }
    if (part.lookup) ++counts["lookups"];
  }
}

struct Measured {
  int bytes_free = 0;
  std::uint64_t cycles = 0;
  pfman::ShadingNode::Cycles stages;
  Counts operations;  ///< of the surface
};

/// One region, or the rows of it that the array has.
Measured measure(const pfman::CompiledShader& surface, const pfman::CompiledShader& lamp,
                 pixelflow::PixelArray& array) {
  const pfman::TestSurface scene{pfman::TestView{}};
  pfman::Instance instance(surface, 1);
  pfman::TestSurface::make_ordinary(instance);
  scene.place(instance);
  const pfman::Instance light(lamp);
  const pfman::TextureMemory textures = pfman::test_textures();
  std::vector<pfman::Instance> lights;
  if (surface.code.has_illuminance) lights.push_back(light);
  pfman::ShadingNode node({instance}, lights, &textures);
  scene.fill(instance, 0, 0, array);

  Measured measured;
  const std::uint64_t before = array.counters().cycles;
  node.shade(array);
  measured.cycles = array.counters().cycles - before;
  measured.stages = node.cycles();
  measured.bytes_free = pfman::kSharedAt - surface.map.first_free;
  if (!lights.empty())
    measured.bytes_free = std::min(measured.bytes_free, lamp.map.first_free - surface.map.high_water);

  const pfman::Streams streams = pfman::generate(surface, {.uniforms = instance.uniforms(),
                                                           .bound_varying = instance.bound(),
                                                           .shader_ids = {1},
                                                           .lights = static_cast<int>(lights.size())});
  count_operations(streams.pre, measured.operations);
  for (const pfman::Stream& stream : streams.illum) count_operations(stream, measured.operations);
  count_operations(streams.post, measured.operations);
  return measured;
}

/// `note`: our shader of a published name.
Cell cell(const std::string& name, const std::string& column, double value, const std::string& note = {}) {
  Cell made;
  made.name = name;
  made.column = column;
  made.measured = value;
  made.note = note;
  return made;
}

double published(const nlohmann::json& table, const std::string& row, const std::string& column) {
  const auto& columns = table.at("columns");
  const auto at = std::find(columns.begin(), columns.end(), column) - columns.begin();
  return table.at(row).at(static_cast<std::size_t>(at)).get<double>();
}

/// Rows of a published table in the paper's order, and our shaders under these names.
using Rows = std::vector<std::pair<std::string, std::string>>;

Rows rows(const nlohmann::json& file, const char* names, const std::vector<std::string>& order) {
  Rows found;
  for (const std::string& row : order) found.emplace_back(row, file.at("names").at(names).at(row));
  return found;
}

bool shown(const Rows& rows, const std::string& shader) {
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.second == shader; });
}

std::size_t width_of(const std::string& name) { return std::max<std::size_t>(name.size(), 8); }

}  // namespace

Table pixelflow1(pixelflow::PixelArray& array, const std::filesystem::path& data) {
  const nlohmann::json file = read_table_file(data / "tables" / "pixelflow.json");
  Shaders shaders(data / "shaders");
  std::map<std::string, Measured> measured;
  for (const std::string& name : surfaces()) {
    const pfman::CompiledShader& surface = shaders[name];
    measured[name] = measure(surface, shaders[surface.shader->three_colours ? "opengl_light" : "point_light"], array);
  }

  Table table{"pixelflow1", "Olano and Lastra 1998, table 1: memory and cycles of shaders, one light", {}};
  const nlohmann::json& section = file.at("table1_shaders");
  const Rows published_rows = rows(file, "table1",
                                   {"brick", "ripple_reflection", "planks", "bowling_pin", "nanomanipulator_1",
                                    "nanomanipulator_2", "nanomanipulator_3"});
  for (const auto& [row, name] : published_rows) {
    const Measured& found = measured.at(name);
    Cell free = cell(row, "bytes_free", found.bytes_free, name);
    free.published = published(section, row, "bytes_free");
    Cell cycles = cell(row, "cycles_per_region", static_cast<double>(found.cycles), name);
    cycles.published = published(section, row, "cycles_per_region");
    table.cells.push_back(free);
    table.cells.push_back(cycles);
  }
  for (const std::string& name : surfaces()) {
    const Measured& found = measured.at(name);
    if (!shown(published_rows, name)) {
      table.cells.push_back(cell(name, "bytes_free", found.bytes_free));
      table.cells.push_back(cell(name, "cycles_per_region", static_cast<double>(found.cycles)));
    }
    table.cells.push_back(cell(name, "cycles_before_lights", static_cast<double>(found.stages.pre)));
    table.cells.push_back(cell(name, "cycles_a_light", static_cast<double>(found.stages.illum)));
    table.cells.push_back(cell(name, "cycles_after_lights", static_cast<double>(found.stages.post)));
    table.cells.push_back(cell(name, "cycles_of_light", static_cast<double>(found.stages.lights)));
    for (const auto& [kind, count] : found.operations) table.cells.push_back(cell(name, "operations_" + kind, count));
  }
  return table;
}

Table pixelflow4(const std::filesystem::path& data) {
  const nlohmann::json file = read_table_file(data / "tables" / "pixelflow.json");
  Shaders shaders(data / "shaders");
  Table table{"pixelflow4", "Olano and Lastra 1998, table 4: bytes of shaders' variables", {}};
  const nlohmann::json& section = file.at("table4_shader_memory_bytes");
  const auto add = [&](const std::string& row, const std::string& name, bool in_paper) {
    const pfman::CompiledShader& shader = shaders[name];
    const pfman::MemoryMap& map = shader.map;
    const std::string note = in_paper ? name : "";
    const auto share = [](double only, double with) { return 100 * (only - with) / only; };
    std::vector<Cell> cells{cell(row, "total_uniform_and_varying", map.uniform_bytes + map.varying_bytes, note),
                            cell(row, "varying_only", map.varying_bytes, note),
                            cell(row, "varying_with_allocation", map.allocated_bytes, note),
                            cell(row, "saved_percent", share(map.varying_bytes, map.allocated_bytes), note)};
    if (in_paper) {
      for (std::size_t n = 0; n < 3; ++n) cells[n].published = published(section, row, cells[n].column);
      cells[3].published = share(*cells[1].published, *cells[2].published);
    }
    // What a shader writer sees of it: the paper does not say whether it counts the compiler's own variables.
    cells.push_back(cell(row, "varying_of_the_source", shader.code.source_bytes, note));
    cells.push_back(
        cell(row, "saved_percent_of_the_source", share(shader.code.source_bytes, map.allocated_bytes), note));
    table.cells.insert(table.cells.end(), cells.begin(), cells.end());
  };
  const Rows published_rows = rows(file, "table4", {"simple_brick", "fancy_brick", "ripple_reflection", "wood_planks"});
  for (const auto& [row, name] : published_rows) add(row, name, true);
  for (const std::string& name : surfaces()) {
    if (!shown(published_rows, name)) add(name, name, false);
  }
  return table;
}

std::string shader_table_text(const Table& table) {
  Table compared{table.name, table.source, {}};
  std::vector<std::string> names, columns;
  std::map<std::pair<std::string, std::string>, std::string> others;
  const auto add = [](std::vector<std::string>& list, const std::string& word) {
    if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
  };
  for (const Cell& cell : table.cells) {
    if (cell.published) compared.cells.push_back(cell);
    const std::string& shader = cell.note.empty() ? cell.name : cell.note;
    add(names, shader);
    add(columns, cell.column);
    others[{shader, cell.column}] = number_text(cell.measured);
  }
  std::string text = table_text(compared);
  constexpr std::size_t kTogether = 6;  // shaders side by side
  for (std::size_t first = 0; first < names.size(); first += kTogether) {
    const std::span<const std::string> some(names.data() + first, std::min(kTogether, names.size() - first));
    text += fmt::format("\n{:28}", "");
    for (const std::string& name : some) text += fmt::format(" {:>{}}", name, width_of(name));
    text += "\n";
    for (const std::string& column : columns) {
      text += fmt::format("{:28}", column);
      for (const std::string& name : some) {
        const auto found = others.find({name, column});
        text += fmt::format(" {:>{}}", found == others.end() ? "-" : found->second, width_of(name));
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace program
