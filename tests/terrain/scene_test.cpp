// geometry = "terrain" in scene files.
#include "scanline/scene.h"

#include <gtest/gtest.h>

#include <string>

#include "scanline/error.h"
#include "scanline/scene_frame.h"
#include "tests/terrain/rasters.h"

namespace terrain_tests {
namespace {

using scanline::Scene;

constexpr const char* kHead = "version = 1\n[[object]]\ngeometry = \"terrain\"\n";

class TerrainScene : public testing::Test {
 protected:
  TerrainScene() {
    Raster raster{6, 5, {}};
    for (int k = 0; k < 30; ++k) raster.values.push_back(k * k % 37);
    raster.missing = raster.values[14];
    write_raster(raster, folder_ / "a.tif", "GTiff");
  }
  Scene read(const std::string& keys) const { return scanline::read_scene(kHead + keys, folder_ / "a.toml"); }
  /// Every mistake, without the folder in front.
  std::string mistakes(const std::string& keys) const {
    try {
      read(keys);
      return "none";
    } catch (const scanline::UserError& e) {
      std::string text = e.what();
      const std::string front = folder_.path().string() + "/";
      for (std::size_t at; (at = text.find(front)) != std::string::npos;) text.erase(at, front.size());
      return text;
    }
  }
  Folder folder_;
};

TEST_F(TerrainScene, DetailIsASourceResolutionAMesh) {
  const Scene by_detail = read("file = \"a.tif\"");
  ASSERT_NE(by_detail.objects[0].source, nullptr);
  EXPECT_TRUE(by_detail.objects[0].mesh.polygons.empty());
  const Scene fixed = read("file = \"a.tif\"\nresolution = 1\nmissing = \"fill\"");
  EXPECT_EQ(fixed.objects[0].source, nullptr);
  EXPECT_EQ(fixed.objects[0].mesh.polygons.size(), 40u);
  EXPECT_EQ(fixed.objects[0].mesh.attributes.size(), 4u);
}

TEST_F(TerrainScene, MissingCellsAreHolesUnlessFilled) {
  const std::size_t holes = read("file = \"a.tif\"\nresolution = 1").objects[0].mesh.polygons.size();
  EXPECT_LT(holes, 40u);
  EXPECT_EQ(read("file = \"a.tif\"\nresolution = 1\nmissing = \"hole\"").objects[0].mesh.polygons.size(), holes);
}

TEST_F(TerrainScene, ViewersDistanceDecidesInAFrame) {
  Raster raster{129, 129, {}};
  for (int k = 0; k < 129 * 129; ++k) raster.values.push_back(k * 7919 % 101);
  write_raster(raster, folder_ / "rough.tif", "GTiff");
  const auto polygons = [&](const std::string& height) {
    const std::string camera = "version = 1\n[camera]\nposition = [0, " + height +
                               ", 0]\nup = [0, 0, -1]\nnear = 0.01\nfar = 1e6\n[[object]]\ngeometry = \"terrain\"\n";
    const Scene scene = scanline::read_scene(camera + "file = \"rough.tif\"", folder_ / "a.toml");
    return scanline::make_scene_frame(scene, 1, 256, 256).frame.polygons.size();
  };
  EXPECT_GT(polygons("3"), 10 * polygons("60"));
}

TEST_F(TerrainScene, EveryMistakeIsTold) {
  EXPECT_EQ(mistakes(""), "a.toml:2:1: error: object needs the key 'file'");
  EXPECT_EQ(mistakes("file = \"b.tif\""), "a.toml:4:8: error: cannot use 'b.tif'\nb.tif: error: cannot open the file");
  EXPECT_EQ(mistakes("file = \"a.tif\"\ndetail = 1\nresolution = 2"),
            "a.toml:6:14: error: a terrain has either 'detail' or 'resolution'");
  const std::string many = mistakes(
      "file = \"a.tif\"\ndetail = 0\nunit = -1\nexaggeration = \"much\"\nmissing = \"sea\"\ncell_size = [1]\nheight = "
      "3");
  for (const char* key : {"'detail'", "'unit'", "'exaggeration'", "'missing'", "'cell_size'", "'height'"}) {
    EXPECT_NE(many.find(key), std::string::npos) << key << " in:\n" << many;
  }
}

TEST_F(TerrainScene, CellSizeAsNumberOrTwo) {
  const auto ends = [&](const std::string& keys) {
    const scanline::Mesh mesh =
        read("file = \"a.tif\"\nresolution = 1\nmissing = \"fill\"\nunit = 1\n" + keys).objects[0].mesh;
    return mesh.positions.back() - mesh.positions.front();
  };
  EXPECT_EQ(ends("").x, 150);
  EXPECT_EQ(ends("cell_size = 2").x, 10);
  EXPECT_EQ(ends("cell_size = [2, 3]").z, 12);
}

}  // namespace
}  // namespace terrain_tests
