#include "scanline/spans.h"

#include <algorithm>

namespace scanline {

SpanList::SpanList(const vsg::FrameAnswer& answer)
    : width_(std::max(answer.width - 2, 0)), height_(std::max(answer.height - 1, 0)) {
  // Segments come line by line from the bottom, rows are numbered from the top.
  std::vector<std::size_t> line_begin(static_cast<std::size_t>(height_) + 3, answer.segments.size());
  for (std::size_t i = answer.segments.size(); i-- > 0;) {
    const int y = answer.segments[i].y;
    if (y >= 1 && y <= height_) line_begin[y] = i;
  }
  row_begin_.reserve(static_cast<std::size_t>(height_) + 1);
  for (int row = 0; row < height_; ++row) {
    row_begin_.push_back(spans_.size());
    const int line = height_ - row;
    std::int32_t column = 0;
    for (std::size_t i = line_begin[line]; i < answer.segments.size() && answer.segments[i].y == line; ++i) {
      const vsg::VisibleSegment& s = answer.segments[i];
      const std::int32_t end = std::clamp(s.x_end - kGuardColumns + 1, column, width_);
      if (end > column) spans_.push_back({row, column, end, s.polygon});
      column = end;
    }
    if (column < width_) spans_.push_back({row, column, width_, 0});
  }
  row_begin_.push_back(spans_.size());
}

SpanBand SpanList::band(int first_row, int rows) const {
  const std::size_t begin = row_begin_[first_row], end = row_begin_[first_row + rows];
  return {width_, first_row, rows, std::span(spans_).subspan(begin, end - begin)};
}

}  // namespace scanline
