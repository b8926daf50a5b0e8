#include "scanline/terrain/terrain_reader.h"

#include <memory>
#include <optional>

#include "scanline/terrain/elevation_file.h"
#include "scanline/terrain/terrain_source.h"

namespace scanline {
namespace {

constexpr Range kMetres{1e-6, 1e9, false};
constexpr Range kExaggeration{-1e6, 1e6, false};

std::optional<double> optional_number(TomlTable& t, std::string_view key, const Range& range) {
  if (!t.has(key)) return std::nullopt;
  return t.number(key, 1, range);
}

/// A number stands for square cells.
std::optional<glm::dvec2> read_cell_size(TomlTable& t) {
  if (!t.has("cell_size")) return std::nullopt;
  if (t.node("cell_size")->is_number()) return glm::dvec2(t.number("cell_size", 1, kMetres));
  return t.vector<2>("cell_size", {1, 1}, kMetres);
}

}  // namespace

Geometry read_terrain(TomlTable& t, const std::filesystem::path& folder) {
  const std::size_t before = t.mistakes().list.size();
  const std::string name = t.text("file", "");
  if (!t.has("file")) t.missing("file");
  const std::optional<glm::dvec2> cell_size = read_cell_size(t);
  const double exaggeration = t.number("exaggeration", 1, kExaggeration);
  const std::optional<double> unit = optional_number(t, "unit", kPositive), base = optional_number(t, "base", {});
  const bool fill = t.choice("missing", {"hole", "fill"}, 0) == 1;
  const double detail = t.number("detail", 1, kPositive);
  const int resolution = t.integer("resolution", 1, 1, 1'000'000);
  if (t.has("detail") && t.has("resolution")) {
    t.mistakes().add(t.where("resolution"), "a terrain has either 'detail' or 'resolution'");
  }
  if (t.mistakes().list.size() > before) return {};

  const std::filesystem::path file = folder / name;
  try {
    Elevation elevation = read_elevation_file(file, cell_size);
    if (fill) fill_missing(elevation);
    TerrainSurface surface(std::move(elevation), exaggeration, unit, base);
    if (t.has("resolution")) return {terrain_grid(surface, resolution, file.string()), {}, {}};
    return {{}, std::make_shared<TerrainSource>(std::move(surface), detail, file.string()), {}};
  } catch (const UserError& e) {
    t.mistakes().add(t.where("file"), "cannot use '" + name + "'");
    t.mistakes().list.insert(t.mistakes().list.end(), e.diagnostics().begin(), e.diagnostics().end());
    return {};
  }
}

}  // namespace scanline
