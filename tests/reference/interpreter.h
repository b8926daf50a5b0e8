// The reference interpreter of the shading language: what a shader's pixels must hold, bit for bit. It shares nothing
// with the compiler but the parser, and takes mathematical functions and noise, whose last bit is the processors' own,
// from the golden library. Programs are taken to be valid; Error says where one is not, or what it does at run time
// that it may not.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "tests/reference/number.h"
#include "tests/reference/textures.h"

namespace reference {

/// Raw bits in a parameter's type, element after element; of a varying one every element has all its lanes.
using RawValues = std::vector<Raw>;
using ParameterValues = std::map<std::string, RawValues>;

struct LightInput {
  std::string shader;
  ParameterValues uniform;
};

/// Parameters that are not given have their default, px_ parameters zero (px_shader_time and px_shader_frame as below,
/// position and view as `position` makes them). A varying parameter may be given one lane, which then stands for all.
struct Input {
  int lanes = 1;
  ParameterValues uniform, varying;
  RawValues position;  ///< float bits, 3 times the lanes; in eye space. Empty: the origin
  float time = 0;
  std::int64_t frame = 0;
  std::vector<LightInput> lights;
  const Textures* textures = nullptr;
};

struct SurfaceResult {
  Number number;                    ///< of px_shader_color as declared
  RawValues raw;                    ///< px_shader_color, 3 times the lanes
  std::vector<std::uint8_t> color;  ///< U(8,8), saturated; 3 times the lanes
};

/// The communication area: S(16,14) and U(16,12), each 3 times the lanes.
struct LightResult {
  RawValues direction, color, ambient, specular;
};

struct ParameterInfo {
  std::string name;
  Number number;
  int elements = 1;
  bool uniform = true;
  bool output = false;
};

class Interpreter {
 public:
  explicit Interpreter(const pfman::ast::Unit& unit) : unit_(&unit) {}

  SurfaceResult surface(const std::string& name, const Input& input) const;
  LightResult light(const std::string& name, const ParameterValues& uniform, const Input& input) const;
  /// Resolves what no shader uses, too: Error where something is wrong.
  void resolve_all() const;
  std::vector<ParameterInfo> parameters(const std::string& shader) const;

 private:
  const pfman::ast::Unit* unit_;
};

}  // namespace reference
