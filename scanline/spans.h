// Visible segments become spans of a picture: the one place that knows how a picture lies in its frame.
//
// A picture of w x h pixels is made from a frame of (w + 2) x (h + 1). Column i and row j of the picture (from the left
// and from the top, both from 0) are the frame's column i + 2 on scan line h - j.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cmodel/vsg/answer.h"

namespace scanline {

constexpr int kGuardColumns = 2;  ///< frame column of picture column 0

/// Pixels [begin, end) of a row that show one polygon; 0 is background.
struct Span {
  std::int32_t row = 0;
  std::int32_t begin = 0, end = 0;
  std::uint32_t polygon = 0;
  bool operator==(const Span&) const = default;
};

/// Rows [first_row, first_row + rows) of a picture: a piece of work for a shader stage.
struct SpanBand {
  int width = 0;
  int first_row = 0, rows = 0;
  std::span<const Span> spans;  ///< row by row, from left to right; they cover every pixel
};

/// All spans of a picture.
class SpanList {
 public:
  /// `answer` is that of the picture's frame.
  explicit SpanList(const vsg::FrameAnswer& answer);

  int width() const { return width_; }
  int height() const { return height_; }
  std::span<const Span> spans() const { return spans_; }
  SpanBand band(int first_row, int rows) const;

 private:
  int width_, height_;
  std::vector<Span> spans_;
  std::vector<std::size_t> row_begin_;  // height + 1 entries
};

}  // namespace scanline
