// Small shaders for tests: text in, raw bits out.
#pragma once

#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "tests/reference/interpreter.h"

namespace reference_tests {

/// Parses; throws std::runtime_error with the diagnostics where there are any.
pfman::ast::Unit parse(const std::string& text);

/// px_shader_color of `surface s` in a text.
reference::SurfaceResult run(const std::string& text, const reference::Input& input);

/// What `body` leaves in a varying variable `result` of `type`, in one lane; functions may stand in `before`.
reference::Raw result_of(const std::string& type, const std::string& body, const std::string& before = "");
float float_result(const std::string& body, const std::string& before = "");
/// The same of `expression` assigned to a variable of the type.
reference::Raw value_of(const std::string& type, const std::string& expression);

}  // namespace reference_tests
