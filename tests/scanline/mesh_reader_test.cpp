// Meshes from files: polygons kept, positions joined, mistakes named.
#include "scanline/mesh_reader.h"

#include <map>

#include "tests/scanline/checks.h"

namespace scanline_tests {
namespace {

using Sizes = std::map<std::size_t, int>;

/// A cube with flat normals and a square of texture on each side: 24 corners over 8 positions.
std::string cube_obj() {
  std::string text;
  for (int k = 0; k < 8; ++k) {
    for (int bit = 0; bit < 3; ++bit) text += (bit == 0 ? "v " : " ") + std::to_string(k >> bit & 1);
    text += "\n";
  }
  text += "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  const int faces[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  for (int f = 0; f < 6; ++f) {
    text += "f";
    for (int k = 0; k < 4; ++k) {
      text += " " + std::to_string(faces[f][k]) + "/" + std::to_string(k + 1) + "/" + std::to_string(f + 1);
    }
    text += "\n";
  }
  return text;
}

TEST(MeshReader, ObjKeepsQuadsAndJoinsPositionsOverSeams) {
  const TemporaryFolder folder;
  const scanline::Mesh mesh = scanline::read_mesh_file(folder.write("cube.obj", cube_obj()));
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(sizes(mesh.polygons), (Sizes{{4, 6}}));
  EXPECT_TRUE(open_edges(mesh.polygons).empty());
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
  ASSERT_EQ(mesh.attributes.size(), 2u);
  EXPECT_EQ(mesh.attributes[0].name, "normal");
  EXPECT_EQ(mesh.attributes[1].name, "uv");
  const std::vector<double> first_side{0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  ASSERT_EQ(mesh.attributes[0].values.size(), 72u);
  EXPECT_TRUE(std::equal(first_side.begin(), first_side.end(), mesh.attributes[0].values.begin()));
  EXPECT_EQ(mesh.attributes[1].values.size(), 48u);
}

TEST(MeshReader, ObjKeepsPolygonsOfManySides) {
  const TemporaryFolder folder;
  const auto path = folder.write("star.obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv -1 1 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(scanline::read_mesh_file(path).polygons, (scanline::PolygonList{{0, 1, 2, 3, 4}}));
}

TEST(MeshReader, StlTrianglesAreJoined) {
  const TemporaryFolder folder;
  std::string text = "solid s\n";
  const char* corners[4] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& f : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : f) text += std::string("vertex ") + corners[k] + "\n";
    text += "endloop\nendfacet\n";
  }
  const scanline::Mesh mesh = scanline::read_mesh_file(folder.write("t.stl", text + "endsolid s\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_TRUE(open_edges(mesh.polygons).empty());
  EXPECT_NEAR(volume(mesh), 1.0 / 6, 1e-12);
}

TEST(MeshReader, PlyCarriesColours) {
  const TemporaryFolder folder;
  const scanline::Mesh mesh = scanline::read_mesh_file(
      folder.write("c.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                   "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n"
                   "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 255 255 255\n4 0 1 2 3\n"));
  EXPECT_EQ(sizes(mesh.polygons), (Sizes{{4, 1}}));
  ASSERT_EQ(mesh.attributes.size(), 1u);
  EXPECT_EQ(mesh.attributes[0].name, "color");
  ASSERT_EQ(mesh.attributes[0].values.size(), 16u);
  EXPECT_NEAR(mesh.attributes[0].values[0], 1, 1e-6);
  EXPECT_NEAR(mesh.attributes[0].values[1], 0, 1e-6);
  EXPECT_NEAR(mesh.attributes[0].values[5], 1, 1e-6);
}

TEST(MeshReader, OffWithCommentsAndColours) {
  const scanline::Mesh plain = scanline::read_off(
      "OFF # header\n4 2 0\n0 0 0\n1 0 0 # a corner\n1 1 0\n0 1 0\n\n3 0 1 2 255 0 0\n3 0 2 3\n", "a.off");
  EXPECT_EQ(plain.polygons, (scanline::PolygonList{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(plain.attributes.empty());
  const scanline::Mesh colored =
      scanline::read_off("COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0.5 0.25 0 1\n0 1 0 1 1 1 1\n3 0 1 2\n", "a.off");
  ASSERT_EQ(colored.attributes.size(), 1u);
  EXPECT_EQ(colored.attributes[0].values, (std::vector<double>{1, 0, 0.2, 1, 0.5, 0.25, 0, 1, 1, 1, 1, 1}));
}

TEST(MeshReader, PolygonsWithoutAreaAreDroppedSilently) {
  const scanline::Mesh mesh = scanline::read_off(
      "OFF 5 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 0\n0 0 0\n3 0 1 2\n3 0 1 3\n3 0 4 1\n4 0 1 2 4\n", "a.off");
  // The second is a line, the third names one position twice, the fourth is a triangle in truth.
  EXPECT_EQ(mesh.polygons, (scanline::PolygonList{{0, 1, 2}, {0, 1, 2}}));
}

TEST(MeshReader, OffMistakesNameFileAndLine) {
  const auto read = [](const std::string& text) { return mistake([&] { scanline::read_off(text, "a.off"); }); };
  EXPECT_EQ(read("PLY\n"), "a.off:1: error: an OFF file begins with 'OFF' or 'COFF', not 'PLY'");
  EXPECT_EQ(read("OFF\n3 1\n"), "a.off:2: error: the file ends too early");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"), "a.off:5: error: 'x' is not a finite number");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n"), "a.off:5: error: 'inf' is not a finite number");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "a.off:6: error: '3' is not a whole number from 0 to 2");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
            "a.off:6: error: '-1' is not a whole number from 0 to 2");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
            "a.off:6: error: a polygon needs at least three vertices");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
            "a.off:7: error: more lines than the header announces");
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"), "a.off: error: no polygon with an area in this file");
  EXPECT_EQ(read("OFF\n-3 1 0\n"), "a.off:2: error: '-3' is not a whole number from 0 to 50000000");
}

