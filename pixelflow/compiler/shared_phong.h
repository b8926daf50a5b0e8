// One illum stream for all surfaces that are lit by the common Phong code (Olano and Lastra 1998, section 6.1.5.3).
//
// A surface of the flag has the common code as its own illuminance, and can always run that. Where several meet, their
// inputs are copied to a block of memory at one place in all of them, one stream adds up the light of each lamp for all
// of their pixels, and the sums are copied back. The bits are the same.
#pragma once

#include <memory>
#include <vector>

#include "pixelflow/compiler/generate.h"

namespace pfman {

/// After lower(): names what the common code reads and leaves at the stages of a surface that uses both of its results.
void mark_shared_phong(ir::Code& code, const Shader& shader);

class SharedPhong {
 public:
  /// Of the types of normal and view that `surface` has. Its code must be marked.
  explicit SharedPhong(const CompiledShader& surface);

  bool serves(const CompiledShader& surface) const;

  /// Bytes of the block that lights have to leave alone, and of what the stream needs behind it.
  int block_bytes() const { return block_bytes_; }
  int work_bytes() const { return static_cast<int>(work_.size()); }

  /// The illum stream of all pixels of these shaders, the block from `block` on.
  Stream illum(int block, const std::vector<int>& ids) const;
  /// From the surface's own places to the block, and back to them.
  Stream copies(const CompiledShader& surface, int block, const std::vector<int>& ids, bool back) const;

 private:
  /// Where the compiler has put everything.
  Stream own_illum(const std::vector<int>& ids) const;

  std::unique_ptr<CompiledUnit> unit_;
  ir::Code::SharedPhong types_;
  int block_bytes_ = 0;
  std::vector<int> work_;  ///< addresses that own_illum() uses besides
};

}  // namespace pfman
