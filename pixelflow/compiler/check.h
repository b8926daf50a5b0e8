// Names, types, rates, constants, statements in their places: from the syntax tree to the typed tree.
#pragma once

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/ast.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Errors E110 to E206 and E301 to E407, warnings W601, W602, W603, W605 and W606. The tree is whole only when
/// diagnostics.has_errors() is false.
Tree check(const ast::Unit& unit, Diagnostics& diagnostics);

}  // namespace pfman
