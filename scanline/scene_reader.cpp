#include <algorithm>
#include <cmath>
#include <set>

#include "scanline/camera.h"
#include "scanline/scene.h"
#include "scanline/scene_frame.h"
#include "scanline/scene_shapes.h"
#include "scanline/text_reader.h"
#include "scanline/toml_table.h"

namespace scanline {
namespace {

constexpr int kSceneVersion = 1;
constexpr int kLastFrame = 1'000'000;
constexpr Range kColor{0, 1, false};

class SceneReader {
 public:
  explicit SceneReader(const std::filesystem::path& path) : folder_(path.parent_path()), mistakes_{path.string(), {}} {}

  Scene read(const std::string& text) {
    toml::table root;
    try {
      root = toml::parse(text, mistakes_.file);
    } catch (const toml::parse_error& e) {
      mistakes_.add(e.source(), std::string(e.description()));
      throw UserError(mistakes_.list);
    }
    TomlTable table(root, "the scene", mistakes_);
    read_version(table);
    if (!mistakes_.list.empty()) throw UserError(mistakes_.list);  // other keys may mean something else then
    read_picture(table);
    if (auto camera = table.table("camera", "the camera")) read_camera(*camera);
    if (auto fields = table.table("fields", "the fields' work")) {
      scene_.fields.shadows = fields->boolean("shadows", false);
      scene_.fields.reflections = fields->boolean("reflections", false);
      fields->finish();
    }
    if (auto sequence = table.table("sequence", "the sequence")) read_sequence(*sequence);
    table.tables("light", "light", [&](TomlTable& light) { read_light(light); });
    if (!table.has("object")) mistakes_.list.push_back({mistakes_.file, 0, 0, "the scene has no object"});
    table.tables("object", "object", [&](TomlTable& object) { read_object(object); });
    table.finish();
    if (!mistakes_.list.empty()) throw UserError(mistakes_.list);
    return std::move(scene_);
  }

 private:
  void read_version(TomlTable& t) {
    if (!t.has("version")) {
      mistakes_.list.push_back({mistakes_.file, 1, 0, "a scene file begins with 'version = 1'"});
      return;
    }
    t.integer("version", kSceneVersion, kSceneVersion, kSceneVersion);
  }

  void read_picture(TomlTable& t) {
    const glm::dvec2 size =
        t.vector<2>("size", {scene_.width, scene_.height}, {1, std::max(kMostPictureWidth, kMostPictureHeight)});
    if (size.x > kMostPictureWidth || size.y > kMostPictureHeight) {
      mistakes_.add(t.where("size"), "'size' of the scene must be at most [" + std::to_string(kMostPictureWidth) +
                                         ", " + std::to_string(kMostPictureHeight) + "]");
    }
    if (size != glm::floor(size)) mistakes_.add(t.where("size"), "'size' of the scene must be two whole numbers");
    scene_.width = static_cast<int>(size.x);
    scene_.height = static_cast<int>(size.y);
    scene_.background = t.vector<3>("background", scene_.background, kColor);
  }

  void read_camera(TomlTable& t) {
    Camera& c = scene_.camera;
    const std::size_t before = mistakes_.list.size();
    const std::size_t projection = t.choice("projection", {"perspective", "orthographic"}, 0);
    c.projection = projection == 0 ? Projection::kPerspective : Projection::kOrthographic;
    c.position = t.vector<3>("position", c.position);
    c.target = t.vector<3>("target", c.target);
    c.up = t.vector<3>("up", c.up);
    // A key of the other projection would be silently without effect: it is unknown here.
    if (c.projection == Projection::kPerspective) c.field_of_view = t.number("field_of_view", c.field_of_view);
    if (c.projection == Projection::kOrthographic) c.height = t.number("height", c.height);
    c.near = t.number("near", c.near);
    c.far = t.number("far", c.far);
    t.tables("keys", "key of the camera", [&](TomlTable& k) { read_camera_key(k); });
    t.finish();
    if (!scene_.camera_keys.empty()) return;
    const std::string fault = camera_fault(c);
    if (!fault.empty() && mistakes_.list.size() == before) mistakes_.add(t.where(), fault);
  }

  /// What a key does not say is as the camera has it.
  void read_camera_key(TomlTable& t) {
    const std::size_t before = mistakes_.list.size();
    CameraKey key{0, scene_.camera};
    Camera& c = key.camera;
    if (!t.has("frame")) t.missing("frame");
    key.frame = t.number("frame", 0, {-kLastFrame, kLastFrame});
    if (!scene_.camera_keys.empty() && key.frame <= scene_.camera_keys.back().frame) {
      mistakes_.add(t.where("frame"), "keys must stand in the order of their frames, each once");
    }
    c.position = t.vector<3>("position", c.position);
    c.target = t.vector<3>("target", c.target);
    c.up = t.vector<3>("up", c.up);
    if (c.projection == Projection::kPerspective) c.field_of_view = t.number("field_of_view", c.field_of_view);
    if (c.projection == Projection::kOrthographic) c.height = t.number("height", c.height);
    const std::string fault = camera_fault(c);
    if (!fault.empty() && mistakes_.list.size() == before) mistakes_.add(t.where(), fault);
    scene_.camera_keys.push_back(key);
  }

