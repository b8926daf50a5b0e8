// A mistake on the command line, for which there is no file and line.
#pragma once

#include <string>

#include "scanline/error.h"

namespace program {

[[noreturn]] inline void refuse(std::string message, std::string file = {}) {
  throw scanline::UserError(scanline::Diagnostic{std::move(file), 0, 0, std::move(message)});
}

}  // namespace program
