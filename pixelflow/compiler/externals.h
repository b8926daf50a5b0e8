// Functions of C++ that shaders call (Olano and Lastra 1998, section 3.3): the registry. register_external() is in
// generate.h.
#pragma once

#include <string>

#include "pixelflow/compiler/generate.h"

namespace pfman {

struct PixelExternal {
  PixelFunction function = nullptr;
  int workspace_bytes = 0;
};

/// Null where nothing is registered under the name.
UniformFunction uniform_external(const std::string& name);
PixelExternal pixel_external(const std::string& name);

/// PixelVariable::kind of numbers of the type.
std::uint8_t pixel_kind(const Scalar& scalar);

}  // namespace pfman