  void read_sequence(TomlTable& t) {
    scene_.first_frame = t.integer("first", 1, 0, kLastFrame);
    scene_.last_frame = t.integer("last", scene_.first_frame, 0, kLastFrame);
    if (scene_.last_frame < scene_.first_frame) {
      mistakes_.add(t.where("last"), "'last' of the sequence must not be less than 'first'");
    }
    scene_.frame_rate = t.number("rate", scene_.frame_rate, kPositive);
    t.finish();
  }

  void read_light(TomlTable& t) {
    Light light;
    if (auto shader = t.table("shader", "the light's shader")) {
      // A light of the shading language has its parameters there: other keys are unknown here.
      read_shader(*shader, light.shader.emplace());
      scene_.lights.push_back(light);
      return;
    }
    const std::size_t kind = t.choice("kind", {"directional", "point", "ambient"}, 0);
    light.kind = static_cast<Light::Kind>(kind);
    if (light.kind == Light::Kind::kDirectional) {
      light.direction = t.vector<3>("direction", light.direction);
      if (glm::length(light.direction) == 0)
        mistakes_.add(t.where("direction"), "'direction' of a light has no length");
    }
    if (light.kind == Light::Kind::kPoint) light.position = t.vector<3>("position", light.position);
    light.color = t.vector<3>("color", light.color, kNotNegative);
    light.intensity = t.number("intensity", light.intensity, kNotNegative);
    scene_.lights.push_back(light);
  }

  void read_object(TomlTable& t) {
    Object object;
    object.file = mistakes_.file;
    object.line = static_cast<int>(t.where().begin.line);
    object.name = t.text("name", "object " + std::to_string(scene_.objects.size() + 1));
    if (!names_.insert(object.name).second) {
      mistakes_.add(t.where("name"), "a second object of the name '" + object.name + "'");
    }
    read_keys(t, object);
    if (auto shader = t.table("shader", "the shader")) read_shader(*shader, object.shader);
    Geometry geometry = read_geometry(t, folder_);
    object.mesh = std::move(geometry.mesh);
    object.source = std::move(geometry.source);
    object.field = std::move(geometry.field);
    scene_.objects.push_back(std::move(object));
  }

  TransformKey read_transform(TomlTable& t) {
    TransformKey key;
    key.translate = t.vector<3>("translate", key.translate);
    key.rotate = t.vector<3>("rotate", key.rotate);
    key.scale = t.vector_or_number("scale", key.scale, {-1e6, 1e6});
    if (key.scale.x * key.scale.y * key.scale.z == 0) mistakes_.add(t.where("scale"), "'scale' must not be 0");
    return key;
  }

  void read_keys(TomlTable& t, Object& object) {
    if (!t.has("keys")) {
      object.keys = {read_transform(t)};
      return;
    }
    t.tables("keys", "key", [&](TomlTable& k) {
      TransformKey key = read_transform(k);
      if (!k.has("frame")) k.missing("frame");
      key.frame = k.number("frame", 0, {-kLastFrame, kLastFrame});
      if (!object.keys.empty() && key.frame <= object.keys.back().frame) {
        mistakes_.add(k.where("frame"), "keys must stand in the order of their frames, each once");
      }
      object.keys.push_back(key);
    });
    if (object.keys.empty()) {
      mistakes_.add(t.where("keys"), "'keys' holds no key");
      object.keys.emplace_back();
    }
  }

  void read_shader(TomlTable& t, ShaderCall& shader) {
    if (!t.has("name")) t.missing("name");
    shader.name = t.text("name", shader.name);
    shader.line = static_cast<int>(t.where().begin.line);
    if (t.has("file")) shader.file = folder_ / t.text("file", "");
    if (auto parameters = t.table("parameters", "the shader's parameters")) {
      for (const auto& [key, value] : parameters->all()) read_parameter(shader, std::string(key.str()), value);
    }
    t.finish();
  }

  void read_parameter(ShaderCall& shader, const std::string& name, const toml::node& value) {
    if (value.is_string()) {
      shader.parameters[name] = *value.value<std::string>();
    } else if (value.is_boolean()) {
      shader.parameters[name] = *value.value<bool>();
    } else if (const auto number = finite(value)) {
      shader.parameters[name] = *number;
    } else if (const auto numbers = finite_array(value)) {
      shader.parameters[name] = *numbers;
    } else {
      mistakes_.add(value.source(),
                    "parameter '" + name + "' must be a finite number, a text, true or false, or an array of numbers");
    }
  }

  static std::optional<double> finite(const toml::node& node) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  static std::optional<std::vector<double>> finite_array(const toml::node& node) {
    if (!node.is_array()) return std::nullopt;
    std::vector<double> values;
    for (const toml::node& element : *node.as_array()) {
      const auto value = finite(element);
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    return values;
  }

  std::filesystem::path folder_;
  TomlMistakes mistakes_;
  std::set<std::string> names_;
  Scene scene_;
};

}  // namespace

Scene read_scene(const std::string& text, const std::filesystem::path& path) { return SceneReader(path).read(text); }

Scene read_scene_file(const std::filesystem::path& path) { return read_scene(read_text_file(path), path); }

}  // namespace scanline
