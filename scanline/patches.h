// Bicubic Bezier patches, and their tessellation into polygons.
//
// Patch file (.patches), text, `#` starts a comment:
//   vsgpatches 1
//   v X Y Z             one control point, numbered from 1 in order
//   b i1 i2 ... i16     one patch: four rows of four control points; seen from the front, rows run upwards when the
//                       points of a row run to the right
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scanline/mesh.h"

namespace scanline {

struct PatchSet {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 16>> patches;  ///< indices from 0, row by row
};

/// Throws UserError with file and line.
PatchSet read_patches(std::string_view text, const std::string& file);

/// Cuts every patch into `level` x `level` quads, triangles where a side has shrunk to a point and two of them where
/// the quad is not planar. Patches with a common border get the same vertices there to the bit. Corners carry
/// "normal" (the surface's own) and "uv" (within the patch).
Mesh tessellate(const PatchSet& set, int level);

}  // namespace scanline
