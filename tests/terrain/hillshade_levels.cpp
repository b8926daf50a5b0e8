// Prints how close the grey levels of the Lambertian reflectance map come to gdaldem's formula, number format by number
// format, on the project's terrain; the shaders run on the pixel processors.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "scanline/terrain/elevation_file.h"
#include "tests/terrain/hillshade.h"

int main(int argc, char** argv) {
  using namespace terrain_tests;
  CLI::App app{"Grey levels of hill shading by the pixel processors against double precision"};
  Sun sun;
  app.add_option("--azimuth", sun.azimuth, "Of the sun, degrees clockwise from north")->capture_default_str();
  app.add_option("--elevation", sun.elevation, "Of the sun, degrees")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const auto file = std::filesystem::path(VSG_SOURCE_DIR) / "scenes/terrain/jacksboro.tif";
  const auto gradients = interior_gradients(scanline::read_elevation_file(file));
  const Heights heights = project_heights();
  const std::vector<int> expected = expected_greys(heights, sun);

  fmt::print("| slopes | cells | equal | off by one | by more | largest | cycles a region |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|\n");
  const auto row = [&](const std::string& what, const std::vector<int>& greys, const std::string& cycles) {
    const GreyDifferences d = compare_greys(greys, expected);
    const double share = 100.0 / d.compared;
    fmt::print("| {} | {} | {:.3f} % | {:.3f} % | {:.3f} % | {} | {} |\n", what, d.compared, d.equal * share,
               d.by_one * share, d.more * share, d.largest, cycles);
  };
  for (const int fraction : {8, 10, 12, 14, 16, 18, 20}) {
    const ShaderGreys shown = shader_greys("terrain_lambert", fraction, gradients, sun);
    row(fmt::format("fixed, {} fraction bits", fraction), shown.greys, std::to_string(shown.cycles));
  }
  const ShaderGreys shown = shader_greys("terrain_lambert_float", 0, gradients, sun);
  row("float", shown.greys, std::to_string(shown.cycles));
  if (const auto gdal = gdaldem_greys(heights, sun)) row("gdaldem itself", *gdal, "");
  return 0;
}
