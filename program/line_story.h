// The story of one scan line, told from the processor's events for somebody who learns how it works.
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cmodel/vsg/blocks.h"
#include "cmodel/vsg/events.h"
#include "cmodel/vsg/segment_memory.h"

namespace program {

class LineStory {
 public:
  LineStory(int line, const vsg::Parameters& parameters) : line_(line), parameters_(parameters) {}

  /// Sees every event of the frame, in order: blocks that the line uses were written on lines before.
  void record(const vsg::Event& event);

  /// The whole story, after the last event.
  std::string text() const;

 private:
  // What happened, as sentences under the headings of the story.
  struct Chapter {
    std::string lines;
    int count = 0;
  };

  void remember_block(const vsg::Event& event);
  void tell_edge(const vsg::Event& event);
  void tell_block(const vsg::Event& event, bool implied);
  void tell_test(const vsg::Event& event);
  void tell_decision(const vsg::Event& event);
  void tell_sample(const vsg::Event& event);
  void tell_output(const vsg::Event& event);

  std::string x(std::int64_t value) const;
  std::string z(std::int64_t value) const;
  std::string segment(std::int64_t block) const;

  const int line_;
  const vsg::Parameters parameters_;
  std::map<std::int64_t, vsg::SegmentBlock> memory_;  // segment memory, as written so far
  // Blocks taken on this line; one may come back to the free list and be taken again as an implied edge.
  std::set<std::pair<std::int64_t, bool>> taken_;
  Chapter edges_, blocks_, spans_, samples_, output_;
  std::string tests_;  // of the span that is being sorted
  std::int64_t tests_count_ = 0, add_cycles_ = 0, references_ = 0, output_from_ = 1;
  static constexpr std::int64_t kNoCrossing = std::numeric_limits<std::int64_t>::max();
  std::int64_t crossing_from_ = kNoCrossing;  // left end of the span whose crossing is still to be told
};

}  // namespace program
