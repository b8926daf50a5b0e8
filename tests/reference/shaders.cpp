#include "tests/reference/shaders.h"

#include <stdexcept>

#include "pixelflow/language/parser.h"

namespace reference_tests {

pfman::ast::Unit parse(const std::string& text) {
  pfman::Diagnostics diagnostics;
  pfman::ast::Unit unit = pfman::parse_text(text, "test.pfman", {}, diagnostics);
  if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.text());
  return unit;
}

reference::SurfaceResult run(const std::string& text, const reference::Input& input) {
  const pfman::ast::Unit unit = parse(text);
  return reference::Interpreter(unit).surface("s", input);
}

reference::Raw result_of(const std::string& type, const std::string& body, const std::string& before) {
  const std::string text = before + "surface s(output varying " + type + " px_shader_color[3]) { " + type +
                           " result; " + body + " px_shader_color[0] = result; }";
  return run(text, {}).raw[0];
}

float float_result(const std::string& body, const std::string& before) {
  return reference::as_float(result_of("float", body, before));
}

reference::Raw value_of(const std::string& type, const std::string& expression) {
  return result_of(type, "result = " + expression + ";");
}

}  // namespace reference_tests
