// Shader instances: a shading function and its bound parameters (Olano and Lastra 1998, sections 4.3, 6.1.6 and 6.2).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/compiler/generate.h"

namespace pfman {

/// One entry of a transfer map: a varying parameter as it travels from the rendering to the shading node and lies in
/// pixel memory.
struct TransferEntry {
  std::string name;
  Type type;
  int address = 0;
};

/// The varying parameters that a shader's pixels carry, in the order of declaration behind the shader ID. Parameters
/// that are rebuilt (px_shader_position, px_shader_view) do not travel; bound ones are loaded on the shading node.
struct TransferMap {
  std::vector<TransferEntry> entries;
  int bytes = 0;    ///< shader ID included
  int packets = 0;  ///< of the composition network, each with its depth
};
TransferMap transfer_map(const CompiledShader& shader);

/// Each number of a standard material parameter in OpenGL's first state, where nothing says otherwise; none for other
/// parameters.
std::optional<double> opengl_material(const std::string& parameter);

/// A surface or a light with the values of its parameters.
class Instance {
 public:
  explicit Instance(const CompiledShader& shader, int id = 0);

  const CompiledShader& shader() const { return *shader_; }
  int id() const { return id_; }

  /// Sets a uniform or a bound varying parameter. Throws std::invalid_argument, saying what is wrong, for an unknown
  /// name or a wrong number of values.
  void set(const std::string& parameter, const std::vector<double>& values);
  void set_raw(const std::string& parameter, const Raw& raw);
  /// A varying parameter is bound unless this says that it comes with the pixels, or it is a standard one without a
  /// value.
  void make_ordinary(const std::string& parameter);
  bool is_ordinary(const std::string& parameter) const;

  const std::map<std::string, Raw>& uniforms() const { return uniforms_; }
  const std::map<std::string, Raw>& bound() const { return bound_; }

 private:
  const CompiledShader* shader_;
  int id_;
  std::map<std::string, Raw> uniforms_;
  std::map<std::string, Raw> bound_;
  std::vector<std::string> ordinary_;
};

}  // namespace pfman
