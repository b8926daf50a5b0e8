#include "tests/pfman_sizes/checked.h"

#include "pixelflow/language/parser.h"

namespace pfman_tests {

std::unique_ptr<Checked> check_body(const std::string& statements, const std::string& parameters) {
  auto checked = std::make_unique<Checked>();
  const std::string text = "surface s(output varying fixed<8,8> px_shader_color[3]" +
                           (parameters.empty() ? "" : "; " + parameters) + ") {\n" + statements +
                           "\npx_shader_color = { 0, 0, 0 };\n}\n";
  checked->unit = pfman::parse_text(text, "s.pfman", {}, checked->diagnostics);
  if (checked->diagnostics.has_errors()) return checked;
  checked->tree = pfman::check(checked->unit, checked->diagnostics);
  if (!checked->diagnostics.has_errors()) pfman::size_fixed(checked->tree, checked->diagnostics);
  return checked;
}

const pfman::Node& last_expression(const Checked& checked) {
  const auto& body = checked.tree.shaders.at(0)->body;
  return *body.at(body.size() - 2)->expression;
}

std::string text(const pfman::Scalar& scalar) {
  if (scalar.is_float) return "float";
  return (scalar.is_signed ? "S(" : "U(") + std::to_string(scalar.size) + "," + std::to_string(scalar.exponent) + ")";
}

}  // namespace pfman_tests
