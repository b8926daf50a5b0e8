// OFF is read by hand: the library used for other formats neither names a line nor notices all that can be wrong in
// this one.
#include "scanline/mesh_reader.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

constexpr long kMostElements = 50'000'000;

/// Values run over lines as they please: OFF knows words, not lines. Polygons alone end with their line, since what
/// follows the indices is an optional colour.
class OffReader {
 public:
  OffReader(std::string_view text, const std::string& file) : lines_(text, file), file_(file) {}

  Mesh read() {
    read_header();
    MeshBuilder mesh(colored_ ? std::vector<MeshBuilder::Attribute>{{"color", 4}}
                              : std::vector<MeshBuilder::Attribute>{});
    read_vertices(mesh);
    read_polygons(mesh);
    Mesh result = mesh.take();
    if (result.polygons.empty()) throw UserError({file_, 0, 0, "no polygon with an area in this file"});
    return result;
  }

 private:
  void need_word() {
    while (at_ >= lines_.words().size()) {
      if (!lines_.next()) lines_.fail("the file ends too early");
      at_ = 0;
    }
  }
  double number() {
    need_word();
    return lines_.number(at_++);
  }
  long whole(long low, long high) {
    need_word();
    return lines_.whole(at_++, low, high);
  }

  void read_header() {
    if (!lines_.next()) throw UserError({file_, 1, 0, "an OFF file begins with 'OFF'"});
    if (lines_.words()[0] == "COFF") {
      colored_ = true;
    } else if (lines_.words()[0] != "OFF") {
      lines_.fail("an OFF file begins with 'OFF' or 'COFF', not '" + std::string(lines_.words()[0].substr(0, 40)) +
                  "'");
    }
    at_ = 1;
    vertex_count_ = whole(0, kMostElements);
    polygon_count_ = whole(0, kMostElements);
    whole(0, kMostElements);  // edges: many programs write 0
  }

  void read_vertices(MeshBuilder& mesh) {
    for (long v = 0; v < vertex_count_; ++v) {
      const double x = number(), y = number(), z = number();
      vertices_.push_back(mesh.vertex({x, y, z}));
      if (!colored_) continue;
      for (int k = 0; k < 4; ++k) {
        const bool integer = at_ < lines_.words().size() && lines_.words()[at_].find('.') == std::string_view::npos;
        const double value = number();
        colors_.push_back(integer && value > 1 ? value / 255 : value);
      }
    }
  }

  void read_polygons(MeshBuilder& mesh) {
    std::vector<std::uint32_t> polygon;
    std::vector<double> values;
    for (long p = 0; p < polygon_count_; ++p) {
      polygon.clear();
      values.clear();
      const long corners = whole(0, kMostElements);
      if (corners < 3) lines_.fail("a polygon needs at least three vertices");
      for (long k = 0; k < corners; ++k) {
        const long v = whole(0, vertex_count_ - 1);
        polygon.push_back(vertices_[static_cast<std::size_t>(v)]);
        if (colored_) values.insert(values.end(), colors_.begin() + 4 * v, colors_.begin() + 4 * v + 4);
      }
      mesh.polygon(polygon, values);
      at_ = lines_.words().size();
    }
    if (lines_.next()) lines_.fail("more lines than the header announces");
  }

  TextLines lines_;
  std::string file_;
  std::size_t at_ = 0;
  bool colored_ = false;
  long vertex_count_ = 0, polygon_count_ = 0;
  std::vector<std::uint32_t> vertices_;
  std::vector<double> colors_;
};

}  // namespace

Mesh read_off(std::string_view text, const std::string& file) { return OffReader(text, file).read(); }

}  // namespace scanline
