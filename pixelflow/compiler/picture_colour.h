// The end of a surface: its colour in the type that pictures have.
#pragma once

#include "pixelflow/compiler/allocate.h"
#include "pixelflow/compiler/stream_writer.h"

namespace pfman {

/// Writes px_shader_color to kColorAt as U(8,8)[3]: floored and saturated. Everything else in the shader's memory, and
/// what lights have left, is no longer needed there and may be written over.
void write_picture_colour(StreamWriter& out, const ir::Code& code, const MemoryMap& map);

}  // namespace pfman
