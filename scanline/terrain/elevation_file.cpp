#include "scanline/terrain/elevation_file.h"

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>

#include "scanline/error.h"

namespace scanline {
namespace {

/// Keeps what GDAL would print on this thread: the first failure is what went wrong.
class GdalMessages {
 public:
  GdalMessages() { CPLPushErrorHandlerEx(&GdalMessages::take, this); }
  ~GdalMessages() { CPLPopErrorHandler(); }
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// ": what GDAL said", or nothing.
  std::string text() const { return first_.empty() ? "" : ": " + first_; }

 private:
  static void CPL_STDCALL take(CPLErr kind, CPLErrorNum, const char* message) {
    auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
    if (kind >= CE_Failure && self->first_.empty()) self->first_ = one_line(message);
  }
  static std::string one_line(const char* message) {
    std::string text(message);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    return text;
  }

  std::string first_;
};

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// Metres of a radian to the east and to the south, at a latitude (radians) of the system's ellipsoid.
glm::dvec2 metres_per_radian(const OGRSpatialReference& system, double latitude) {
  const double a = system.GetSemiMajor(), inverse_flattening = system.GetInvFlattening();
  const double f = inverse_flattening == 0 ? 0 : 1 / inverse_flattening;
  const double e2 = f * (2 - f), s = std::sin(latitude);
  const double prime_vertical = a / std::sqrt(1 - e2 * s * s);
  const double meridian = prime_vertical * (1 - e2) / (1 - e2 * s * s);
  return {prime_vertical * std::cos(latitude), meridian};
}

/// Metres of a band's unit of height; 0 for one that is not known.
double unit_of(const std::string& name) {
  for (const char* metre : {"", "m", "metre", "metres", "meter", "meters"}) {
    if (EQUAL(name.c_str(), metre)) return 1;
  }
  for (const char* foot : {"ft", "foot", "feet", "international foot"}) {
    if (EQUAL(name.c_str(), foot)) return 0.3048;
  }
  for (const char* foot : {"us survey foot", "us-ft", "ftus"}) {
    if (EQUAL(name.c_str(), foot)) return 1200.0 / 3937.0;
  }
  for (const char* kilometre : {"km", "kilometre", "kilometer"}) {
    if (EQUAL(name.c_str(), kilometre)) return 1000;
  }
  for (const char* centimetre : {"cm", "centimetre", "centimeter"}) {
    if (EQUAL(name.c_str(), centimetre)) return 0.01;
  }
  return 0;
}

class ElevationReader {
 public:
  explicit ElevationReader(const std::filesystem::path& path) : file_(path.string()) {}

