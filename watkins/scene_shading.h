// The shaders of a scene: compiled, as instances with their bound parameters, and where their varying parameters come
// from (Olano and Lastra 1998, sections 4.3, 4.4 and 6.2).
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pixelflow/compiler/compile.h"
#include "pixelflow/shading/instance.h"
#include "pixelflow/shading/texture_memory.h"
#include "scanline/scene.h"

namespace watkins {

/// Where a varying parameter that travels comes from.
struct ParameterSource {
  enum class Kind {
    Normal,         ///< px_material_normal: the attribute "normal", or the field's, or the polygon's own
    PolygonNormal,  ///< polygon_normal
    TexCoord,       ///< px_shader_texcoord[2]: the attribute "uv", or the object's coordinates along a face
    Volume,         ///< px_shader_texcoord[3 or 4] without an attribute: the object's own coordinates, and 1
    Visibility,     ///< field_visibility
    Reflection,     ///< field_reflection
    Attribute       ///< of the parameter's name
  };
  Kind kind = Kind::Attribute;
  std::string name;  ///< of the attribute
  int offset = 0;    ///< in the element's memory, from kShaderIdAt on
  pfman::Type type;
  pfman::ast::Transform transform = pfman::ast::Transform::None;

  friend bool operator==(const ParameterSource&, const ParameterSource&) = default;
};

/// Whether the corners of an object's polygons carry so many numbers, or more, under this name.
bool has_attribute(const scanline::Object& object, const std::string& name, int components);

/// What the pixels of an object send.
struct ObjectSurface {
  int shader_id = 0;
  int packets = 1;  ///< that the parameters fill, the last that travels included
  int map_bytes = 0;
  std::vector<ParameterSource> sources;
};

/// What stays when a scene's instances are made anew: compiled files, and images that have been read.
struct ShadingFiles {
  ShadingFiles();

  struct Unit {
    std::filesystem::path path;
    std::unique_ptr<pfman::CompiledUnit> unit;
  };
  pfman::Diagnostics diagnostics;  ///< one for all files: a file's number names it among them all
  std::vector<std::unique_ptr<Unit>> units;
  std::map<int, std::filesystem::path> images;  ///< by number, in `textures`
  pfman::TextureMemory textures;
};

/// Instances are the same for all moments, but for the values that depend on the moment.
class SceneShading {
 public:
  /// Throws UserError with every mistake found; `files` are then of no use any more. Scene and files must outlive it.
  SceneShading(const scanline::Scene& scene, const std::string& scene_file, ShadingFiles& files);

  /// Of objects, by their index in the scene.
  const ObjectSurface& object(std::size_t index) const { return objects_[index]; }
  const pfman::TextureMemory& textures() const { return files_.textures; }
  const std::string& warnings() const { return warnings_; }

  /// Instances with their values at a moment, parameters with transform attributes in eye space.
  std::vector<pfman::Instance> surfaces(double moment) const;
  std::vector<pfman::Instance> lights(double moment) const;

  /// The place in a shader's text that stopped its uniform code, as a user's mistake.
  scanline::UserError mistake(const pfman::UniformError& error) const;

 private:
  struct Made {
    pfman::Instance instance;
    std::size_t object = 0;  ///< whose space its parameters are in
  };
  const pfman::CompiledShader* find(const scanline::ShaderCall& call, pfman::Shader::Kind kind);
  void add_object(std::size_t index);
  void add_light(const scanline::Light& light);
  void bind(pfman::Instance& instance, const scanline::ShaderCall& call);
  void keep_textures();
  void read_texture(int number, const std::filesystem::path& path, int line);
  int texture(const std::string& name, int line);
  bool add_source(const scanline::Object& object, const pfman::TransferEntry& entry, pfman::Instance& instance,
                  ObjectSurface& surface);
  void set_standard(pfman::Instance& instance, double moment) const;
  void wrong(int line, std::string message);

  const scanline::Scene& scene_;
  std::string scene_file_;
  ShadingFiles& files_;
  std::vector<Made> surfaces_;
  std::vector<pfman::Instance> lights_;
  std::vector<ObjectSurface> objects_;
  std::map<std::string, int> images_;
  int first_image_;  ///< number of the first of images_
  std::string warnings_;
  std::vector<scanline::Diagnostic> mistakes_;
};

}  // namespace watkins
