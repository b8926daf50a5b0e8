#include "program/shader_file.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "program/exit_status.h"
#include "program/refuse.h"

namespace program {
namespace {

constexpr char kDefaultLight[] = R"(
light default_light() {
  solar({ 0.35, -0.45, -0.8 }, 0.0) {
    px_light_color = { 1.0, 1.0, 1.0 };
    px_light_ambient = { 0.2, 0.2, 0.2 };
    px_light_specular = { 1.0, 1.0, 1.0 };
  }
}
)";

std::unique_ptr<ShaderFile> finish(std::unique_ptr<ShaderFile> file) {
  const std::string said = file->diagnostics.text();
  if (!said.empty()) std::fputs(said.c_str(), stderr);
  if (file->diagnostics.has_errors()) throw Reported();
  return file;
}

double number(const std::string& word, const std::string& assignment) {
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || error != std::errc() || stop != end || !std::isfinite(value)) {
    refuse("'" + assignment + "': '" + word + "' is no number; NAME=NUMBER,NUMBER... is wanted");
  }
  return value;
}

std::string name_of(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    refuse("'" + assignment + "': NAME=NUMBER,NUMBER... is wanted");
  }
  return assignment.substr(0, equals);
}

}  // namespace

const pfman::CompiledShader& ShaderFile::shader(const std::string& wanted) const {
  if (const pfman::CompiledShader* found = unit->find(wanted)) return *found;
  refuse("there is no shader '" + wanted + "'", name);
}

std::unique_ptr<ShaderFile> read_shader_file(const std::string& file, const pfman::Options& options) {
  auto result = std::make_unique<ShaderFile>();
  result->name = file;
  result->unit = pfman::compile_file(file, options, result->diagnostics);
  return finish(std::move(result));
}

std::unique_ptr<ShaderFile> default_light() {
  auto result = std::make_unique<ShaderFile>();
  result->name = "default_light";
  result->unit = pfman::compile_text(kDefaultLight, result->name, {}, result->diagnostics);
  return finish(std::move(result));
}

void set_value(pfman::Instance& instance, const std::string& assignment) {
  const std::string name = name_of(assignment);
  std::vector<double> values;
  for (std::size_t at = name.size() + 1; at <= assignment.size();) {
    const std::size_t comma = std::min(assignment.find(',', at), assignment.size());
    values.push_back(number(assignment.substr(at, comma - at), assignment));
    at = comma + 1;
  }
  try {
    instance.set(name, values);
  } catch (const std::invalid_argument& mistake) {
    refuse("'" + assignment + "': " + mistake.what());
  }
}

bool has_parameter(const pfman::Instance& instance, const std::string& assignment) {
  const std::string name = name_of(assignment);
  for (const pfman::ShaderParameter& parameter : instance.shader().shader->parameters) {
    if (parameter.variable->name == name) return true;
  }
  return false;
}

std::string line_text(const pfman::Diagnostics& files, std::uint32_t file, std::uint32_t line) {
  if (file >= files.files().size()) return {};
  std::ifstream in(files.files()[file]);
  std::string text;
  for (std::uint32_t n = 0; n < line; ++n) {
    if (!std::getline(in, text)) return {};
  }
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

void refuse_uniform(const pfman::UniformError& error, const pfman::Diagnostics& files) {
  scanline::Diagnostic diagnostic;
  if (error.where.file < files.files().size()) diagnostic.file = files.files()[error.where.file];
  diagnostic.line = static_cast<int>(error.where.line);
  diagnostic.column = static_cast<int>(error.where.column);
  diagnostic.message = error.what();
  throw scanline::UserError(std::move(diagnostic));
}

}  // namespace program
