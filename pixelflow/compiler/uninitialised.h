// Variables that may be read before they have a value.
#pragma once

#include "pixelflow/compiler/ir.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// W604, once a variable of the source, at the first place where one is read that some way through the code has not
/// given a value. An element assigned by a run-time index counts as a value for its array. Before to_ssa().
void warn_of_uninitialised(const ir::Code& code, Diagnostics& diagnostics);

}  // namespace pfman
