// Streams of instructions that are kept from region to region and from frame to frame (Olano and Lastra 1998,
// section 6.1.6), shared by all nodes.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "pixelflow/compiler/generate.h"
#include "pixelflow/compiler/shared_phong.h"

namespace pfman {

/// Surfaces of one shader that share their illum stream with others.
struct Sharer {
  const CompiledShader* shader = nullptr;
  std::vector<int> ids;

  friend bool operator==(const Sharer&, const Sharer&) = default;
};

/// The illum stream of several surfaces, and the copies before and after it, those of each sharer in a stream.
struct CommonIllum {
  Stream illum;
  std::vector<Stream> to_block, from_block;
};

/// Streams by shader and user (an instance, or several that are shaded together): made when they are first needed, and
/// made again when the values are others than the last time. Any number of threads may ask at once. The shaders must
/// outlive it.
class StreamCache {
 public:
  /// The streams stay where they are until the same user's values change. Throws as generate() does.
  const Streams& streams(const CompiledShader& shader, const GenerateInput& input, int user = 0);
  /// How many times streams(), whoever asked, found none or others, and found what was there: while the values of a
  /// frame stand, the sums do not depend on the order in which regions ask.
  int made() const;
  int reused() const;

  /// The common lighting of a surface that has it marked; one for all surfaces that it serves.
  const SharedPhong& common_code(const CompiledShader& surface);
  /// Streams of common_code(), which serves all the sharers; its block begins at `block`.
  const CommonIllum& common_illum(const std::vector<Sharer>& sharers, int block);

 private:
  struct Entry {
    const CompiledShader* shader;
    int user;
    GenerateInput input;
    std::unique_ptr<Streams> streams;
  };
  struct CommonEntry {
    std::vector<Sharer> sharers;
    int block;
    std::unique_ptr<CommonIllum> streams;
  };
  const SharedPhong& find_common_code(const CompiledShader& surface);

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  std::vector<std::unique_ptr<SharedPhong>> codes_;
  std::vector<CommonEntry> common_;
  int made_ = 0, reused_ = 0;
};

}  // namespace pfman
