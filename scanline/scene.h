// A scene as its file tells it (TOML, docs/formats.md): camera, objects, lights, background, size. Units are the
// scene's own, right-handed, y up; angles in degrees; colours linear 0 to 1 unless a shader says otherwise.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scanline/error.h"
#include "scanline/field.h"
#include "scanline/mesh.h"
#include "scanline/mesh_source.h"

namespace scanline {

/// A parameter of a shader, as written: the shader knows what it wants.
using ParameterValue = std::variant<double, std::string, bool, std::vector<double>>;

/// `shader = {name = "flat", file = "my.pfman", parameters = {...}}` of an object or a light: a shading function with
/// its bound parameters. A text as the value of a whole number names an image, relative to the scene file.
struct ShaderCall {
  std::string name = "flat";
  std::filesystem::path file;  ///< where the function stands; empty: one of the program's own
  std::map<std::string, ParameterValue> parameters;
  int line = 0;  ///< of the scene file, for messages
};

enum class Projection { kPerspective, kOrthographic };

/// Values at one moment of a sequence; between keys they are interpolated.
struct TransformKey {
  double frame = 0;
  glm::dvec3 translate{0}, rotate{0}, scale{1};  ///< rotate: degrees about x, then y, then z
};

struct Camera {
  Projection projection = Projection::kPerspective;
  glm::dvec3 position{0, 0, 5}, target{0}, up{0, 1, 0};
  double field_of_view = 45;  ///< vertical, degrees; perspective
  double height = 2;          ///< of the picture in scene units; orthographic
  double near = 0.1, far = 100;
};

/// The camera at one moment of a sequence; between keys position, target, up and field of view (or height) are
/// interpolated linearly.
struct CameraKey {
  double frame = 0;
  Camera camera;
};

/// A light: `direction` points from the light into the scene (directional), or `position` (point). One with a `shader`
/// is a light of the shading language instead; its parameters are in world space.
struct Light {
  enum class Kind { kDirectional, kPoint, kAmbient } kind = Kind::kDirectional;
  glm::dvec3 direction{0, -1, 0}, position{0};
  glm::dvec3 color{1};
  double intensity = 1;
  std::optional<ShaderCall> shader;
};

/// What the host does with distance fields beyond finding their visible surface: asked for by the scene, and paid for
/// only where a pixel's shader has the parameter that takes the result.
struct FieldWork {
  bool shadows = false;      ///< parameter field_visibility
  bool reflections = false;  ///< parameter field_reflection
};

/// An object's polygons are `mesh`, or those that `source` makes for a viewer. One with a `field` has them to be found
/// by; what pixels show is the field's own surface.
struct Object {
  std::string name;
  Mesh mesh;
  std::shared_ptr<const MeshSource> source;
  std::shared_ptr<const Field> field;
  ShaderCall shader;
  std::vector<TransformKey> keys;  ///< at least one, in order of `frame`
  std::string file;                ///< where the object stands, for messages
  int line = 0;
};

struct Scene {
  int width = 512, height = 512;  ///< pixels of the picture
  Camera camera;
  std::vector<CameraKey> camera_keys;  ///< in order of `frame`; empty: the camera stands still
  std::vector<Object> objects;
  std::vector<Light> lights;
  FieldWork fields;
  std::map<int, std::filesystem::path> textures;  ///< images that parameters name by number instead of by file
  glm::dvec3 background{0};
  int first_frame = 1, last_frame = 1;  ///< of the sequence that the keys describe
  double frame_rate = 30;               ///< frames a second of the sequence: px_shader_time is frame / frame_rate
};

/// Reads a scene file and the meshes that it names (paths relative to it). Throws UserError with every mistake found.
Scene read_scene_file(const std::filesystem::path& path);

/// The same from text; `path` is used in messages and to find meshes.
Scene read_scene(const std::string& text, const std::filesystem::path& path);

}  // namespace scanline
