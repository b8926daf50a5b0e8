#include "tests/blocks/segment_scenes.h"

#include <algorithm>

namespace blocks {

SegmentScene::SegmentScene(Random& random, int width)
    : random_(random),
      width_(width),
      most_(random.between(1, 10)),
      slope_(random.between(0, 3)),
      depth_(std::int64_t{1} << random.between(2, z_format().bits - 3)),
      coarse_(random.once_in(3)),
      faulty_(random.once_in(8)) {}

vsg::SegmentBlock SegmentScene::random_segment() {
  const vsg::WordFormat x = x_format();
  // Often ends meet on a few pixels, so that edges are shared.
  const auto pixel = [this] {
    const std::int64_t margin = faulty_ ? 1 : std::min(width_ / 3, 20);
    const std::int64_t at = random_.between(margin, width_ - margin);
    return coarse_ ? std::max(margin, at / 16 * 16) : at;
  };
  const std::int64_t a = pixel(), b = pixel();
  const auto edge = [this, &x](std::int64_t at) {
    vsg::SegmentEdge e;
    e.dx = slope_ == 0 ? 0 : random_.between(-(slope_ << (x.fraction - 1)), slope_ << (x.fraction - 1));
    e.x = x.from_integer(at) + (coarse_ ? 0 : random_.between(0, (1 << x.fraction) - 1)) - e.dx;
    e.dz = random_.between(-depth_ / 16, depth_ / 16);
    e.z = random_.between(-depth_, depth_) - e.dz;
    return e;
  };
  vsg::SegmentBlock block;
  block.left = edge(std::min(a, b));
  block.right = edge(std::max(a, b));
  if (random_.once_in(6)) block.right.z = block.left.z, block.right.dz = block.left.dz;
  block.left_lines = -static_cast<std::int32_t>(random_.between(1, 8));
  block.right_lines = -static_cast<std::int32_t>(random_.between(1, 8));
  block.polygon = static_cast<std::int32_t>(random_.between(1, bench_parameters().polygon_blocks));
  if (random_.once_in(12)) {  // a crossing that was found on two lines before
    block.implied = true;
    block.right = {};
    block.left.z = block.left.dz = 0;
    block.left_lines = block.right_lines = 0;
  }
  return block;
}

void SegmentScene::enter(Machine& golden, Machine& other) {
  for (auto count = random_.between(0, most_); count > 0; --count) {
    const vsg::SegmentPointer p = golden.take_block();
    static_cast<void>(other.take_block());
    if (p == 0) return;
    const vsg::SegmentBlock segment = random_segment();
    for (Machine* m : {&golden, &other}) {
      vsg::SegmentBlock block = segment;
      m->x_sort.insert(p, block, 0);
      m->store(p, block);
    }
  }
}

}  // namespace blocks
