// Shader texts of any bytes become trees of bounded height and code within pixel memory, or messages that name places.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "pixelflow/compiler/compile.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/language/parser.h"

namespace {

std::uint32_t height(const pfman::ast::Expression& node) {
  std::uint32_t below = 0;
  for (const auto& operand : node.operands) below = std::max(below, height(*operand));
  if (node.height < below + 1) std::abort();
  return below + 1;
}

void check(const pfman::ast::Statement& node) {
  for (const auto& part : node.expressions) {
    if (part && height(*part) > pfman::ast::kMaximumNesting + 1) std::abort();
  }
  for (const auto& inner : node.body) check(*inner);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  pfman::Diagnostics diagnostics;
  const auto compiled = pfman::compile_text(text, "fuzz.pfman", {}, diagnostics);
  for (const auto& diagnostic : diagnostics.all()) {
    if (diagnostic.where.file >= diagnostics.files().size() || diagnostic.text.empty()) std::abort();
  }
  for (const auto& definition : compiled->syntax.definitions) {
    if (definition.body) check(*definition.body);
  }
  if (pfman::dump(compiled->syntax).empty() && !compiled->syntax.definitions.empty()) std::abort();
  if (diagnostics.has_errors()) return 0;
  for (const auto& shader : compiled->shaders) {
    if (shader.map.peak_bytes > pfman::kSharedAt - pfman::kParametersAt) std::abort();
  }
  return 0;
}
