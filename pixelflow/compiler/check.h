// Names, types, rates, constants, statements in their places: from the syntax tree to the typed tree.
#pragma once

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/ast.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Errors E110 to E206 and E301 to E407, warnings W601, W602, W603, W605 and W606. The tree is whole only when
/// diagnostics.has_errors() is false.
Tree check(const ast::Unit& unit, Diagnostics& diagnostics);

/// The top-down pass over all fixed-point expressions (section 6.3.2; the rules are in docs/pfman.md). check() has set
/// every node's `exact` bottom-up type; this one sets `type` and `under`. Error E210.
void size_fixed(Tree& tree, Diagnostics& diagnostics);

}  // namespace pfman
