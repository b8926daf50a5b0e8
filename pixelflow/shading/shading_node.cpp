#include "pixelflow/shading/shading_node.h"

namespace pfman {

void ShadingNode::shade(pixelflow::PixelArray& array) {
  interleaving_.group();
  const Interleaving::Work work = interleaving_.shade(array, *cache_);
  sum_.cycles.pre += work.cycles.pre;
  sum_.cycles.illum += work.cycles.illum;
  sum_.cycles.post += work.cycles.post;
  sum_.cycles.lights += work.cycles.lights;
  sum_.cycles.lookups += work.cycles.lookups;
  sum_.executions += work.executions;
  sum_.shared += work.shared;
}

}  // namespace pfman
