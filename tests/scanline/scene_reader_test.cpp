// Scene files: what they say arrives, and every mistake is named with its place.
#include <map>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "tests/scanline/checks.h"

namespace scanline_tests {
namespace {

using scanline::Scene;

Scene read(const std::string& text) { return scanline::read_scene(text, "a.toml"); }
std::string mistakes(const std::string& text) {
  return mistake([&] { read(text); });
}

const std::string kObject = "[[object]]\ngeometry = \"shape\"\nshape = \"box\"\n";

TEST(SceneReader, EveryKeyArrives) {
  const Scene s = read(R"(version = 1
size = [640, 480]
background = [0.1, 0.2, 0.3]
[camera]
projection = "orthographic"
position = [1, 2, 3]
target = [4, 5, 6.5]
up = [0, 0, 1]
height = 7
near = -1
far = 9
[[light]]
direction = [1, -1, 0]
color = [1, 0.5, 0.25]
intensity = 2
[[light]]
kind = "point"
position = [1, 2, 3]
[[light]]
kind = "ambient"
intensity = 0.5
[sequence]
first = 2
last = 9
[[object]]
name = "a"
geometry = "shape"
shape = "box"
size = [1, 2, 3]
translate = [1, 1, 1]
rotate = [10, 20, 30]
scale = 2
shader = {name = "wood", parameters = {color = [1, 0, 0.5], rings = 12, name = "oak", old = true}}
[[object]]
geometry = "shape"
shape = "torus"
keys = [{frame = 1}, {frame = 3.5, translate = [1, 2, 3], rotate = [4, 5, 6], scale = [7, 8, 9]}]
)");
  EXPECT_EQ(s.width, 640);
  EXPECT_EQ(s.height, 480);
  EXPECT_EQ(s.background, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(s.camera.projection, scanline::Projection::kOrthographic);
  EXPECT_EQ(s.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(s.camera.target, glm::dvec3(4, 5, 6.5));
  EXPECT_EQ(s.camera.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(s.camera.height, 7);
  EXPECT_EQ(s.camera.near, -1);
  EXPECT_EQ(s.camera.far, 9);
  ASSERT_EQ(s.lights.size(), 3u);
  EXPECT_EQ(s.lights[0].direction, glm::dvec3(1, -1, 0));
  EXPECT_EQ(s.lights[0].color, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(s.lights[0].intensity, 2);
  EXPECT_EQ(s.lights[1].kind, scanline::Light::Kind::kPoint);
  EXPECT_EQ(s.lights[1].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(s.lights[2].kind, scanline::Light::Kind::kAmbient);
  EXPECT_EQ(s.first_frame, 2);
  EXPECT_EQ(s.last_frame, 9);
  ASSERT_EQ(s.objects.size(), 2u);
  const scanline::Object& a = s.objects[0];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.file, "a.toml");
  EXPECT_EQ(a.line, 25);
  EXPECT_EQ(a.mesh.polygons.size(), 6u);
  EXPECT_EQ(a.shader.name, "wood");
  EXPECT_EQ(std::get<double>(a.shader.parameters.at("rings")), 12);
  EXPECT_EQ(std::get<std::string>(a.shader.parameters.at("name")), "oak");
  EXPECT_EQ(std::get<bool>(a.shader.parameters.at("old")), true);
  EXPECT_EQ(std::get<std::vector<double>>(a.shader.parameters.at("color")), (std::vector<double>{1, 0, 0.5}));
  ASSERT_EQ(a.keys.size(), 1u);
  EXPECT_EQ(a.keys[0].translate, glm::dvec3(1));
  EXPECT_EQ(a.keys[0].rotate, glm::dvec3(10, 20, 30));
  EXPECT_EQ(a.keys[0].scale, glm::dvec3(2));
  const scanline::Object& b = s.objects[1];
  EXPECT_EQ(b.name, "object 2");
  EXPECT_EQ(b.shader.name, "flat");
  ASSERT_EQ(b.keys.size(), 2u);
  EXPECT_EQ(b.keys[1].frame, 3.5);
  EXPECT_EQ(b.keys[1].scale, glm::dvec3(7, 8, 9));
}

TEST(SceneReader, EveryShapeIsBuilt) {
  const std::map<std::string, std::size_t> polygons{
      {"shape = \"box\"\ntop = [0.5, 1]", 6},
      {"shape = \"boxes\"\nlist = [{center = [1, 0, 0], size = 2}, {size = [1, 2, 3], top = [0.1, 0.1]}]", 12},
      {"shape = \"plane\"\nsize = [2, 3]\ndivisions = [4, 5]", 20},
      {"shape = \"sphere\"\nradius = 2\nsegments = 8\nrings = 4", 32},
      {"shape = \"cylinder\"\nradius = 2\nheight = 4\nsegments = 8", 10},
      {"shape = \"cone\"\nradius = 2\nheight = 4\nsegments = 8", 9},
      {"shape = \"cone\"\nradius = 2\ntop_radius = 1\nsegments = 8", 10},
      {"shape = \"tube\"\nradius = 2\ninner_radius = 1\nsegments = 8", 32},
      {"shape = \"torus\"\nradius = 2\nthickness = 1\nsegments = 8\nsides = 5", 40},
      {"shape = \"prism\"\noutline = [0, 0, 1, 0, 0, 1]\ndepth = 2", 5},
  };
  for (const auto& [keys, count] : polygons) {
    SCOPED_TRACE(keys);
    const Scene s = read("version = 1\n[[object]]\ngeometry = \"shape\"\n" + keys + "\n");
    EXPECT_EQ(s.objects.at(0).mesh.polygons.size(), count);
  }
}

TEST(SceneReader, MistakesNameFileLineAndColumn) {
  const std::map<std::string, std::string> cases{
      {"", "a.toml:1: error: a scene file begins with 'version = 1'"},
      {"version = 2\n", "a.toml:1:11: error: 'version' of the scene must be 1"},
      {"version = 1\n", "a.toml: error: the scene has no object"},
      {"version = 1\nsizes = [1, 2]\n" + kObject, "a.toml:2:1: error: unknown key 'sizes' in the scene"},
      {"version = 1\nsize = [0, 10]\n" + kObject, "a.toml:2:9: error: 'size' of the scene must be at least 1"},
      {"version = 1\nsize = [10, 9000]\n" + kObject, "a.toml:2:13: error: 'size' of the scene must be at most 8190"},
      {"version = 1\nsize = [8190, 10]\n" + kObject,
       "a.toml:2:8: error: 'size' of the scene must be at most [8189, 8190]"},
      {"version = 1\nsize = [10.5, 10]\n" + kObject,
       "a.toml:2:8: error: 'size' of the scene must be two whole numbers"},
      {"version = 1\nsize = 10\n" + kObject, "a.toml:2:8: error: 'size' of the scene must be an array of 2 numbers"},
      {"version = 1\nbackground = [0, nan, 0]\n" + kObject,
       "a.toml:2:18: error: 'background' of the scene must be a finite number"},
      {"version = 1\nbackground = [0, 2, 0]\n" + kObject,
       "a.toml:2:18: error: 'background' of the scene must be at most 1"},
      {"version = 1\n" + kObject + "size = -1\n", "a.toml:5:8: error: 'size' of object must be greater than 0"},
      {"version = 1\n" + kObject + "size = [1, inf, 1]\n",
       "a.toml:5:12: error: 'size' of object must be a finite number"},
      {"version = 1\n" + kObject + "radius = 1\n", "a.toml:5:1: error: unknown key 'radius' in object"},
      {"version = 1\n" + kObject + "scale = 0\n", "a.toml:5:9: error: 'scale' must not be 0"},
      {"version = 1\n" + kObject + "scale = [1, 0, 1]\n", "a.toml:5:9: error: 'scale' must not be 0"},
      {"version = 1\n" + kObject + "keys = []\n", "a.toml:5:8: error: 'keys' holds no key"},
      {"version = 1\n" + kObject + "keys = [{translate = [1, 2, 3]}]\n",
       "a.toml:5:9: error: key needs the key 'frame'"},
      {"version = 1\n" + kObject + "keys = [{frame = 2}, {frame = 2}]\n",
       "a.toml:5:31: error: keys must stand in the order of their frames, each once"},
      {"version = 1\n" + kObject + "keys = [{frame = 2}]\ntranslate = [1, 2, 3]\n",
       "a.toml:6:1: error: unknown key 'translate' in object"},
      {"version = 1\n" + kObject + "name = \"b\"\n" + kObject + "name = \"b\"\n",
       "a.toml:9:8: error: a second object of the name 'b'"},
      {"version = 1\n" + kObject + "shader = {parameters = {}}\n",
       "a.toml:5:10: error: the shader needs the key 'name'"},
      {"version = 1\n" + kObject + "shader = {name = \"flat\", parameters = {color = [1, \"x\"]}}\n",
       "a.toml:5:48: error: parameter 'color' must be a finite number, a text, true or false, or an array of numbers"},
      {"version = 1\n[[object]]\ngeometry = \"sdf\"\nfunction = \"ball\"\n",
       "a.toml:3:12: error: 'geometry' of object must be one of mesh, shape, patches, terrain, field, not 'sdf'"},
      {"version = 1\n[[object]]\ngeometry = \"shape\"\nshape = \"cube\"\nedge = 3\n",
       "a.toml:4:9: error: 'shape' of object must be one of box, boxes, plane, sphere, cylinder, cone, tube, torus, "
       "prism, not 'cube'"},
      {"version = 1\n[[object]]\nname = \"x\"\n", "a.toml:2:1: error: object needs the key 'geometry'"},
      {"version = 1\n[[object]]\ngeometry = \"mesh\"\n", "a.toml:2:1: error: object needs the key 'file'"},
      {"version = 1\n[[object]]\ngeometry = \"mesh\"\nfile = \"no.obj\"\n",
       "a.toml:4:8: error: cannot read 'no.obj'\nno.obj: error: no such file"},
      {"version = 1\n[[object]]\ngeometry = \"shape\"\nshape = \"sphere\"\nsegments = 2\n",
       "a.toml:5:12: error: 'segments' of object must be a whole number from 3 to 1024"},
      {"version = 1\n[[object]]\ngeometry = \"shape\"\nshape = \"tube\"\nradius = 1\ninner_radius = 2\n",
       "a.toml:6:16: error: 'inner_radius' of a tube must be less than 'radius'"},
      {"version = 1\n[[object]]\ngeometry = \"shape\"\nshape = \"prism\"\noutline = [0, 0, 1, 0, 2, 0]\n",
       "a.toml:5:11: error: 'outline' of a prism encloses no area"},
      {"version = 1\n[[object]]\ngeometry = \"shape\"\nshape = \"cone\"\nradius = 0.0\n",
       "a.toml:5:10: error: 'radius' of object must be greater than 0"},
      {"version = 1\n[camera]\nposition = [1, 1, 1]\ntarget = [1, 1, 1]\n" + kObject,
       "a.toml:2:1: error: the camera's target is its position"},
      {"version = 1\n[camera]\nposition = [0, 5, 0]\n" + kObject,
       "a.toml:2:1: error: the camera's up runs along its line of sight"},
      {"version = 1\n[camera]\nup = [0, 0, 0]\n" + kObject, "a.toml:2:1: error: the camera's up has no length"},
      {"version = 1\n[camera]\nfield_of_view = 180\n" + kObject,
       "a.toml:2:1: error: field_of_view must lie between 0 and 180 degrees"},
      {"version = 1\n[camera]\nnear = 0\n" + kObject, "a.toml:2:1: error: near must be greater than 0"},
      {"version = 1\n[camera]\nnear = 5\nfar = 5\n" + kObject, "a.toml:2:1: error: near must be smaller than far"},
      {"version = 1\n[camera]\nnear = 1e-9\n" + kObject,
       "a.toml:2:1: error: far is more than 1e9 times near: no depth would be left between them"},
      {"version = 1\n[camera]\nprojection = \"orthographic\"\nheight = 0\n" + kObject,
       "a.toml:2:1: error: height must be greater than 0"},
      {"version = 1\n[camera]\nheight = 4\n" + kObject, "a.toml:3:1: error: unknown key 'height' in the camera"},
      {"version = 1\ncamera = 3\n" + kObject, "a.toml:2:10: error: 'camera' of the scene must be a table"},
      {"version = 1\nlight = [1]\n" + kObject, "a.toml:2:10: error: 'light' of the scene must be an array of tables"},
      {"version = 1\n[[light]]\ndirection = [0, 0, 0]\n" + kObject,
       "a.toml:3:13: error: 'direction' of a light has no length"},
      {"version = 1\n[[light]]\nintensity = -1\n" + kObject,
       "a.toml:3:13: error: 'intensity' of light must be at least 0"},
      {"version = 1\n[[light]]\nkind = \"ambient\"\nposition = [1, 2, 3]\n" + kObject,
       "a.toml:4:1: error: unknown key 'position' in light"},
      {"version = 1\n[sequence]\nfirst = 3\nlast = 2\n" + kObject,
       "a.toml:4:8: error: 'last' of the sequence must not be less than 'first'"},
  };
  for (const auto& [text, expected] : cases) {
    SCOPED_TRACE(text);
    EXPECT_EQ(mistakes(text), expected);
  }
}

TEST(SceneReader, MistakesInTomlItselfHaveTheirPlace) {
  EXPECT_TRUE(mistakes("version = 1\nsize = [1, 2\n").starts_with("a.toml:"))
      << mistakes("version = 1\nsize = [1, 2\n");
  EXPECT_TRUE(mistakes("version = 1\nversion = 1\n").starts_with("a.toml:2:"));
  EXPECT_TRUE(mistakes("version = 1\nsize = \xff\n").starts_with("a.toml:2:"));
}

TEST(SceneReader, SeveralMistakesAreToldAtOnce) {
  EXPECT_EQ(mistakes("version = 1\nsise = 3\n[camera]\nfov = 3\n" + kObject + "size = \"big\"\nrotate = [1, 2]\n"),
            "a.toml:4:1: error: unknown key 'fov' in the camera\n"
            "a.toml:9:10: error: 'rotate' of object must be an array of 3 numbers\n"
            "a.toml:8:8: error: 'size' of object must be an array of 3 numbers\n"
            "a.toml:2:1: error: unknown key 'sise' in the scene");
}

TEST(SceneReader, MeshFilesAreFoundBesideTheScene) {
  const TemporaryFolder folder;
  folder.write("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  const std::string head = "version = 1\n[[object]]\ngeometry = \"mesh\"\n";
  EXPECT_EQ(
      scanline::read_scene_file(folder.write("s.toml", head + "file = \"m.off\"\n")).objects[0].mesh.polygons.size(),
      1u);
  const auto bad = folder.write("t.toml", head + "file = \"bad.off\"\n");
  EXPECT_EQ(mistake([&] { scanline::read_scene_file(bad); }), bad.string() + ":4:8: error: cannot read 'bad.off'\n" +
                                                                  (folder.path() / "bad.off").string() +
                                                                  ":6: error: '7' is not a whole number from 0 to 2");
  const std::string missing = (folder.path() / "no.toml").string();
  EXPECT_EQ(mistake([&] { scanline::read_scene_file(missing); }), missing + ": error: no such file");
}

/// Every scene that the project brings is read and makes a frame without a warning, at every moment of its sequence.
TEST(SceneReader, ScenesOfTheProjectAreGood) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder())) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = scanline::read_scene_file(entry.path());
    for (int moment = scene.first_frame; moment <= scene.last_frame; ++moment) {
      const auto f = scanline::make_scene_frame(scene, moment, scene.width, scene.height);
      EXPECT_GT(f.frame.polygons.size(), 10u);
      EXPECT_TRUE(f.warnings.empty()) << format(f.warnings.at(0), "warning");
    }
    ++scenes;
  }
  EXPECT_GE(scenes, 6u);
}

TEST(SceneReader, ChurchHasTheBlocksOfFigure35) {
  const Scene scene = scanline::read_scene_file(scenes_folder() / "church.toml");
  std::size_t polygons = 0, quads = 0;
  for (const auto& object : scene.objects) {
    if (object.name == "ground" || object.name == "sky") continue;
    polygons += object.mesh.polygons.size();
    quads += static_cast<std::size_t>(sizes(object.mesh.polygons)[4]);
  }
  EXPECT_EQ(polygons, 345u * 6);
  EXPECT_EQ(quads, polygons);
  // All of it is in the picture, with the faces of the ground that reach into it, and a polygon of sky.
  const auto frame = scanline::make_scene_frame(scene, 1, scene.width, scene.height);
  EXPECT_EQ(frame.frame.polygons.size(), 345u * 6 + 4 + 1);
}

}  // namespace
}  // namespace scanline_tests
