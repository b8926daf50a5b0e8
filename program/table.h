// Tables that hold a published figure against a measured one, cell by cell.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace program {

struct Cell {
  std::string name, column;
  std::optional<double> published;
  std::string confidence;  ///< "certain", "likely" or "unreadable": how well the print can be read; empty where the
                           ///< source has no such cell
  std::optional<double> measured;
  std::string note;
  std::optional<double> max_error_ulp{};  ///< of arithmetic and functions
  std::optional<int> workspace_bytes{};   ///< of a pixel's memory, operands and result apart

  /// Measured over published; none where either is missing or the published figure is zero.
  std::optional<double> ratio() const;
};

struct Table {
  std::string name;    ///< as `vsg tables` calls it
  std::string source;  ///< where the published figures stand
  std::vector<Cell> cells;
};

/// A cell of a file in tables/; what was measured is added by the caller.
Cell published_cell(const std::string& name, const std::string& column, const nlohmann::json& entry);

/// What `vsg tables NAME --json` prints (docs/formats.md).
nlohmann::ordered_json table_json(const Table& table);

/// A number for people: whole numbers without a point, others with two decimals; a dash for none.
std::string number_text(std::optional<double> value);

/// The number and its doubt: "~" behind one that is likely, "?" behind one that cannot be read.
std::string published_text(const Cell& cell);

/// One line a cell: name, column, published, measured, ratio, note.
std::string table_text(const Table& table);

}  // namespace program
