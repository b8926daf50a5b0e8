// The top-down pass over one expression; size_fixed() of check.h runs it over a whole unit.
#pragma once

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Sizes an expression of which every bit is wanted. Once for each tree: conversions are put where the parts of an
/// array or the branches of a Select differ.
void size_root(Node& node, Diagnostics& diagnostics);

}  // namespace pfman
