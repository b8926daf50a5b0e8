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
  EXPECT_NE(read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "");
  EXPECT_NE(read("b.obj", "").find("empty"), std::string::npos);
  EXPECT_NE(read("c.stl", "solid\nendsolid\n"), "");
  EXPECT_NE(read("j.gltf", "{}"), "");
  EXPECT_NE(read("k.xyz", "1 2 3\n").find("unknown kind of mesh '.xyz'"), std::string::npos);
}

/// What reading a file of this text is refused with, after the file's name; an empty text when it is not refused.
std::string refusal(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const auto path = folder.write(name, text);
  const std::string message = mistake([&] { scanline::read_mesh_file(path); });
  EXPECT_TRUE(message.empty() || message.starts_with(path.string() + ":")) << message;
  return message.substr(std::min(message.size(), path.string().size()));
}

TEST(MeshReader, ObjMistakesNameLineAndColumn) {
  const TemporaryFolder folder;
  const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto read = [&](const std::string& text) { return refusal(folder, "a.obj", text); };
  const std::string vertex = "3 numbers expected after 'v', 4 with a weight or 6 with a colour";
  EXPECT_EQ(read(v3 + "v 1 2\nf 1 2 3\n"), ":4:1: error: " + vertex);
  EXPECT_EQ(read(v3 + "v 1 2 3 4 5\nf 1 2 3\n"), ":4:11: error: " + vertex);
  EXPECT_EQ(read(v3 + "v 1 2 3 4 5 6 7\nf 1 2 3\n"), ":4:15: error: " + vertex);
  EXPECT_EQ(read(v3 + "v 1 2 3 0\nf 1 2 3\n"), ":4:9: error: the weight of a vertex must not be 0");
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), ":3:5: error: 'nan' is not a finite number");
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1x 0\nf 1 2 3\n"), ":3:5: error: '1x' is not a finite number");
  EXPECT_EQ(read("v 0 0 +-1\n"), ":1:7: error: '+-1' is not a finite number");
  EXPECT_EQ(read("v 0 0 1e39\n"), ":1:7: error: '1e39' lies outside the range of numbers (3.4e38)");
  EXPECT_EQ(read(v3 + "vn 0 1\nf 1 2 3\n"), ":4:1: error: 3 numbers expected after 'vn'");
  EXPECT_EQ(read(v3 + "vn 0 1 0 0\nf 1 2 3\n"), ":4:10: error: 3 numbers expected after 'vn'");
  EXPECT_EQ(read(v3 + "vt\nf 1 2 3\n"), ":4:1: error: 1 to 3 numbers expected after 'vt'");
  EXPECT_EQ(read(v3 + "f 1 2\n"), ":4:1: error: a polygon needs at least three vertices");
  EXPECT_EQ(read(v3 + "f 1 2 4\n"), ":4:7: error: '4' names no vertex: 1 to 3 or -3 to -1 expected");
  EXPECT_EQ(read(v3 + "f 0 1 2\n"), ":4:3: error: '0' names no vertex: 1 to 3 or -3 to -1 expected");
  EXPECT_EQ(read("f -1 1 2\n" + v3), ":1:3: error: '-1' names no vertex: 1 to 3 expected");
  EXPECT_EQ(read(v3 + "f 99999999999999999999 1 2\n"),
            ":4:3: error: '99999999999999999999' names no vertex: 1 to 3 or -3 to -1 expected");
  EXPECT_EQ(read(v3 + "f 1/1 2/1 3/1\n"), ":4:3: error: '1' names no texture coordinate: the file has none");
  EXPECT_EQ(read(v3 + "vn 0 0 1\nf 1//1 2//-1 3//2\n"),
            ":5:14: error: '2' names no normal: 1 to 1 or -1 to -1 expected");
  for (const std::string corner : {"1/", "1//", "/1", "1/1/1/1", "1.0", "a", "1-", "1/x"}) {
    EXPECT_EQ(read(v3 + "vt 0 0\nvn 0 0 1\nf 1 2 " + corner + "\n"),
              ":6:7: error: '" + corner + "' is no corner: v, v/vt, v//vn or v/vt/vn expected");
  }
  EXPECT_EQ(read(v3 + "vt 0 0\nf 1/1 2/1 3\n"),
            ":5:11: error: '3' is not of the form of the polygon's first corner '1/1'");
  EXPECT_EQ(read(v3 + "vv 1 2 3\nf 1 2 3\n"), ":4:1: error: 'vv' is no keyword of an OBJ file (such as v, vt, vn, f)");
  for (const std::string keyword : {"l", "p"}) {
    EXPECT_EQ(read(v3 + "f 1 2 3\n  " + keyword + " 1 2\n"),
              ":5:3: error: a polygon needs at least three vertices; points or lines are not shown");
  }
  EXPECT_EQ(read(v3 + "f 1 \\\n 2 \\\r\n  5\n"), ":6:3: error: '5' names no vertex: 1 to 3 or -3 to -1 expected");
}

TEST(MeshReader, ObjStatementsWithoutPolygonsAreAccepted) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.obj",
      "# C:\\meshes\\\nmtllib a.mtl\no thing\nv 0 0 0 # 7 8 9\nv +1 0 0\r\nv 0 .5e1 \\\n0\ng a b\ns off\nusemtl red\n"
      "vp 0.5\nlod 1\nparm u 0 1 2\nf -3 -2 -1\ncstype bezier\ndeg 3 3\nend\nusemtl blue\nf 1 4 2 # below\nusemtl red\n"
      "f 1 \\\n  3 \\\n  4\nv 0 0 1\n");
  const scanline::Mesh mesh = scanline::read_mesh_file(path);
  EXPECT_EQ(mesh.polygons, (scanline::PolygonList{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}})) << "in the order of the file";
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, 0, 1}}));
  EXPECT_TRUE(mesh.attributes.empty());
}

