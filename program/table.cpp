#include "program/table.h"

#include <fmt/format.h>

#include <cmath>

namespace program {
namespace {

nlohmann::ordered_json number_json(std::optional<double> value) {
  if (!value) return nullptr;
  if (std::floor(*value) == *value) return static_cast<std::int64_t>(*value);
  return std::round(*value * 1e4) / 1e4;
}

nlohmann::ordered_json text_or_null(const std::string& text) {
  if (text.empty()) return nullptr;
  return text;
}

}  // namespace

std::optional<double> Cell::ratio() const {
  if (!published || !measured || *published == 0) return {};
  return *measured / *published;
}

Cell published_cell(const std::string& name, const std::string& column, const nlohmann::json& entry) {
  Cell cell;
  cell.name = name;
  cell.column = column;
  cell.confidence = entry.at("confidence");
  if (!entry.at("published").is_null()) cell.published = entry.at("published").get<double>();
  cell.note = entry.value("note", "");
  return cell;
}

nlohmann::ordered_json table_json(const Table& table) {
  nlohmann::ordered_json object{{"table", table.name}, {"source", table.source}};
  auto& rows = object["rows"] = nlohmann::ordered_json::array();
  for (const Cell& cell : table.cells) {
    nlohmann::ordered_json row{{"name", cell.name},
                               {"column", cell.column},
                               {"published", number_json(cell.published)},
                               {"confidence", text_or_null(cell.confidence)},
                               {"measured", number_json(cell.measured)},
                               {"ratio", number_json(cell.ratio())}};
    if (cell.max_error_ulp) row["max_error_ulp"] = number_json(cell.max_error_ulp);
    if (cell.workspace_bytes) row["workspace_bytes"] = *cell.workspace_bytes;
    if (!cell.note.empty()) row["note"] = cell.note;
    rows.push_back(std::move(row));
  }
  return object;
}

std::string number_text(std::optional<double> value) {
  if (!value) return "-";
  return std::floor(*value) == *value ? fmt::format("{:.0f}", *value) : fmt::format("{:.2f}", *value);
}

std::string published_text(const Cell& cell) {
  const char* doubt = cell.confidence == "likely" ? "~" : cell.confidence == "unreadable" ? "?" : " ";
  return number_text(cell.published) + doubt;
}

std::string table_text(const Table& table) {
  std::string text = table.source + "\n\n";
  text += fmt::format("{:28}{:24}{:>11} {:>10}{:>8}  {}\n", "name", "column", "published", "measured", "ratio", "");
  for (const Cell& cell : table.cells) {
    const auto ratio = cell.ratio();
    text += fmt::format("{:28}{:24}{:>12}{:>10}{:>8}  {}\n", cell.name, cell.column, published_text(cell),
                        number_text(cell.measured), ratio ? fmt::format("{:.2f}", *ratio) : "-", cell.note);
  }
  return text;
}

}  // namespace program
