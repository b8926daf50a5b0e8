#include "cmodel/vsg/processor.h"

#include <utility>

#include "cmodel/vsg/decision_processor.h"
#include "cmodel/vsg/edge_memory.h"
#include "cmodel/vsg/segment_eliminator.h"
#include "cmodel/vsg/segment_generator.h"

namespace vsg {
namespace {

// Spans on one line before the frame is given up, as a multiple of its width. Nothing known comes near it.
constexpr int kSpansPerPixel = 64;

const char* reason(FrameError::Kind kind) {
  switch (kind) {
    case FrameError::Kind::kOutOfFrame: return "an edge leaves the frame";
    case FrameError::Kind::kSegmentMemoryFull: return "segment memory is full";
    case FrameError::Kind::kEdgeMemoryFull: return "edge memory is full";
    case FrameError::Kind::kPolygonMemoryFull: return "polygon memory is full";
    case FrameError::Kind::kTooManySpans: return "a scan line was subdivided without end";
  }
  return "";
}

}  // namespace

FrameError::FrameError(Kind kind, int line)
    : std::runtime_error((line > 0 ? "scan line " + std::to_string(line) + ": " : std::string()) + reason(kind)),
      kind_(kind), line_(line) {}

struct Processor::Machine {
  Machine(const Parameters& p, const FrameBlocks& f, EventSink sink)
      : parameters(p), frame(f), events(std::move(sink)) {
    recorder.frame_started(tally);
  }

  Parameters parameters;
  const FrameBlocks& frame;
  EventSink events;
  Tally tally;
  StatisticsRecorder recorder;
  PolygonMemory polygons{frame.polygons, parameters.polygon_blocks, tally};
  EdgeMemory edges{frame, parameters.edge_blocks, polygons, tally};
  SegmentMemory memory{parameters.segment_blocks, events};
  FreeList free_list{parameters.segment_blocks};
  Wiring wiring{frame.width, frame.height,
                {parameters.integer_bits + parameters.fraction_bits_x, parameters.fraction_bits_x},
                {parameters.integer_bits + parameters.fraction_bits_z, parameters.fraction_bits_z},
                memory, free_list, polygons, tally, events};
  SampleList sample_list{wiring, parameters.segment_blocks};
  FrameCoherence coherence{wiring, frame.edges, parameters.frame_coherence};
  XSort x_sort{wiring};
  ActiveList active{wiring};
  ImpliedEdges implied{wiring, x_sort, sample_list};
  SegmentGenerator segment_generator{wiring, edges, sample_list, coherence};
  SegmentEliminator segment_eliminator{wiring, x_sort};
  SampleSpaceGenerator sample_space{wiring, sample_list, coherence};
  DepthComparator comparator{wiring, x_sort, active, sample_space};
  FrameAnswer answer;
  DecisionProcessor decision{wiring, comparator, active, sample_space, sample_list, implied, coherence, answer.segments};
};

Processor::Processor(const Parameters& parameters, const FrameBlocks& frame, EventSink events)
    : machine_(std::make_unique<Machine>(parameters, frame, std::move(events))) {
  machine_->answer.width = frame.width;
  machine_->answer.height = frame.height;
}

Processor::~Processor() = default;

bool Processor::finished() const { return machine_->wiring.line == machine_->frame.height; }
int Processor::line() const { return machine_->wiring.line; }

void Processor::step_line() {
  Machine& m = *machine_;
  ++m.wiring.line;
  const std::int64_t references = m.tally.references();
  m.recorder.line_started(m.tally);
  m.x_sort.start_line();
  m.sample_list.start_line();
  m.coherence.start_line();
  m.segment_generator.run();
  m.segment_eliminator.run();

  m.recorder.depth_sort_started(m.tally);
  m.sample_space.start_line();
  m.implied.start_line();
  m.active.start_line();
  m.decision.start_line();
  std::int64_t spans = 0;
  do {
    m.sample_space.next_span();
    do {
      if (++spans > std::int64_t{kSpansPerPixel} * m.frame.width) {
        throw FrameError(FrameError::Kind::kTooManySpans, m.wiring.line);
      }
      m.comparator.sort_span();
    } while (!m.decision.decide());
  } while (!m.sample_space.line_finished());
  const std::int64_t segments = m.decision.finish_line();
  if (segments != 1) ++m.tally.pq[pq::kInvolvedLines];
  m.recorder.line_finished(m.tally);

  const LineCounts counts{m.tally.references() - references, segments};
  m.answer.lines.push_back(counts);
  if (m.events) m.events({EventKind::kLineDone, m.wiring.line, {counts.references, counts.segments}});
}

FrameAnswer Processor::answer() const {
  FrameAnswer answer = machine_->answer;
  StatisticsRecorder recorder = machine_->recorder;
  complete_answer(answer, machine_->tally, recorder.finish(machine_->tally, machine_->frame.height), machine_->parameters);
  answer.edges_visible = machine_->coherence.edges_visible();
  answer.port_accesses = machine_->memory.accesses();
  return answer;
}

}  // namespace vsg
