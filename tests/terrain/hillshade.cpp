#include "tests/terrain/hillshade.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/compile.h"
#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/shading_node.h"
#include "scanline/terrain/elevation_file.h"
#include "tests/terrain/rasters.h"

namespace terrain_tests {
namespace {

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

Dataset open(const std::filesystem::path& path) {
  GDALAllRegister();
  Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (!dataset) throw std::runtime_error("cannot open " + path.string());
  return dataset;
}

}  // namespace

Heights project_heights() {
  const auto path = std::filesystem::path(VSG_SOURCE_DIR) / "scenes/terrain/jacksboro.tif";
  const Dataset dataset = open(path);
  Heights heights{dataset->GetRasterXSize(), dataset->GetRasterYSize(), 1, 1, {}};
  heights.metres.resize(static_cast<std::size_t>(heights.columns) * static_cast<std::size_t>(heights.rows));
  if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, heights.columns, heights.rows, heights.metres.data(),
                                          heights.columns, heights.rows, GDT_Int16, 0, 0, nullptr) != CE_None) {
    throw std::runtime_error("cannot read " + path.string());
  }
  const glm::dvec2 cell = scanline::read_elevation_file(path).cell_size;
  heights.cell_x = cell.x;
  heights.cell_y = cell.y;
  return heights;
}

std::vector<int> expected_greys(const Heights& h, const Sun& sun) {
  const double degree = std::numbers::pi / 180;
  // Angles as on the map, counter-clockwise from the east.
  const double around = (90 - sun.azimuth) * degree, above = sun.elevation * degree;
  std::vector<int> greys;
  for (int row = 1; row + 1 < h.rows; ++row) {
    for (int column = 1; column + 1 < h.columns; ++column) {
      const auto at = [&](int right, int down) {
        return static_cast<double>(h.metres[static_cast<std::size_t>((row + down) * h.columns + column + right)]);
      };
      double east = 0, north = 0;
      for (int k = -1; k <= 1; ++k) {
        const double weight = k == 0 ? 2 : 1;
        east += weight * (at(1, k) - at(-1, k));
        north += weight * (at(k, -1) - at(k, 1));
      }
      east /= 8 * h.cell_x;
      north /= 8 * h.cell_y;
      const double cosine = (std::sin(above) - std::cos(above) * (std::cos(around) * east + std::sin(around) * north)) /
                            std::sqrt(1 + east * east + north * north);
      greys.push_back(cosine <= 0 ? 1 : static_cast<int>(std::floor(1 + 254 * cosine + 0.5)));
    }
  }
  return greys;
}

std::optional<std::vector<int>> gdaldem_greys(const Heights& h, const Sun& sun) {
#ifdef GDALDEM
  const Folder folder;
  Raster raster{h.columns, h.rows, {h.metres.begin(), h.metres.end()}};
  raster.type = "Int16";
  raster.epsg = 0;
  raster.transform = {0, h.cell_x, 0, 0, 0, -h.cell_y};
  write_raster(raster, folder / "heights.tif", "GTiff");
  const std::string command = std::string(GDALDEM) + " hillshade -q -alg Horn -az " + std::to_string(sun.azimuth) +
                              " -alt " + std::to_string(sun.elevation) + " '" + (folder / "heights.tif").string() +
                              "' '" + (folder / "shade.tif").string() + "'";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  const Dataset dataset = open(folder / "shade.tif");
  std::vector<int> all(h.metres.size());
  if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, h.columns, h.rows, all.data(), h.columns, h.rows, GDT_Int32, 0,
                                          0, nullptr) != CE_None) {
    return std::nullopt;
  }
  std::vector<int> greys;
  for (int row = 1; row + 1 < h.rows; ++row) {
    for (int column = 1; column + 1 < h.columns; ++column) {
      greys.push_back(all[static_cast<std::size_t>(row * h.columns + column)]);
    }
  }
  return greys;
