// Variable lifetimes by static single assignment (Olano and Lastra 1998, section 6.3.3 and figure 10), and unneeded
// code.
#pragma once

#include <vector>

#include "pixelflow/compiler/ir.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Where the pixel's control flow may go from each instruction; code.size() is the end of the shader.
std::vector<std::vector<int>> successors(const ir::Code& code);

/// Renames variables so that every definition has one of its own, with φ-functions where control flow meets (pruned:
/// only where the value is used). A definition that leaves part of the variable as it was (an element by a run-time
/// index) also uses it. Warning W604 for a variable of the source that may be read before it has a value.
void to_ssa(ir::Code& code, Diagnostics& diagnostics);

/// Joins each φ-function's result and operands to one variable and drops the φ-functions: section 6.3.3's last column.
void merge_phis(ir::Code& code);

/// Drops instructions whose result nobody uses.
void drop_unused(ir::Code& code);

/// Joins source and result of copies that do not live at the same time, and drops those copies.
void join_copies(ir::Code& code);

/// Variables alive before each instruction (and one more set: at the end), as bits by variable number. Alive at the
/// end: the colour of a surface.
class Lifetimes {
 public:
  explicit Lifetimes(const ir::Code& code);
  bool alive_before(int instruction, int variable) const;
  /// True where both are needed at once somewhere.
  bool interfere(int a, int b) const;
  /// Alive where lights run: at the start of the illuminance's body or of what follows it.
  bool retained(int variable) const;

 private:
  const ir::Code* code_;
  std::vector<std::vector<bool>> alive_;
  std::vector<std::vector<bool>> interference_;
};

/// For --dump=lifetime: a column an instruction line, with the variables alive.
std::string dump(const Lifetimes& lifetimes, const ir::Code& code);

}  // namespace pfman
