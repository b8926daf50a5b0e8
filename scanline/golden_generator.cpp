#include "scanline/golden_generator.h"

#include "cmodel/vsg/processor.h"

namespace scanline {

vsg::FrameAnswer GoldenGenerator::generate(const vsg::FrameBlocks& blocks, const vsg::EventSink& events) {
  vsg::Processor processor(parameters_, blocks, events);
  while (!processor.finished()) {
    processor.step_line();
    if (on_line) on_line(processor.line());
  }
  return processor.answer();
}

}  // namespace scanline