#else
  static_cast<void>(h);
  static_cast<void>(sun);
  return std::nullopt;
#endif
}

std::vector<glm::dvec2> interior_gradients(const scanline::Elevation& elevation) {
  std::vector<glm::dvec2> gradients;
  for (int row = 1; row + 1 < elevation.rows; ++row) {
    for (int column = 1; column + 1 < elevation.columns; ++column) {
      gradients.push_back(scanline::gradient(elevation, column, row));
    }
  }
  return gradients;
}

ShaderGreys shader_greys(const std::string& name, int fraction, const std::vector<glm::dvec2>& gradients,
                         const Sun& sun) {
  std::string text;
  if (fraction > 0) text = "#define FRACTION " + std::to_string(fraction) + "\n";
  text += "#include \"" + name + ".pfman\"\n";
  pfman::Diagnostics diagnostics;
  const auto unit = pfman::compile_text(text, std::string(VSG_SOURCE_DIR) + "/shaders/levels.pfman", {}, diagnostics);
  if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.text());

  pfman::Instance instance(unit->shaders.front(), 1);
  instance.make_ordinary("gradient");
  instance.set("azimuth", {sun.azimuth});
  instance.set("elevation", {sun.elevation});
  instance.set("ambient", {1.5 / 256});
  instance.set("diffuse", {254.0 / 256});
  pfman::ShadingNode node({instance}, {}, nullptr);
  const pfman::TransferEntry entry = pfman::transfer_map(instance.shader()).entries.at(0);
  const int bytes = entry.type.scalar.bytes();

  const auto array =
      pixelflow::make_golden_array(pixelflow::Level::Macro, pixelflow::kRegionWidth * pixelflow::kRegionHeight);
  const auto lanes = static_cast<std::size_t>(array->lanes());
  ShaderGreys result;
  std::vector<std::vector<std::uint8_t>> memory(static_cast<std::size_t>(2 * bytes), std::vector<std::uint8_t>(lanes));
  std::vector<std::uint8_t> ids(lanes), color(lanes);
  const std::vector<std::uint8_t> zeros(lanes);
  for (std::size_t first = 0; first < gradients.size(); first += lanes) {
    const std::size_t count = std::min(lanes, gradients.size() - first);
    for (std::size_t k = 0; k < lanes; ++k) ids[k] = k < count ? 1 : 0;
    for (std::size_t k = 0; k < count; ++k) {
      for (int n = 0; n < 2; ++n) {
        const std::uint64_t raw = pfman::from_double(gradients[first + k][n], entry.type.scalar);
        for (int b = 0; b < bytes; ++b) {
          memory[static_cast<std::size_t>(n * bytes + b)][k] = static_cast<std::uint8_t>(raw >> (8 * b));
        }
      }
    }
    array->write(pfman::kShaderIdAt, ids);
    array->write(pfman::kShaderIdAt + 1, zeros);
    for (int b = 0; b < 2 * bytes; ++b) array->write(entry.address + b, memory[static_cast<std::size_t>(b)]);
    node.shade(*array);
    if (first == 0) result.cycles = node.cycles().pre;
    array->read(pfman::kColorAt, color);
    result.greys.insert(result.greys.end(), color.begin(), color.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return result;
}

GreyDifferences compare_greys(const std::vector<int>& greys, const std::vector<int>& expected) {
  if (greys.size() != expected.size()) throw std::invalid_argument("different numbers of grey levels");
  GreyDifferences d;
  for (std::size_t k = 0; k < greys.size(); ++k) {
    const int away = std::abs(greys[k] - expected[k]);
    ++d.compared;
    d.equal += away == 0 ? 1 : 0;
    d.by_one += away == 1 ? 1 : 0;
    d.more += away > 1 ? 1 : 0;
    d.largest = std::max(d.largest, away);
  }
  return d;
}

}  // namespace terrain_tests
