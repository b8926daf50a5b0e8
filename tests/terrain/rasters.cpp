#include "tests/terrain/rasters.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace terrain_tests {
namespace {

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

void demand(bool good, const char* what) {
  if (!good) throw std::runtime_error(std::string("GDAL does not ") + what + ": " + CPLGetLastErrorMsg());
}

}  // namespace

Folder::Folder() {
  static std::atomic<int> number{0};
  path_ = std::filesystem::temp_directory_path() /
          ("terrain_test_" + std::to_string(getpid()) + "_" + std::to_string(number++));
  std::filesystem::create_directories(path_);
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_raster(const Raster& raster, const std::filesystem::path& path, const std::string& driver) {
  GDALAllRegister();
  GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDriver* const target = GetGDALDriverManager()->GetDriverByName(driver.c_str());
  demand(memory != nullptr && target != nullptr, "have the driver");
  Dataset dataset(
      memory->Create("", raster.columns, raster.rows, 1, GDALGetDataTypeByName(raster.type.c_str()), nullptr));
  demand(dataset != nullptr, "make a raster");
  if (raster.transform) {
    std::array<double, 6> transform = *raster.transform;
    dataset->SetGeoTransform(transform.data());
  }
  if (raster.epsg != 0) {
    OGRSpatialReference system;
    system.importFromEPSG(raster.epsg);
    dataset->SetSpatialRef(&system);
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (raster.missing) band.SetNoDataValue(*raster.missing);
  if (raster.scale) band.SetScale(*raster.scale);
  if (raster.offset) band.SetOffset(*raster.offset);
  if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
  std::vector<double> values = raster.values;
  demand(band.RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, values.data(), raster.columns, raster.rows,
                       GDT_Float64, 0, 0, nullptr) == CE_None,
         "take the heights");
  const Dataset copy(target->CreateCopy(path.c_str(), dataset.get(), FALSE, nullptr, nullptr, nullptr));
  demand(copy != nullptr, "write the file");
}

scanline::Elevation random_elevation(int columns, int rows, double relief, std::mt19937_64& random) {
  scanline::Elevation elevation{columns, rows, {30, 25}, {}};
  std::uniform_real_distribution<float> height(0, static_cast<float>(relief));
  for (int k = 0; k < columns * rows; ++k) elevation.heights.push_back(height(random));
  return elevation;
}

scanline::Elevation hills(int columns, int rows, std::mt19937_64& random) {
  scanline::Elevation elevation{columns, rows, {30, 25}, {}};
  std::uniform_real_distribution<double> unit(0, 1);
  struct Wave {
    double x, y, phase, height;
  };
  std::vector<Wave> waves;
  for (int k = 0; k < 6; ++k) {
    const double size = 6 * std::pow(2, k), turn = 2 * std::numbers::pi * unit(random);
    waves.push_back({std::cos(turn) / size, std::sin(turn) / size, 6 * unit(random), 3 * size * unit(random)});
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      double height = 2 * unit(random);
      for (const Wave& w : waves) {
        height += w.height * std::sin(2 * std::numbers::pi * (w.x * column + w.y * row) + w.phase);
      }
      elevation.heights.push_back(static_cast<float>(height));
    }
  }
  return elevation;
}

}  // namespace terrain_tests
