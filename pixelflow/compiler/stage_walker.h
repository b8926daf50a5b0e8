// The stages of a shader's code; one of them walked as the host runs it, writing what the pixel processors are to do.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pixelflow/compiler/enable_masks.h"

namespace pfman {

/// First instructions of the stages that follow the first, and the end.
struct StageBounds {
  int illum = -1;  ///< behind its marker; -1: there is none
  int post = -1;
  int first_end = 0;
  int illum_end = 0;
  int end = 0;
};

StageBounds stages(const ir::Code& code);

class StageWalker {
 public:
  StageWalker(const CompiledShader& shader, Environment& environment, const std::vector<int>& ids, Stream& stream);

  /// `bound`: varying parameters to be loaded first, null but in the first stage. `colours`: the picture's colour is
  /// written at the end.
  void walk(int first, int last, const std::map<std::string, Raw>* bound, bool colours);

  /// All of the code in another stream: a varying parameter by its number is copied from, or loaded with, its argument;
  /// results, by their number among the code's colours, are copied to theirs.
  void walk_call(const std::vector<ExternalArgument>& parameters, const std::vector<PixelVariable>& results,
                 const PixelWorkspace& workspace);

 private:
  const ir::Instruction& instruction(int at) const { return code_.code[static_cast<std::size_t>(at)]; }
  int place(int variable) const { return map_.address[static_cast<std::size_t>(variable)]; }
  std::vector<int> deep() const;

  Raw value(int uniform) { return evaluate(*code_.uniforms[static_cast<std::size_t>(uniform)], environment_); }
  bool condition(int uniform) { return value(uniform).at(0) != 0; }
  std::int64_t integer(int uniform);
  /// An operand with its address, or the value of a uniform one.
  pixelflow::Operand resolve(const ir::Operand& operand);

  /// Executes one instruction and says which is next.
  int step(int at);
  void enter(int loop);
  int leave(int loop);
  int repeat(int loop);
  int next_of(int loop) const;

  void load(const ir::Parameter& parameter, const Raw& value);
  void execute(const ir::Instruction& i);
  void operate(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a,
               const pixelflow::Operand& b);
  int share_lookup(int at);
  void look_up(const ir::Instruction& i, const pixelflow::Operand& d, const pixelflow::Operand& a);
  void call(const ir::Instruction& i);
  ExternalArgument argument(const ir::Operand& operand, const Type& type);

  const ir::Code& code_;
  const MemoryMap& map_;
  Environment& environment_;
  StreamWriter out_;
  EnableMasks masks_;
  std::vector<int> iterations_;  ///< of the loops around
  int last_ = 0;                 ///< end of what is walked
};

}  // namespace pfman
