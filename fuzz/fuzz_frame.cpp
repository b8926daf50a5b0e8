// A frame file of any bytes is refused with a UserError or works: through reader, blocks and golden model, and back
// through the writer.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "scanline/frame.h"
#include "scanline/golden_generator.h"

namespace {

constexpr int kLargestFrame = 512;  // larger ones only take longer

bool same(const scanline::Frame& a, const scanline::Frame& b) {
  if (a.width != b.width || a.height != b.height || a.polygons != b.polygons) return false;
  if (a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const auto &v = a.vertices[i], &w = b.vertices[i];
    if (v.x != w.x || v.y != w.y || v.z != w.z) return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    const scanline::Frame frame = scanline::read_frame(in, "fuzz.frame");
    std::stringstream text;
    scanline::write_frame(text, frame);
    if (!same(frame, scanline::read_frame(text, "again.frame"))) std::abort();
    if (frame.width > kLargestFrame || frame.height > kLargestFrame) return 0;
    scanline::GoldenGenerator generator;
    const auto blocks = scanline::make_blocks(frame, generator.parameters(), size % 2 == 0);
    const vsg::FrameAnswer answer = generator.generate(blocks);
    // Every line ends at the right border, and segments do not run back.
    int line = 1, at = 0;
    for (const vsg::VisibleSegment& s : answer.segments) {
      if (s.y != line) {
        if (at != frame.width || s.y != line + 1) std::abort();
        line = s.y;
        at = 0;
      }
      if (s.x_end < at || s.polygon > frame.polygons.size()) std::abort();
      at = s.x_end;
    }
    if (line != frame.height || at != frame.width) std::abort();
  } catch (const scanline::UserError&) {
  } catch (const vsg::FrameError&) {
  }
  return 0;
}
