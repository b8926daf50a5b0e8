// A shading node that holds its surfaces and lights: for regions that lie in the array already.
#pragma once

#include <memory>
#include <vector>

#include "pixelflow/shading/interleaving.h"

namespace pfman {

class ShadingNode {
 public:
  /// Throws std::invalid_argument as Interleaving does. `textures` may be null.
  ShadingNode(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures)
      : interleaving_(std::move(surfaces), std::move(lights), textures), cache_(std::make_unique<StreamCache>()) {}

  /// To change values between two frames; only the streams of what was changed are made again.
  Instance& surface(std::size_t number) { return interleaving_.surface(number); }
  Instance& light(std::size_t number) { return interleaving_.light(number); }

  /// As Interleaving::shade().
  void shade(pixelflow::PixelArray& array);

  // Sums over what was shaded.
  using Cycles = Interleaving::Cycles;
  const Cycles& cycles() const { return sum_.cycles; }
  int executions() const { return sum_.executions; }
  int shared() const { return sum_.shared; }
  const StreamCache& cache() const { return *cache_; }

 private:
  Interleaving interleaving_;
  std::unique_ptr<StreamCache> cache_;
  Interleaving::Work sum_;
};

}  // namespace pfman
