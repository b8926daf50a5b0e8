// Surfaces and lights of a frame, and how they are interleaved over a region (Olano and Lastra 1998, section 6.1.5 and
// figure 9).
#pragma once

#include <cstdint>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/shading/instance.h"
#include "pixelflow/shading/stream_cache.h"
#include "pixelflow/shading/texture_memory.h"

namespace pfman {

class Interleaving {
 public:
  /// Throws std::invalid_argument where surfaces and lights do not fit each other: a light needs memory below the
  /// high-water mark of a surface, or a surface of three light colours meets a light of one; and where two surfaces
  /// have the same ID or one has none. Lights run in the order of their IDs. `textures` may be null.
  Interleaving(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures);

  /// To change values between two frames; group() comes afterwards.
  Instance& surface(std::size_t number) { return surfaces_.at(number); }
  Instance& light(std::size_t number) { return lights_.at(number); }
  /// Puts surfaces with equal values together.
  void group();

  struct Cycles {
    std::uint64_t pre = 0, illum = 0, post = 0, lights = 0;
    std::uint64_t lookups = 0;  ///< texture lookups, a region each
  };
  struct Work {
    Cycles cycles;       ///< of the array
    int executions = 0;  ///< surfaces: instances with equal values run once
    int shared = 0;      ///< of these, with their light added up by a stream that serves several surfaces
  };
  /// Shades what lies in the array: shader IDs, parameters by the transfer maps, positions (float[3] at kPositionAt).
  /// Afterwards the colour of every pixel that has a surface is at kColorAt, U(8,8)[3]. Throws UniformError. Several
  /// threads may shade at once, each with an array of its own.
  Work shade(pixelflow::PixelArray& array, StreamCache& cache) const;

 private:
  /// Instances of one shader with equal values.
  struct Group {
    std::size_t first;     ///< the first of them among the surfaces
    std::vector<int> ids;  ///< all of them, there or not: the streams stay the same from region to region
  };
  /// A group that the region has pixels of.
  struct Present {
    const CompiledShader* shader;
    const std::vector<int>* ids;
    const Streams* streams;
    bool shares = false;  ///< its light is added up by the common stream
    /// Parts of the first stream up to the lookup that it shares; 0: none.
    std::size_t before_lookup = 0;
  };
  std::vector<Present> present_in(const pixelflow::PixelArray& array, StreamCache& cache) const;
  const Streams& streams(const Instance& instance, const std::vector<int>& ids, int user, StreamCache& cache) const;
  /// Decides which groups share their illum stream: those of one kind, where there are two at least and the memory
  /// suffices. Null when none do.
  const CommonIllum* share_illum(std::vector<Present>& present, StreamCache& cache) const;
  /// Which groups look up together: those of the flag. One without illuminance has to keep what it knows while lights
  /// run; where the memory does not suffice it looks up alone.
  void share_lookup(std::vector<Present>& present) const;

  std::vector<Instance> surfaces_, lights_;
  const TextureMemory* textures_;
  std::vector<Group> groups_;
};

}  // namespace pfman
