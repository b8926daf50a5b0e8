// Digital elevation models from files: whatever GDAL opens, band 1.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>

#include "scanline/terrain/elevation.h"

namespace scanline {

/// The largest rectangle that is read: 64 Mi cells.
constexpr double kMostCells = 67'108'864;

/// Heights become metres by the band's scale, offset and unit (metres when it names none). Cells get their size from
/// the file's georeference: degrees become metres on the reference system's ellipsoid at the middle latitude, a
/// projected system has its own unit, and without any system the unit is the metre. `cell_size` (metres) stands in
/// place of that. Cells are missing where the file says so, or where their height is not finite.
///
/// Throws UserError with the file's name for what GDAL refuses, a rotated raster, one without georeference when no
/// `cell_size` is given, fewer than 2 x 2 cells or more than kMostCells, and one without any known height. A path
/// names a real file: GDAL's virtual file systems are not reached.
Elevation read_elevation_file(const std::filesystem::path& path, std::optional<glm::dvec2> cell_size = {});

}  // namespace scanline
