// Files of shaders as the command line names them: compiled, with instances and their values.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pixelflow/compiler/compile.h"
#include "pixelflow/shading/instance.h"

namespace program {

/// A compiled file. Warnings have been printed on standard error.
struct ShaderFile {
  pfman::Diagnostics diagnostics;  ///< with the names of its files
  std::unique_ptr<pfman::CompiledUnit> unit;
  std::string name;

  /// Throws scanline::UserError for a shader that it does not hold.
  const pfman::CompiledShader& shader(const std::string& name) const;
};

/// Prints errors and warnings on standard error, and throws Reported where there are errors.
std::unique_ptr<ShaderFile> read_shader_file(const std::string& file, const pfman::Options& options);

/// The light of a picture for which none is named: white, from the viewer's upper left.
std::unique_ptr<ShaderFile> default_light();

/// "name=0.5,1,2"; throws scanline::UserError for a parameter that the shader does not have, or words that are no
/// numbers.
void set_value(pfman::Instance& instance, const std::string& assignment);
bool has_parameter(const pfman::Instance& instance, const std::string& assignment);

/// What stands in a file's line; nothing for one that cannot be read.
std::string line_text(const pfman::Diagnostics& files, std::uint32_t file, std::uint32_t line);

/// A mistake of uniform code in a shader as a user's mistake at its place.
[[noreturn]] void refuse_uniform(const pfman::UniformError& error, const pfman::Diagnostics& files);

}  // namespace program
