// Pixel memory, byte by byte (Olano and Lastra 1998, section 6.3.3): every variable and every operation's workspace
// gets its place while it lives.
#pragma once

#include "pixelflow/compiler/ir.h"
#include "pixelflow/compiler/lifetime.h"

namespace pfman {

struct MemoryMap {
  std::vector<int> address;  ///< by ir variable; -1 for one that is never alive
  int parameter_bytes = 0;   ///< received: shader ID and varying parameters of the transfer map
  /// Surface: first byte above everything in use at any time, what is received included. Light: the lowest byte in use;
  /// lights grow from kSharedAt down.
  int first_free = 0;
  int high_water = 0;  ///< surface: first byte that lights may use
  /// Surface with a shared lookup: first byte that others may use between what stands before it and what follows.
  int lookup_water = 0;
  int peak_bytes = 0;  ///< bytes occupied at the same time, at most: workspaces, mask bytes and live parameters
                       ///< included, shader ID and shared area not
  int peak_at = 0;     ///< instruction of the peak

  // What table 4 compares. Its numbers for the simple brick, 97 bytes varying and 16 as allocated, leave no room for
  // the normal and the texture coordinates of 20 bytes, so that parameters are in neither: both columns are what a
  // shader needs on top of its parameters. Workspaces of operations are not variables.
  int uniform_bytes = 0;    ///< uniform parameters and uniform variables of the source, on the host
  int varying_bytes = 0;    ///< varying variables of the source and temporaries, if each had its own place: ir::Code's
                            ///< source_bytes and temporary_bytes
  int allocated_bytes = 0;  ///< bytes outside of the parameters' own that ever hold one of these variables
};

struct AllocateOptions {
  bool share = true;  ///< off: every variable has bytes of its own
};

/// Fills the instructions' workspace addresses. E501 if kMemoryBytes do not suffice, with the variables alive at the
/// peak, their lines and sizes, and what fixed-point versions of the float ones would save; E502 if the parameters
/// exceed the packets of a transfer.
MemoryMap allocate(ir::Code& code, const AllocateOptions& options, Diagnostics& diagnostics);

/// For --dump=memory-map: byte ranges, what lies there, from which line to which.
std::string dump(const MemoryMap& map, const ir::Code& code);

}  // namespace pfman
