// Sample list: the edges that were visible on the line before, in X, as sample points of this line; and the list that this
// line leaves for the next. Its words, two a segment block, live in a memory of their own. rtl/vsg/sample_list.sv
#pragma once

#include <vector>

#include "cmodel/vsg/wiring.h"

namespace vsg {

/// The sample word of an edge: the block and its left (0) or right (1) half. Block 0 is none.
struct SampleAddress {
  SegmentPointer block = 0;
  int side = 0;
  bool operator==(const SampleAddress&) const = default;
};

/// An edge that may become a sample point: its pixel on the next line, 0 when there is none.
struct SamplePoint {
  std::int64_t pixel = 0;
  SampleAddress address;
  std::uint32_t edge = 0;  ///< with frame coherence, the edge block; 0 for an implied edge
};

class SampleList {
 public:
  SampleList(Wiring& wiring, std::uint32_t blocks) : w_(wiring), words_(2 * (blocks + 1)), next_pixel_(wiring.width) {}

  void start_line();

  /// The first sample point at or right of `pixel`, the frame's width when there is none.
  std::int64_t read(std::int64_t pixel);

  /// Appends to the list of the next line; points not right of the one before are dropped.
  void store(const SamplePoint& point);

  /// A block taken for the first time has no sample words yet.
  void clear(SegmentPointer block);

 private:
  struct Word {
    std::int64_t pixel = 0;
    SampleAddress next;
  };
  Word& word(const SampleAddress& a) { return words_[2 * a.block + a.side]; }

  Wiring& w_;
  std::vector<Word> words_;
  std::int64_t pixel_ = 0;                ///< the sample point read ahead
  SampleAddress at_, last_;               ///< its word, and the last of the list
  std::int64_t next_pixel_;               ///< first of the next line's list
  SampleAddress next_first_, next_last_;
  std::int64_t next_last_pixel_ = 0;
};

}  // namespace vsg
