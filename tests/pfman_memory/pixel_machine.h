// Executes code for one pixel. What operations compute does not matter here, only which bytes they read and write: a
// result is a hash of operation and operands. Host and enable flag are played as the language defines them, without the
// compiler's idea of control flow.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "pixelflow/compiler/allocate.h"
#include "pixelflow/compiler/ir.h"

namespace pfman_tests {

std::uint64_t mix(std::uint64_t a, std::uint64_t b);

struct Circumstances {
  std::uint64_t values = 1;  ///< seed of parameters, lights, uniform values
  int lights = 1;
};

class PixelMachine {
 public:
  /// On variables that have bytes of their own.
  PixelMachine(const pfman::ir::Code& code, Circumstances circumstances);
  /// On pixel memory. Before each instruction that the pixel executes, all bytes of which `lifetimes` says that they
  /// hold nothing are overwritten, and those of workspaces while it executes; the lights overwrite all from the
  /// high-water mark on.
  PixelMachine(const pfman::ir::Code& code, Circumstances circumstances, const pfman::MemoryMap& map,
               const pfman::Lifetimes& lifetimes);

  /// Bytes of the colour, for a light of what it leaves in the shared area, and of the mask bytes.
  std::vector<std::uint8_t> run();

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Loop {
    int at = 0;
    int iteration = 0;
    int iterations = 0;
  };
  struct Jump {
    int loop = 0;
    bool leaves = false;
  };

  const pfman::ir::Instruction& instruction(int at) const { return code_.code[static_cast<std::size_t>(at)]; }
  int bytes_of(int variable) const { return code_.variables[static_cast<std::size_t>(variable)].bytes(); }
  void start();
  void shine(int light);
  int step(int at);
  int leave_loop(int loop);
  void execute(int at);
  void overwrite_dead(int at);
  void overwrite(int first, int end);

  std::uint64_t uniform(int number);
  int place(const pfman::ir::Operand& operand, std::int64_t index) const;
  std::int64_t index_of(const pfman::ir::Operand& operand);
  Bytes read(const pfman::ir::Instruction& of, const pfman::ir::Operand& operand, std::int64_t index);
  bool enabled() const;

  const pfman::ir::Code& code_;
  Circumstances circumstances_;
  const pfman::MemoryMap* map_ = nullptr;
  const pfman::Lifetimes* lifetimes_ = nullptr;
  std::vector<int> base_;  ///< by variable
  Bytes memory_;
  std::uint64_t poison_ = 0;
  std::map<int, std::uint64_t> evaluations_;  ///< of each uniform expression
  std::vector<Loop> loops_;
  std::vector<bool> conditions_;  ///< of masked branches around
  std::optional<Jump> jump_;      ///< the pixel waits for the end of an iteration or a loop
  bool k_ = false;
};

/// Throws std::invalid_argument where the library refuses an operation as it is placed.
void check_operations(const pfman::ir::Code& code, const pfman::MemoryMap& map);

}  // namespace pfman_tests
