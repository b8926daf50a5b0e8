#include "tests/blocks/lists_surroundings.h"

namespace blocks {

void ListsSurroundings::start_frame(Machine& machine) {
  machine_ = &machine;
  counting_ = {};
  sort_wait_ = -1;
  bench_->width_i = port(machine.wiring.width);
  bench_.start_frame();
  show();
}

void ListsSurroundings::cycle() {
  bench_.settle();
  serve();
  bench_.tick();
  show();
  bench_.settle();
}

void ListsSurroundings::serve() {
  counting_.add(counts_of(bench_->count_o), machine_->tally);
  memory_.take(bench_->request_o, *machine_);
  if (bench_->take_o) {
    bool fresh = false;
    const vsg::SegmentPointer p = machine_->free_list.take(fresh);
    EXPECT_NE(p, 0) << "a block is taken where none is";
    EXPECT_EQ(bench_->clear_samples_o != 0, fresh) << "sample words of block " << p;
    if (fresh) machine_->samples.clear(p);
  }
  if (bench_->return_o) machine_->free_list.put_back(static_cast<vsg::SegmentPointer>(bench_->returned_o));
  if (bench_->set_first_o) {
    const std::uint32_t polygon = taken_polygon_ != 0 ? bench_->set_polygon_o : bench_->lists_polygon_i;
    machine_->polygons.set_first_segment(static_cast<std::int32_t>(polygon),
                                         static_cast<vsg::SegmentPointer>(bench_->set_segment_o));
  }
  if (bench_->polygon_take_o) taken_polygon_ = machine_->polygons.take_changing();
  if (bench_->eliminator_done_o) taken_polygon_ = 0;
  if (bench_->sort_o) sort();
}

void ListsSurroundings::sort() {
  ASSERT_LT(sort_wait_, 0) << "a command before the last one is done";
  const auto p = static_cast<vsg::SegmentPointer>(bench_->sort_block_o);
  const std::int64_t pixel = pixel_of(bench_->sort_pixel_o);
  links_ = {};
  links_.left.x = x_format().from_integer(pixel);
  switch (bench_->sort_command_o) {
    case 0: machine_->x_sort.insert(p, links_, static_cast<vsg::SegmentPointer>(bench_->sort_start_o)); break;
    case 1:
      links_.x_previous = static_cast<vsg::SegmentPointer>(bench_->unlink_previous_o);
      links_.x_next = static_cast<vsg::SegmentPointer>(bench_->unlink_next_o);
      machine_->x_sort.unlink(p, links_);
      break;
    default: machine_->x_sort.insert_next_line(p, links_, pixel); break;
  }
  // A search reads words of its own: what the block had read is gone.
  if (bench_->sort_command_o != 1) memory_.disturb();
  sort_wait_ = random_.between(0, 6);
}

void ListsSurroundings::show() {
  memory_.show(bench_->word_i);
  vsg::FreeList list = machine_->free_list;
  bool fresh = false;
  const vsg::SegmentPointer next = list.take(fresh);
  bench_->free_block_i = port(next);
  bench_->free_fresh_i = fresh;
  bench_->free_full_i = next == 0;
  vsg::PolygonMemory polygons = machine_->polygons;
  bench_->changing_i = port(polygons.take_changing());
  if (taken_polygon_ != 0) bench_->first_segment_i = port(machine_->polygons.first_segment(taken_polygon_));
  bench_->sort_done_i = 0;
  if (sort_wait_ >= 0) {
    bench_->sort_done_i = sort_wait_ == 0;
    bench_->sort_previous_i = port(sort_wait_ == 0 ? links_.x_previous : 0);
    bench_->sort_next_i = port(sort_wait_ == 0 ? links_.x_next : 0);
    --sort_wait_;
  }
}

}  // namespace blocks
