// OFF and patch files of any bytes are refused with a UserError or become meshes whose indices are in range.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scanline/error.h"
#include "scanline/mesh_reader.h"
#include "scanline/patches.h"

namespace {

void check(const scanline::Mesh& mesh) {
  for (const auto& p : mesh.positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
  }
  for (const auto& polygon : mesh.polygons) {
    if (polygon.size() < 3) std::abort();
    for (const std::uint32_t v : polygon) {
      if (v >= mesh.positions.size()) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    if (text.substr(0, 10) == "vsgpatches") {
      check(scanline::tessellate(scanline::read_patches(text, "fuzz.patches"), 3));
    } else {
      check(scanline::read_off(text, "fuzz.off"));
    }
  } catch (const scanline::UserError&) {
  }
  return 0;
}
