// Grey levels of hill shading, computed three ways: by the formula in double precision, by gdaldem, and by the
// project's shaders on the pixel processors.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scanline/terrain/elevation.h"

namespace terrain_tests {

struct Sun {
  double azimuth = 315, elevation = 45;
};

/// Heights of the project's terrain, straight from GDAL, and the size of its cells in metres.
struct Heights {
  int columns = 0, rows = 0;
  double cell_x = 1, cell_y = 1;
  std::vector<std::int16_t> metres;
};
Heights project_heights();

/// floor(1 + 254 N.L + 0.5) with Horn's normals, 1 in the sun's shadow, as gdaldem has it. For interior cells, row by
/// row.
std::vector<int> expected_greys(const Heights& heights, const Sun& sun);

/// What gdaldem makes of the same heights; nothing where it is not installed. Interior cells.
std::optional<std::vector<int>> gdaldem_greys(const Heights& heights, const Sun& sun);

/// Gradients of interior cells by the project's own code.
std::vector<glm::dvec2> interior_gradients(const scanline::Elevation& elevation);

struct ShaderGreys {
  std::vector<int> greys;
  std::uint64_t cycles = 0;  ///< of one region
};
/// The shader of shaders/NAME.pfman for each gradient, scaled to give grey levels as gdaldem does. `fraction`: bits
/// behind the point of terrain_lambert, 0 for its own.
ShaderGreys shader_greys(const std::string& name, int fraction, const std::vector<glm::dvec2>& gradients,
                         const Sun& sun);

struct GreyDifferences {
  int compared = 0, equal = 0, by_one = 0, more = 0, largest = 0;
};
GreyDifferences compare_greys(const std::vector<int>& greys, const std::vector<int>& expected);

}  // namespace terrain_tests