TEST(MeshReader, ObjVerticesHaveWeightsOrColours) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj", "v 0 0 0 1\nv 4 0 0 2\nv 0 1 0 1\nf 1 2 3\n");
  EXPECT_EQ(scanline::read_mesh_file(path).positions, (std::vector<glm::dvec3>{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}));
  const auto colored = folder.write("b.obj", "v 0 0 0 1 0 0\nv 4 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  const scanline::Mesh mesh = scanline::read_mesh_file(colored);
  ASSERT_EQ(mesh.attributes.size(), 1u);
  EXPECT_EQ(mesh.attributes[0].values, (std::vector<double>{1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1}));
}

TEST(MeshReader, ObjPolygonsMayDifferInForm) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0.5 0.25\nvn 0 0 1\n"
                                 "f 1 2 3\nf 1/1 2/1 4/1\nf 1//1 3//1 4//1\nf 2/1/1 3/1/1 4/1/1\n");
  const scanline::Mesh mesh = scanline::read_mesh_file(path);
  EXPECT_EQ(mesh.polygons, (scanline::PolygonList{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}));
  ASSERT_EQ(mesh.attributes.size(), 2u);
  ASSERT_EQ(mesh.attributes[1].values.size(), 24u);
  EXPECT_EQ(mesh.attributes[1].values[18], 0.5) << "of the last polygon";
}

TEST(MeshReader, StlMistakesNameLineAndColumn) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return refusal(folder, "a.stl", text); };
  const std::string head = "solid s\nfacet normal 0 0 1\nouter loop\n",
                    v3 = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  const std::string tail = "endloop\nendfacet\n";
  EXPECT_EQ(read(head + v3 + tail + "endsolid s\n"), "");
  EXPECT_EQ(read(head + v3 + tail + "endsolid s\nsolid t\nendsolid\n"), "");
  EXPECT_EQ(read("solid s\nfacet normal nan -nan inf\nouter loop\n" + v3 + tail + "endsolid\n"), "");
  const std::string start =
      "an STL file begins with 'solid', or is binary and as long as its number of triangles wants";
  EXPECT_EQ(read("facet\n"), ":1: error: " + start);
  EXPECT_EQ(read(std::string(84, '\1')), ":1: error: " + start);
  EXPECT_EQ(read("solid\n"), ":1: error: the file ends too early: 'facet' or 'endsolid' expected");
  EXPECT_EQ(read(head + v3 + tail), ":8: error: the file ends too early: 'facet' or 'endsolid' expected");
  EXPECT_EQ(read(head + v3), ":6: error: the file ends too early: 'endloop' expected");
  EXPECT_EQ(read("solid s\nface normal 0 0 1\n"), ":2:1: error: 'facet' or 'endsolid' expected, not 'face'");
  EXPECT_EQ(read("solid s\nfacet\n"), ":2:1: error: 'normal' expected after this");
  EXPECT_EQ(read("solid s\nfacet 0 0 1\n"), ":2:7: error: 'normal' expected, not '0'");
  EXPECT_EQ(read("solid s\nfacet normal 0 1\n"), ":2:7: error: 3 numbers expected after this");
  EXPECT_EQ(read("solid s\nfacet normal 0 0 x\n"), ":2:18: error: 'x' is not a finite number");
  EXPECT_EQ(read("solid s\nfacet normal 0 0 1\nvertex 0 0 0\n"), ":3:1: error: 'outer' expected, not 'vertex'");
  EXPECT_EQ(read(head + "vertex 0 0\n"), ":4:1: error: 3 numbers expected after this");
  EXPECT_EQ(read(head + "vertex 0 0 0 0\n"), ":4:14: error: the end of the line expected, not '0'");
  EXPECT_EQ(read(head + "vertex 0 inf 0\n"), ":4:10: error: 'inf' is not a finite number");
  EXPECT_EQ(read(head + "vertex 0 -1e39 0\n"), ":4:10: error: '-1e39' lies outside the range of numbers (3.4e38)");
  EXPECT_EQ(read(head + "vertex 0 0 0\nvertex 1 0 0\n" + tail), ":6:1: error: 'vertex' expected, not 'endloop'");
  EXPECT_EQ(read(head + v3 + "vertex 1 1 0\n" + tail), ":7:1: error: 'endloop' expected, not 'vertex'");
  EXPECT_EQ(read(head + v3 + tail + "endsolid s\nfacet\n"),
            ":10:1: error: 'solid' or the end of the file expected, not 'facet'");
}

TEST(MeshReader, BinaryStlIsKnownByItsLength) {
  const TemporaryFolder folder;
  std::string text = "solid that is not text";  // as some programs begin a binary file
  text.resize(80);
  text += std::string("\1\0\0\0", 4);
  const float values[12] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0};
  text.append(reinterpret_cast<const char*>(values), sizeof values);
  text.append(2, '\0');
  const scanline::Mesh mesh = scanline::read_mesh_file(folder.write("a.stl", text));
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}));
  EXPECT_NE(refusal(folder, "b.stl", text.substr(0, text.size() - 1)), "");
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