TEST(MeshReader, MistakesOfOtherFormatsNameTheFile) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& name, const std::string& text) {
    const auto path = folder.write(name, text);
    const std::string message = mistake([&] { scanline::read_mesh_file(path); });
    EXPECT_TRUE(message.starts_with(path.string() + ": error: ")) << message;
    return message;
  };
  const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_NE(read("a.obj", v3 + "f 1 2 4\n"), "");
  EXPECT_NE(read("b.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), "");
  EXPECT_NE(read("c.obj", v3 + "l 1 2\n").find("points or lines"), std::string::npos);
  EXPECT_NE(read("d.obj", v3 + "p 1\n").find("points or lines"), std::string::npos);
  EXPECT_NE(read("e.obj", v3), "");
  EXPECT_NE(read("f.obj", "").find("empty"), std::string::npos);
  EXPECT_NE(read("g.obj", "nothing of the kind\n"), "");
  EXPECT_NE(read("i.stl", "solid\n"), "");
  EXPECT_NE(read("j.gltf", "{}"), "");
  EXPECT_NE(read("k.xyz", "1 2 3\n").find("unknown kind of mesh '.xyz'"), std::string::npos);
}

TEST(MeshReader, PlyMistakesNameFileAndLine) {
  const TemporaryFolder folder;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\n";
  const auto read = [&](const std::string& text) {
    const auto path = folder.write("a.ply", text);
    const std::string message = mistake([&] { scanline::read_mesh_file(path); });
    return message.substr(std::min(message.size(), path.string().size()));
  };
  EXPECT_EQ(read("ply\nformat ascii 1.0\nelement vertex 3\n"), ":3: error: the file ends too early");
  EXPECT_EQ(read("off\n"), ":1: error: a PLY file begins with 'ply'");
  EXPECT_EQ(read(head + "end_header\n0 0 0\n1 0 0\n0 1 0\n"), ":12: error: the file ends too early");
  EXPECT_EQ(read(head + "end_header\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"), ":12: error: 'x' is not a finite number");
  EXPECT_EQ(read(head + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            ":13: error: '3' is not a whole number from 0 to 2");
  EXPECT_EQ(read(head + "end_header\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
            ":13: error: a polygon needs at least three vertices");
  EXPECT_EQ(read(head + "property quad w\nend_header\n"), ":9: error: unknown type in a property");
  EXPECT_EQ(read(head + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "");
}

TEST(MeshReader, MissingFilesAndFoldersAreNamed) {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "no.obj").string();
  EXPECT_EQ(mistake([&] { scanline::read_mesh_file(missing); }), missing + ": error: no such file");
  EXPECT_EQ(mistake([&] { scanline::read_mesh_file(folder.path()); }),
            folder.path().string() + ": error: not a regular file");
}

/// Cutting a file short at any place must end in an error or a mesh, never worse.
TEST(MeshReader, TruncatedFilesNeverCrash) {
  const TemporaryFolder folder;
  const std::string obj = cube_obj();
  std::size_t refused = 0;
  for (std::size_t n = 0; n < obj.size(); n += 7) {
    const auto path = folder.write("cut.obj", obj.substr(0, n));
    refused += !mistake([&] { scanline::read_mesh_file(path); }).empty();
  }
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (std::size_t n = 0; n < ply.size(); n += 3) {
    const auto path = folder.write("cut.ply", ply.substr(0, n));
    refused += !mistake([&] { scanline::read_mesh_file(path); }).empty();
  }
  EXPECT_GT(refused, 50u);
}

}  // namespace
}  // namespace scanline_tests
