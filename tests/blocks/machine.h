// The golden model's blocks wired up, as surroundings of a block under test. Two of them live the same life: in one the
// golden block works, in the other its neighbours answer the ports of the verilated one. Then both must be equal.
#pragma once

#include <vector>

#include "cmodel/vsg/decision_processor.h"
#include "cmodel/vsg/edge_memory.h"
#include "cmodel/vsg/segment_eliminator.h"
#include "cmodel/vsg/segment_generator.h"

namespace blocks {

/// The sizes that the benches are verilated with.
vsg::Parameters bench_parameters();
vsg::WordFormat x_format();
vsg::WordFormat z_format();
/// Widths of the benches' words beside X and Z.
int pointer_bits();
int coordinate_bits();

struct Machine {
  /// `frame` must outlive the machine. Throws vsg::FrameError as the edge memory does.
  explicit Machine(const vsg::FrameBlocks& frame);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void start_line();
  /// A block as the free list has it, outside of all counts.
  vsg::SegmentPointer take_block();
  void store(vsg::SegmentPointer p, const vsg::SegmentBlock& word) { memory.write(p, vsg::kGroupAll, word, wiring.line); }

  std::vector<vsg::Event> seen;
  vsg::EventSink events = [this](const vsg::Event& event) { seen.push_back(event); };
  vsg::Tally tally;
  vsg::PolygonMemory polygons;
  vsg::EdgeMemory edges;
  vsg::SegmentMemory memory;
  vsg::FreeList free_list;
  vsg::Wiring wiring;
  vsg::SampleList samples{wiring, bench_parameters().segment_blocks};
  vsg::FrameCoherence coherence;  // off: the RTL has none
  vsg::XSort x_sort{wiring};
  vsg::ActiveList active{wiring};
  vsg::ImpliedEdges implied{wiring, x_sort, samples};
  vsg::SegmentGenerator generator{wiring, edges, samples, coherence};
  vsg::SegmentEliminator eliminator{wiring, x_sort};
  vsg::SampleSpaceGenerator space{wiring, samples, coherence};
  vsg::DepthComparator comparator{wiring, x_sort, active, space};
  std::vector<vsg::VisibleSegment> output;
  vsg::DecisionProcessor decision{wiring, comparator, active, space, samples, implied, coherence, output};
};

/// A frame without edges, all polygons seen from the front.
vsg::FrameBlocks empty_frame(int width, int height);

/// Events, counters, accesses and memory of the golden machine and of the other must be equal; tells the first
/// difference and returns whether there was none.
bool expect_same(Machine& golden, Machine& other);

/// What `expect_same` has compared since the program began: events and words.
std::int64_t compared();

}  // namespace blocks
