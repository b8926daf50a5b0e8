// Uniform expressions on one line, for dumps.
#pragma once

#include <string>

#include "pixelflow/compiler/tree.h"

namespace pfman {

/// "2 * waves", "brick_color[i]"; literals by value, conversions as type(x).
std::string uniform_text(const Node& node);

}  // namespace pfman
