// A shading node: surfaces and lights, interleaved over one region (Olano and Lastra 1998, section 6.1.5 and figure 9).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/shared_phong.h"
#include "pixelflow/shading/instance.h"
#include "pixelflow/shading/texture_memory.h"

namespace pfman {

class ShadingNode {
 public:
  /// Throws std::invalid_argument where surfaces and lights do not fit each other: a light needs memory below the
  /// high-water mark of a surface, or a surface of three light colours meets a light of one; and where two surfaces
  /// have the same ID or one has none. Lights run in the order of their IDs. `textures` may be null.
  ShadingNode(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures);

  /// To change values between two frames; only the streams of what was changed are made again.
  Instance& surface(std::size_t number) { return surfaces_.at(number); }
  Instance& light(std::size_t number) { return lights_.at(number); }

  /// Shades what lies in the array: shader IDs, parameters by the transfer maps, positions (float[3] at kPositionAt).
  /// Afterwards the colour of every pixel that has a surface is at kColorAt, U(8,8)[3]. Throws UniformError.
  void shade(pixelflow::PixelArray& array);

  struct Cycles {
    std::uint64_t pre = 0, illum = 0, post = 0, lights = 0;
    std::uint64_t lookups = 0;  ///< texture lookups, a region each
  };
  const Cycles& cycles() const { return cycles_; }
  /// Surfaces executed, a region each: instances with equal values run once.
  int executions() const { return executions_; }
  /// How many of them had their light added up by a stream that serves several surfaces.
  int shared() const { return shared_; }
  const StreamCache& cache() const { return cache_; }

 private:
  /// Instances of one shader with equal values, of which there are pixels in the region.
  struct Group {
    const Instance* first;
    std::vector<int> ids;  ///< all of them, there or not: the streams stay the same from region to region
    const Streams* streams = nullptr;
    bool shares = false;  ///< its light is added up by the common stream
  };
  /// The common illum stream of the surfaces that share it, and the copies before and after it.
  struct Common {
    std::unique_ptr<SharedPhong> code;
    std::vector<std::vector<int>> ids;  ///< of each group that shares
    int block = -1;
    Stream illum;
    std::vector<Stream> to_block, from_block;
  };
  std::vector<Group> groups_in(const pixelflow::PixelArray& array) const;
  /// Decides which groups share their illum stream: those of one kind, where there are two at least and the memory
  /// suffices.
  void share_illum(std::vector<Group>& groups);
  const Streams& streams(const Instance& instance, const std::vector<int>& ids, int user);
  void run(const Stream& stream, pixelflow::PixelArray& array, std::uint64_t& cycles);
  void look_up(const Lookup& lookup, pixelflow::PixelArray& array);

  std::vector<Instance> surfaces_, lights_;
  const TextureMemory* textures_;
  StreamCache cache_;
  Common common_;
  Cycles cycles_;
  int executions_ = 0, shared_ = 0;
};

}  // namespace pfman
