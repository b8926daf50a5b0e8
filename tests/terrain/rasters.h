// Rasters for tests, written by GDAL into a folder that is gone after the test.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "scanline/terrain/elevation.h"

namespace terrain_tests {

/// A folder of its own for every test.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Raster {
  int columns = 0, rows = 0;
  std::vector<double> values = {};  ///< as they stand in the file, row by row
  std::string type = "Float32";
  std::optional<std::array<double, 6>> transform = std::array<double, 6>{500'000, 30, 0, 4'000'000, 0, -30};
  int epsg = 32616;  ///< 0: no reference system
  std::optional<double> missing = {};
  std::optional<double> scale = {}, offset = {};
  std::string unit = {};
};

/// Throws std::runtime_error where GDAL refuses.
void write_raster(const Raster& raster, const std::filesystem::path& path, const std::string& driver);

/// Heights between 0 and `relief` metres, each on its own.
scanline::Elevation random_elevation(int columns, int rows, double relief, std::mt19937_64& random);

/// Hills of a few sizes and a little noise.
scanline::Elevation hills(int columns, int rows, std::mt19937_64& random);

}  // namespace terrain_tests
