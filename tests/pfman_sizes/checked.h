// Shaders as far as the sized tree.
#pragma once

#include <memory>
#include <string>

#include "pixelflow/compiler/check.h"
#include "pixelflow/compiler/size_fixed.h"
#include "pixelflow/language/ast.h"

namespace pfman_tests {

struct Checked {
  pfman::ast::Unit unit;
  pfman::Tree tree;
  pfman::Diagnostics diagnostics;
};

/// A surface with the statements as its body, checked and sized; names listed in `parameters`, such as
/// "varying fixed<8,0> a = 0", are its parameters.
std::unique_ptr<Checked> check_body(const std::string& statements, const std::string& parameters = "");

/// The expression of the body's last statement but one, an assignment; the last one assigns the colour.
const pfman::Node& last_expression(const Checked& checked);

std::string text(const pfman::Scalar& scalar);  ///< "U(8,8)", "S(36,32)", "float"

}  // namespace pfman_tests