  Elevation read(std::optional<glm::dvec2> cell_size) {
    open();
    GDALRasterBand& band = *dataset_->GetRasterBand(1);
    Elevation elevation;
    elevation.columns = band.GetXSize();
    elevation.rows = band.GetYSize();
    if (elevation.columns < 2 || elevation.rows < 2) refuse("a terrain needs two rows and two columns at least");
    if (static_cast<double>(elevation.columns) * elevation.rows > kMostCells) {
      refuse("a terrain has at most " + std::to_string(static_cast<int>(kMostCells)) + " cells, not " +
             std::to_string(elevation.columns) + " x " + std::to_string(elevation.rows));
    }
    elevation.cell_size = find_cell_size(band, cell_size);
    read_heights(band, elevation);
    turn_north(elevation);
    if (std::all_of(elevation.heights.begin(), elevation.heights.end(), [](float h) { return std::isnan(h); })) {
      refuse("no cell has a height");
    }
    return elevation;
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const { throw UserError({file_, 0, 0, message}); }

  void open() {
    static std::once_flag registered;
    std::call_once(registered, [] { GDALAllRegister(); });
    std::error_code error;
    if (!std::filesystem::is_regular_file(file_, error)) refuse("cannot open the file");
    dataset_.reset(GDALDataset::Open(file_.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (!dataset_) refuse("cannot read a raster" + messages_.text());
    if (dataset_->GetRasterCount() > 0) return;
    char** parts = dataset_->GetMetadata("SUBDATASETS");
    refuse(CSLCount(parts) > 0 ? "the file holds several rasters: take one of them out with gdal_translate"
                               : "the file holds no raster");
  }

  glm::dvec2 find_cell_size(GDALRasterBand& band, std::optional<glm::dvec2> given) {
    std::array<double, 6> t{};
    const bool georeferenced = dataset_->GetGeoTransform(t.data()) == CE_None;
    if (georeferenced) {
      if (!std::all_of(t.begin(), t.end(), [](double v) { return std::isfinite(v); }) || t[1] == 0 || t[5] == 0) {
        refuse("the georeference is not usable");
      }
      if (t[2] != 0 || t[4] != 0) refuse("the raster is rotated: turn it north up with gdalwarp");
      flip_columns_ = t[1] < 0;
      flip_rows_ = t[5] > 0;
    }
    if (given) return *given;
    if (!georeferenced) refuse("the raster has no georeference: 'cell_size' must say how large its cells are");

    glm::dvec2 size(std::abs(t[1]), std::abs(t[5]));
    if (const OGRSpatialReference* system = dataset_->GetSpatialRef()) {
      if (system->IsGeographic()) {
        const double unit = system->GetAngularUnits();
        const double latitude = (t[3] + t[5] * band.GetYSize() / 2) * unit;
        if (!(std::abs(latitude) < std::numbers::pi / 2)) refuse("the middle of the raster is at no latitude");
        size *= unit * metres_per_radian(*system, latitude);
      } else if (system->IsProjected()) {
        size *= system->GetLinearUnits();
      }
    }
    if (!(size.x >= 1e-6 && size.x <= 1e9 && size.y >= 1e-6 && size.y <= 1e9)) {
      refuse("cells must measure between 1e-6 and 1e9 metres");
    }
    return size;
  }

  void read_heights(GDALRasterBand& band, Elevation& elevation) {
    const double unit = unit_of(band.GetUnitType());
    if (unit == 0) refuse("heights in the unit '" + std::string(band.GetUnitType()) + "' are not known");
    const double scale = band.GetScale() * unit, offset = band.GetOffset() * unit;
    const auto columns = static_cast<std::size_t>(elevation.columns);
    elevation.heights.resize(columns * static_cast<std::size_t>(elevation.rows));
    std::vector<double> line(columns);
    std::vector<unsigned char> valid(columns, 255);
    GDALRasterBand* mask = (band.GetMaskFlags() & GMF_ALL_VALID) != 0 ? nullptr : band.GetMaskBand();
    float* to = elevation.heights.data();
    for (int row = 0; row < elevation.rows; ++row) {
      if (band.RasterIO(GF_Read, 0, row, elevation.columns, 1, line.data(), elevation.columns, 1, GDT_Float64, 0, 0,
                        nullptr) != CE_None ||
          (mask != nullptr && mask->RasterIO(GF_Read, 0, row, elevation.columns, 1, valid.data(), elevation.columns, 1,
                                             GDT_Byte, 0, 0, nullptr) != CE_None)) {
        refuse("cannot read row " + std::to_string(row + 1) + messages_.text());
      }
      for (std::size_t k = 0; k < columns; ++k) {
        const double height = line[k] * scale + offset;
        const bool usable = valid[k] != 0 && std::abs(height) <= std::numeric_limits<float>::max();
        *to++ = usable ? static_cast<float>(height) : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }

  /// Rows from north to south, columns from west to east.
  void turn_north(Elevation& elevation) const {
    const auto columns = static_cast<std::ptrdiff_t>(elevation.columns);
    const auto row_at = [&](std::ptrdiff_t row) { return elevation.heights.begin() + row * columns; };
    if (flip_columns_) {
      for (std::ptrdiff_t row = 0; row < elevation.rows; ++row) std::reverse(row_at(row), row_at(row + 1));
    }
    if (!flip_rows_) return;
    for (std::ptrdiff_t row = 0; row < elevation.rows / 2; ++row) {
      std::swap_ranges(row_at(row), row_at(row + 1), row_at(elevation.rows - 1 - row));
    }
  }

  std::string file_;
  GdalMessages messages_;
  std::unique_ptr<GDALDataset, CloseDataset> dataset_;
  bool flip_columns_ = false, flip_rows_ = false;
};

}  // namespace

Elevation read_elevation_file(const std::filesystem::path& path, std::optional<glm::dvec2> cell_size) {
  return ElevationReader(path).read(cell_size);
}

}  // namespace scanline
