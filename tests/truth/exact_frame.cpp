#include "tests/truth/exact_frame.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

namespace truth {
namespace {

[[noreturn]] void fail(int line, const std::string& what) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

// Twice the area, positive when the vertices run clockwise with y up.
Number clockwise_area(const ExactFrame& frame, const std::vector<std::uint32_t>& polygon) {
  Number area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& a = frame.vertices[polygon[k]];
    const auto& b = frame.vertices[polygon[(k + 1) % polygon.size()]];
    area += Number(b[0]) * Number(a[1]) - Number(a[0]) * Number(b[1]);
  }
  return area;
}

}  // namespace

ExactFrame read_exact_frame(std::istream& in) {
  ExactFrame frame;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text.substr(0, text.find('#')));
    std::string word;
    if (!(words >> word) || word == "vsgframe") continue;
    if (word == "size") {
      if (!(words >> frame.width >> frame.height)) fail(line, "size wants two numbers");
    } else if (word == "v") {
      std::array<double, 3> v;
      if (!(words >> v[0] >> v[1] >> v[2])) fail(line, "a vertex wants three numbers");
      frame.vertices.push_back(v);
    } else if (word == "p") {
      auto& polygon = frame.polygons.emplace_back();
      for (std::uint32_t i; words >> i;) {
        if (i < 1 || i > frame.vertices.size()) fail(line, "no such vertex");
        polygon.push_back(i - 1);
      }
      if (polygon.size() < 3) fail(line, "a polygon wants three vertices");
    } else {
      fail(line, "unknown word " + word);
    }
  }
  if (frame.width < 1 || frame.height < 1) fail(0, "no size");
  return frame;
}

Number Cut::depth_at(int pixel) const { return left_z + (right_z - left_z) * (pixel - left) / (right - left); }

Cutter::Cutter(const ExactFrame& frame, bool keep_back_faces) : frame_(frame) {
  for (std::size_t p = 0; p < frame.polygons.size(); ++p) {
    if (!keep_back_faces && clockwise_area(frame, frame.polygons[p]) <= 0) continue;
    Shown shown{static_cast<std::uint32_t>(p), frame.height, 0};
    for (const std::uint32_t v : frame.polygons[p]) {
      shown.first_line = std::min(shown.first_line, static_cast<int>(frame.vertices[v][1]) + 1);
      shown.last_line = std::max(shown.last_line, static_cast<int>(frame.vertices[v][1]));
    }
    if (shown.first_line <= shown.last_line) shown_.push_back(shown);
  }
}

std::vector<Cut> Cutter::cuts(int line) const {
  struct Crossing {
    Number x, z, slope;
  };
  std::vector<Cut> cuts;
  std::vector<Crossing> crossings;
  for (const Shown& shown : shown_) {
    if (line < shown.first_line || line > shown.last_line) continue;
    const auto& polygon = frame_.polygons[shown.polygon];
    crossings.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto* low = &frame_.vertices[polygon[k]];
      const auto* high = &frame_.vertices[polygon[(k + 1) % polygon.size()]];
      if ((*low)[1] > (*high)[1]) std::swap(low, high);
      if (line <= static_cast<int>((*low)[1]) || line > static_cast<int>((*high)[1])) continue;
      const Number height = Number((*high)[1]) - Number((*low)[1]);
      const Number way = (line - Number((*low)[1])) / height;
      const Number across = Number((*high)[0]) - Number((*low)[0]);
      const Number deeper = Number((*high)[2]) - Number((*low)[2]);
      crossings.push_back({Number((*low)[0]) + across * way, Number((*low)[2]) + deeper * way, across / height});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x != b.x ? a.x < b.x : a.slope < b.slope; });
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const Crossing &a = crossings[k], &b = crossings[k + 1];
      if (a.x < b.x) cuts.push_back({shown.polygon + 1, a.x, a.z, b.x, b.z});
    }
  }
  return cuts;
}

}  // namespace truth
