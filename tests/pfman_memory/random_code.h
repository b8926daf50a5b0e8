// Random code for one shader: straight pieces, branches and loops of the host and of the enable flag, jumps, arrays,
// parts of numbers, stages. Only what has a value on every way is read.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "tests/pfman_memory/code_builder.h"

namespace pfman_tests {

struct RandomShape {
  int statements = 30;  ///< of each stage, about
  bool loops = true;
  bool branches = true;
  bool lights = true;  ///< a surface with an illuminance
  bool light_shader = false;
};

class RandomCode {
 public:
  RandomCode(std::uint64_t seed, const RandomShape& shape);
  CodeBuilder builder;

 private:
  using Operand = pfman::ir::Operand;
  using Kind = CodeBuilder::Kind;
  using Values = std::vector<bool>;  ///< by variable: it has one
  struct LoopState {
    int at = 0;
    bool masked = false;  ///< within a masked branch of the loop
    bool uniform_jump = false;
    Values at_start;
  };

  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  bool chance(int percent) { return below(100) < percent; }
  void declare();
  void stage(int number);
  void block(int statements, int depth);
  void statement(int depth);
  void assign();
  void assign_fixed();
  void assign_float();
  void assign_bytes();
  void assign_copy();
  void assign_part();
  void assign_element();
  void noise();
  void lookup();
  void branch(int depth);
  void twice(int depth);
  void loop(int depth);
  void jump();

  /// A variable with a value, of the size (any for 0), or a literal. All bytes of `whole`, if it is that: an operation
  /// must not write over bytes that it still reads, so what overlaps begins at the same byte.
  Operand source(int bytes, bool literal_allowed = true, int whole = -1);
  int pick(int bytes, bool with_value);
  Operand target(int bytes);
  void give(int variable) { has_value_[static_cast<std::size_t>(variable)] = true; }
  int size_of(int variable) const { return builder.code.variables[static_cast<std::size_t>(variable)].scalar.bytes(); }

  std::mt19937 random_;
  RandomShape shape_;
  Values has_value_;
  std::vector<int> frozen_;  ///< not to be assigned here
  std::vector<LoopState> loops_;
  std::vector<int> singles_;
  std::vector<int> arrays_;
  int point_ = -1, coordinates_ = -1, texel_ = -1, condition_ = -1;
};

}  // namespace pfman_tests
