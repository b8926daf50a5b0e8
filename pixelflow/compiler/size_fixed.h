// The top-down pass over fixed-point expressions (Olano and Lastra 1998, section 6.3.2).
#pragma once

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// The top-down pass over all fixed-point expressions of a unit; the rules are in docs/pfman.md. check() has set
/// every node's `exact` bottom-up type; this one sets `type` and `under`. Error E210.
void size_fixed(Tree& tree, Diagnostics& diagnostics);

/// Sizes an expression of which every bit is wanted. Once for each tree: conversions are put where the parts of an
/// array or the branches of a Select differ.
void size_root(Node& node, Diagnostics& diagnostics);

}  // namespace pfman
