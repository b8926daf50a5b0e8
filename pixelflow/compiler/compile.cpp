#include "pixelflow/compiler/compile.h"

#include "pixelflow/compiler/check.h"
#include "pixelflow/compiler/lifetime.h"
#include "pixelflow/compiler/lower.h"
#include "pixelflow/compiler/shared_phong.h"
#include "pixelflow/compiler/size_fixed.h"

namespace pfman {
namespace {

CompiledShader compile_shader(const Tree& tree, const Shader& shader, const Options& options,
                              Diagnostics& diagnostics) {
  CompiledShader compiled;
  compiled.shader = &shader;
  compiled.tree = &tree;
  compiled.code = lower(tree, shader, {.fuse = options.fuse}, diagnostics);
  if (diagnostics.has_errors()) return compiled;
  mark_shared_phong(compiled.code, shader);
  run_passes(compiled, options, diagnostics);
  return compiled;
}

std::unique_ptr<CompiledUnit> compile(ast::Unit syntax, const Options& options, Diagnostics& diagnostics) {
  auto unit = std::make_unique<CompiledUnit>();
  unit->syntax = std::move(syntax);
  if (diagnostics.has_errors()) return unit;
  unit->tree = check(unit->syntax, diagnostics);
  if (diagnostics.has_errors()) return unit;
  size_fixed(unit->tree, diagnostics);
  if (diagnostics.has_errors()) return unit;
  for (const auto& shader : unit->tree.shaders) {
    unit->shaders.push_back(compile_shader(unit->tree, *shader, options, diagnostics));
  }
  return unit;
}

}  // namespace

void run_passes(CompiledShader& compiled, const Options& options, Diagnostics& diagnostics) {
  to_ssa(compiled.code, diagnostics);
  merge_phis(compiled.code);
  if (options.drop_unused) drop_unused(compiled.code);
  if (options.join_copies) join_copies(compiled.code);
  compiled.map = allocate(compiled.code, {.share = options.share_memory}, diagnostics);
}

const CompiledShader* CompiledUnit::find(const std::string& name) const {
  for (const CompiledShader& shader : shaders) {
    if (shader.shader->name == name) return &shader;
  }
  return nullptr;
}

std::unique_ptr<CompiledUnit> compile_file(const std::filesystem::path& file, const Options& options,
                                           Diagnostics& diagnostics) {
  return compile(parse_file(file, options.parse, diagnostics), options, diagnostics);
}

std::unique_ptr<CompiledUnit> compile_text(const std::string& text, const std::string& name, const Options& options,
                                           Diagnostics& diagnostics) {
  return compile(parse_text(text, name, options.parse, diagnostics), options, diagnostics);
}

}  // namespace pfman
