// The constant expressions of #if and #elif.
#pragma once

#include "pixelflow/language/macros.h"

namespace pfman {

/// Value of the expression: C's operators on 64-bit two's complement, wrapping; names that are no macros count 0,
/// `true` counts 1. A mistake is E100 and the value 0.
bool evaluate_condition(const std::vector<Token>& line, Location directive, MacroTable& table);

}  // namespace pfman
