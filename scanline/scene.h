// A scene as its file tells it (TOML, docs/formats.md): camera, objects, lights, background, size. Units are the
// scene's own, right-handed, y up; angles in degrees; colours linear 0 to 1 unless a shader says otherwise.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "scanline/error.h"
#include "scanline/mesh.h"

namespace scanline {

/// A parameter of a shader, as written: the shader knows what it wants.
using ParameterValue = std::variant<double, std::string, bool, std::vector<double>>;

/// `shader = {name = "flat", parameters = {...}}` of an object.
struct ShaderCall {
  std::string name = "flat";
  std::map<std::string, ParameterValue> parameters;
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

/// A light: `direction` points from the light into the scene (directional), or `position` (point).
struct Light {
  enum class Kind { kDirectional, kPoint, kAmbient } kind = Kind::kDirectional;
  glm::dvec3 direction{0, -1, 0}, position{0};
  glm::dvec3 color{1};
  double intensity = 1;
};

struct Object {
  std::string name;
  Mesh mesh;
  ShaderCall shader;
  std::vector<TransformKey> keys;  ///< at least one, in order of `frame`
  std::string file;                ///< where the object stands, for messages
  int line = 0;
};

struct Scene {
  int width = 512, height = 512;  ///< pixels of the picture
  Camera camera;
  std::vector<Object> objects;
  std::vector<Light> lights;
  glm::dvec3 background{0};
  int first_frame = 1, last_frame = 1;  ///< of the sequence that the keys describe
};

/// Reads a scene file and the meshes that it names (paths relative to it). Throws UserError with every mistake found.
Scene read_scene_file(const std::filesystem::path& path);

/// The same from text; `path` is used in messages and to find meshes.
Scene read_scene(const std::string& text, const std::filesystem::path& path);

}  // namespace scanline
