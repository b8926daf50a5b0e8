// The pfman compiler: a file of shaders to code with memory maps.
//
// text -> parse -> check -> size_fixed -> for each shader: lower -> to_ssa -> merge_phis -> drop_unused -> join_copies
// -> allocate; generate() then makes streams of it for given uniform values.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pixelflow/compiler/allocate.h"
#include "pixelflow/compiler/ir.h"
#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/parser.h"

namespace pfman {

/// Optimisations, each of which leaves every bit of the result as it is.
struct Options {
  bool fuse = true;  ///< see LowerOptions
  bool drop_unused = true;
  bool join_copies = true;
  bool share_memory = true;  ///< lifetimes decide about memory; off: every variable keeps its own bytes
  ParseOptions parse;
};

struct CompiledShader {
  ir::Code code;
  MemoryMap map;
  const Shader* shader = nullptr;  ///< in the unit's tree
  const Tree* tree = nullptr;      ///< the unit's
};

/// The passes behind lower(), from straight code to memory.
void run_passes(CompiledShader& compiled, const Options& options, Diagnostics& diagnostics);

struct CompiledUnit {
  ast::Unit syntax;
  Tree tree;
  std::vector<CompiledShader> shaders;  ///< in the order of the text

  const CompiledShader* find(const std::string& name) const;
};

/// Never null; what it holds is whole only when diagnostics.has_errors() is false.
std::unique_ptr<CompiledUnit> compile_file(const std::filesystem::path& file, const Options& options,
                                           Diagnostics& diagnostics);
std::unique_ptr<CompiledUnit> compile_text(const std::string& text, const std::string& name, const Options& options,
                                           Diagnostics& diagnostics);

}  // namespace pfman
