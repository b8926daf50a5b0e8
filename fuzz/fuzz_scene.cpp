// A scene file of any bytes is refused with a UserError or becomes a frame that a frame file can hold. Files that it
// names are looked for in an empty place.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "scanline/scene.h"
#include "scanline/scene_frame.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const scanline::Scene scene =
        scanline::read_scene(std::string(reinterpret_cast<const char*>(data), size), "/nonexistent/fuzz.toml");
    std::size_t corners = 0;
    for (const auto& object : scene.objects) {
      for (const auto& polygon : object.mesh.polygons) corners += polygon.size();
    }
    if (corners > 100'000) return 0;  // larger ones only take longer
    const scanline::SceneFrame made = scanline::make_scene_frame(scene, scene.first_frame, scene.width, scene.height);
    const scanline::Frame& frame = made.frame;
    if (made.polygons.size() != frame.polygons.size()) std::abort();
    for (const auto& v : frame.vertices) {
      const bool inside = v.x >= 1 && v.x < frame.width && v.y >= 0 && v.y < frame.height && std::abs(v.z) < 65536;
      if (!inside) std::abort();
    }
    for (const auto& polygon : frame.polygons) {
      if (polygon.size() < 3) std::abort();
      for (const std::uint32_t v : polygon) {
        if (v < 1 || v > frame.vertices.size()) std::abort();
      }
    }
  } catch (const scanline::UserError&) {
  }
  return 0;
}
