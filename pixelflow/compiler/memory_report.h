// What is said of shaders that need more than there is.
#pragma once

#include "pixelflow/compiler/ir.h"
#include "pixelflow/compiler/placement.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// E502, and false, where shader ID and parameters exceed a transfer.
bool check_transfer(const ir::Code& code, int parameter_bytes, Diagnostics& diagnostics);

/// E501: `need` bytes are more than `available`. Notes name what is alive where most is needed.
void report_full(const ir::Code& code, const Placement& placement, int need, int available, Diagnostics& diagnostics);

}  // namespace pfman
