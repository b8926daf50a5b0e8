// Random nested statements over a few bytes, executed pixel by pixel, and written as the compiler's code.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "pixelflow/compiler/compile.h"

namespace pfman_tests {

constexpr int kBytes = 6;         ///< of a pixel's state, one variable each
constexpr int kStateAt = 40;      ///< in pixel memory
constexpr int kDeepMasksAt = 20;  ///< mask bits beyond the eighth

using State = std::array<std::uint8_t, kBytes>;

struct MaskedStatement {
  enum class Kind {
    Add,          // state[to] += state[from] + number
    If,           // state[from] < number
    Loop,         // number iterations
    Break,        // by this pixel
    Continue,     // by this pixel
    BreakAll,     // in iteration `number`
    ContinueAll,  // in iteration `number`
  };
  Kind kind = Kind::Add;
  int to = 0, from = 0, number = 0;
  bool by_byte = false;  ///< If: the condition goes through a byte of memory
  bool has_else = false;
  std::vector<MaskedStatement> first, second;
};

class MaskedProgram {
 public:
  MaskedProgram(std::mt19937_64& random, int depth);

  /// What one pixel does.
  void execute(State& state) const;

  /// The same as a surface's only stage; lives as long as this.
  const pfman::CompiledShader& compiled() const { return compiled_; }

 private:
  struct Within {
    bool loop = false;    ///< in a loop at all
    bool masked = false;  ///< under a varying condition within the innermost loop
  };
  std::vector<MaskedStatement> block(std::mt19937_64& random, int depth, Within within);
  void write(const std::vector<MaskedStatement>& block, int bits);
  void write_if(const MaskedStatement& statement, int bits);
  void write_loop(const MaskedStatement& statement, int bits);
  void write_uniform_jump(const MaskedStatement& statement);
  int add(pfman::ir::Instruction instruction);
  int uniform(pfman::NodePtr tree);

  std::vector<MaskedStatement> body_;
  pfman::Tree tree_;
  pfman::Shader shader_;
  pfman::CompiledShader compiled_;
  struct OpenLoop {
    int at;
    pfman::Variable* counter;
  };
  std::vector<OpenLoop> loops_;
};

}  // namespace pfman_tests
