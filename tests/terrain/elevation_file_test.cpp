// Elevation models from files of several formats, whole and broken.
#include "scanline/terrain/elevation_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "scanline/error.h"
#include "tests/terrain/rasters.h"

namespace terrain_tests {
namespace {

using scanline::Elevation;
using scanline::read_elevation_file;

Raster small() { return {4, 3, {1, 2, 3, 4, 11, 12, 13, 14, 21, 22, 23, 24}}; }

/// The message of the mistake, without the file's name in front; and nothing is printed.
std::string refusal(const std::filesystem::path& path, std::optional<glm::dvec2> cell_size = {}) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string said = "read";
  try {
    read_elevation_file(path, cell_size);
  } catch (const scanline::UserError& e) {
    EXPECT_EQ(e.diagnostics().size(), 1u);
    EXPECT_EQ(e.diagnostics().front().file, path.string());
    said = e.diagnostics().front().message;
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  return said;
}

TEST(ElevationFile, GeoTiffKeepsHeightsAndMetres) {
  const Folder folder;
  write_raster(small(), folder / "a.tif", "GTiff");
  const Elevation e = read_elevation_file(folder / "a.tif");
  EXPECT_EQ(e.columns, 4);
  EXPECT_EQ(e.rows, 3);
  EXPECT_EQ(e.cell_size, glm::dvec2(30, 30));
  EXPECT_EQ(e.heights, (std::vector<float>{1, 2, 3, 4, 11, 12, 13, 14, 21, 22, 23, 24}));
  EXPECT_EQ(e.at(3, 1), 14);
}

TEST(ElevationFile, AsciiGridWrittenByHand) {
  const Folder folder;
  std::ofstream(folder / "a.asc") << "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 12.5\nNODATA_value -9999\n"
                                     "1.5 2 -9999\n4 5 6\n";
  const Elevation e = read_elevation_file(folder / "a.asc");
  EXPECT_EQ(e.cell_size, glm::dvec2(12.5, 12.5));
  EXPECT_EQ(e.at(0, 0), 1.5);
  EXPECT_EQ(e.at(2, 1), 6);
  EXPECT_FALSE(e.known(2, 0));
  EXPECT_TRUE(e.known(1, 0));
}

TEST(ElevationFile, NetCdfWithScaleAndOffset) {
  const Folder folder;
  Raster raster = small();
  raster.type = "Int16";
  raster.scale = 0.5;
  raster.offset = 100;
  raster.missing = 13;
  write_raster(raster, folder / "a.nc", "netCDF");
  const Elevation e = read_elevation_file(folder / "a.nc");
  EXPECT_EQ(e.cell_size, glm::dvec2(30, 30));
  EXPECT_EQ(e.at(0, 0), 100.5);
  EXPECT_EQ(e.at(3, 2), 112);
  EXPECT_FALSE(e.known(2, 1));
}

TEST(ElevationFile, HgtHasDegreesAndVoids) {
  const Folder folder;
  Raster raster;
  raster.columns = raster.rows = 1201;
  raster.type = "Int16";
  raster.epsg = 4326;
  raster.missing = -32768;
  raster.transform = {-85 - 0.5 / 1200, 1 / 1200.0, 0, 37 + 0.5 / 1200, 0, -1 / 1200.0};
  for (int k = 0; k < 1201 * 1201; ++k) raster.values.push_back(k % 3000 - 100);
  raster.values[5] = -32768;
  write_raster(raster, folder / "N36W085.hgt", "SRTMHGT");
  const Elevation e = read_elevation_file(folder / "N36W085.hgt");
  EXPECT_EQ(e.columns, 1201);
  EXPECT_EQ(e.at(6, 0), -94);
  EXPECT_EQ(e.at(1200, 1200), 1201 * 1201 % 3000 - 101);
  EXPECT_FALSE(e.known(5, 0));
  // A degree of a globe of 40,000 km, at 36.5 degrees to the east.
  EXPECT_NEAR(e.cell_size.x * 1200, 111'111 * std::cos(36.5 * std::numbers::pi / 180), 400);
  EXPECT_NEAR(e.cell_size.y * 1200, 111'111, 400);
}

TEST(ElevationFile, DegreesBecomeMetresAsPublished) {
  // Lengths of a degree on WGS 84: 110,574.3 and 111,319.5 m at the equator, 111,131.7 and 78,846.8 m at 45 degrees,
  // 111,412.2 and 55,800.0 m at 60 degrees, to the north and to the east.
  struct Row {
    double latitude, north, east;
  };
  for (const Row& row : {Row{0, 110'574.3, 111'319.5}, Row{45, 111'131.7, 78'846.8}, Row{-60, 111'412.2, 55'800.0}}) {
    const Folder folder;
    Raster raster = small();
    raster.epsg = 4326;
    raster.transform = {10, 0.01, 0, row.latitude + 0.015, 0, -0.01};
    write_raster(raster, folder / "a.tif", "GTiff");
    const Elevation e = read_elevation_file(folder / "a.tif");
    EXPECT_NEAR(e.cell_size.y * 100, row.north, 0.1) << row.latitude;
    EXPECT_NEAR(e.cell_size.x * 100, row.east, 0.1) << row.latitude;
  }
}

TEST(ElevationFile, FeetBecomeMetres) {
  const Folder folder;
  Raster raster = small();
  raster.unit = "ft";
  raster.epsg = 2264;  // North Carolina, US survey feet
  write_raster(raster, folder / "a.tif", "GTiff");
  const Elevation e = read_elevation_file(folder / "a.tif");
  EXPECT_FLOAT_EQ(e.at(3, 2), static_cast<float>(24 * 0.3048));
  EXPECT_NEAR(e.cell_size.x, 30 * 1200.0 / 3937, 1e-9);
}

TEST(ElevationFile, RowsAndColumnsEitherWayRound) {
  const Folder folder;
  Raster raster = small();
  raster.transform = {500'000, 30, 0, 4'000'000, 0, 20};
  write_raster(raster, folder / "south_up.tif", "GTiff");
  raster.transform = {500'000, -30, 0, 4'000'000, 0, -20};
  write_raster(raster, folder / "east_first.tif", "GTiff");
  const Elevation south_up = read_elevation_file(folder / "south_up.tif");
  EXPECT_EQ(south_up.heights, (std::vector<float>{21, 22, 23, 24, 11, 12, 13, 14, 1, 2, 3, 4}));
  EXPECT_EQ(south_up.cell_size, glm::dvec2(30, 20));
  EXPECT_EQ(read_elevation_file(folder / "east_first.tif").heights,
            (std::vector<float>{4, 3, 2, 1, 14, 13, 12, 11, 24, 23, 22, 21}));
}

TEST(ElevationFile, WhatIsNoHeightIsMissing) {
  const Folder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Raster raster = small();
  raster.type = "Float64";
  raster.values = {nan, inf, -inf, 1e300, -9999, 0, -0.0, 1e-300, 3e38, -3e38, 1, 2};
  raster.missing = -9999;
  write_raster(raster, folder / "a.tif", "GTiff");
  const Elevation e = read_elevation_file(folder / "a.tif");
  const std::vector<bool> known{false, false, false, false, false, true, true, true, true, true, true, true};
  for (int k = 0; k < 12; ++k) EXPECT_EQ(e.known(k % 4, k / 4), known[static_cast<std::size_t>(k)]) << k;
}

TEST(ElevationFile, CellSizeStandsInPlaceOfTheFiles) {
  const Folder folder;
  Raster raster = small();
  raster.transform.reset();
  raster.epsg = 0;
  write_raster(raster, folder / "a.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "a.tif"), "the raster has no georeference: 'cell_size' must say how large its cells are");
  EXPECT_EQ(read_elevation_file(folder / "a.tif", glm::dvec2(7, 8)).cell_size, glm::dvec2(7, 8));
}

TEST(ElevationFile, MistakesNameTheFileAndPrintNothing) {
  const Folder folder;
  EXPECT_EQ(refusal(folder / "none.tif"), "cannot open the file");
  EXPECT_EQ(refusal(folder.path()), "cannot open the file");
  EXPECT_EQ(refusal("/vsicurl/http://localhost/a.tif"), "cannot open the file");
  std::ofstream(folder / "text.tif") << "no raster at all";
  EXPECT_TRUE(refusal(folder / "text.tif").starts_with("cannot read a raster: ")) << refusal(folder / "text.tif");
  std::ofstream(folder / "empty.tif") << "";
  EXPECT_TRUE(refusal(folder / "empty.tif").starts_with("cannot read a raster"));

  Raster raster = small();
  raster.transform = {500'000, 30, 1, 4'000'000, 1, -30};
  write_raster(raster, folder / "rotated.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "rotated.tif"), "the raster is rotated: turn it north up with gdalwarp");

  raster = small();
  raster.columns = 12;
  raster.rows = 1;
  write_raster(raster, folder / "row.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "row.tif"), "a terrain needs two rows and two columns at least");

  raster = small();
  raster.values.assign(12, -1);
  raster.missing = -1;
  write_raster(raster, folder / "void.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "void.tif"), "no cell has a height");

  raster = small();
  raster.unit = "furlong";
  write_raster(raster, folder / "unit.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "unit.tif"), "heights in the unit 'furlong' are not known");

  raster = small();
  raster.epsg = 4326;
  write_raster(raster, folder / "pole.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "pole.tif"), "the middle of the raster is at no latitude");

  raster = small();
  raster.transform = {0, 1e-9, 0, 0, 0, -1e-9};
  write_raster(raster, folder / "tiny.tif", "GTiff");
  EXPECT_EQ(refusal(folder / "tiny.tif"), "cells must measure between 1e-6 and 1e9 metres");

  std::ofstream(folder / "large.vrt")
      << "<VRTDataset rasterXSize=\"100000\" rasterYSize=\"100000\"><GeoTransform>0, 1, "
         "0, 0, 0, -1</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"/>"
         "</VRTDataset>";
  EXPECT_EQ(refusal(folder / "large.vrt"), "a terrain has at most 67108864 cells, not 100000 x 100000");
}

TEST(ElevationFile, TruncatedFilesAreRefusedOrRead) {
  const Folder folder;
  Raster raster;
  raster.columns = 20;
  raster.rows = 15;
  for (int k = 0; k < 300; ++k) raster.values.push_back(k);
  write_raster(raster, folder / "whole.tif", "GTiff");
  std::ifstream in(folder / "whole.tif", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  int refused = 0;
  for (std::size_t size = 0; size < bytes.size(); size += 37) {
    std::ofstream(folder / "part.tif", std::ios::binary) << bytes.substr(0, size);
    refused += refusal(folder / "part.tif") != "read" ? 1 : 0;
  }
  EXPECT_GT(refused, 3);
}

TEST(ElevationFile, TheProjectsTerrainIsComplete) {
  const Elevation e = read_elevation_file(std::filesystem::path(VSG_SOURCE_DIR) / "scenes/terrain/jacksboro.tif");
  EXPECT_EQ(e.columns, 403);
  EXPECT_EQ(e.rows, 344);
  const auto [low, high] = std::minmax_element(e.heights.begin(), e.heights.end());
  EXPECT_EQ(*low, 236);
  EXPECT_EQ(*high, 1076);
}

}  // namespace
}  // namespace terrain_tests
