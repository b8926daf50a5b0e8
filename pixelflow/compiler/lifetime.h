// Variable lifetimes by static single assignment (Olano and Lastra 1998, section 6.3.3 and figure 10), and unneeded
// code.
#pragma once

#include <vector>

#include "pixelflow/compiler/bit_matrix.h"
#include "pixelflow/compiler/ir.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

/// Where the pixel's control flow may go from each instruction; code.size() is the end of the shader. The illuminance's
/// body is a loop over the lights.
std::vector<std::vector<int>> successors(const ir::Code& code);

/// Where it may come from, in ascending order, for code.size() as well. -1 is the start of the shader; what no pixel
/// reaches, behind a jump, counts as reached from the instruction before it.
std::vector<std::vector<int>> predecessors(const std::vector<std::vector<int>>& successors);

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

/// Variables alive before each instruction, and at the end. Alive is what has been given a value and whose value is
/// used later; at the end the colour of a surface and what a light leaves in the shared area; always the bytes of mask
/// bits. The shared variables of lights come into being in a surface where the illuminance's body begins. φ-functions
/// count as copies on the way to them.
class Lifetimes {
 public:
  explicit Lifetimes(const ir::Code& code);
  bool alive_before(int instruction, int variable) const { return before_.test(instruction, variable); }
  bool alive_after(int instruction, int variable) const { return after_.test(instruction, variable); }
  /// True where both are needed at once somewhere, or where an instruction needs them apart.
  bool interfere(int a, int b) const { return interference_.test(a, b); }
  /// Alive where lights run: at the start of the illuminance's body or of what follows it. A surface without
  /// illuminance runs when all lights have: what it has received is retained.
  bool retained(int variable) const { return retained_.test(0, variable); }

  const BitMatrix& before() const { return before_; }  ///< a row an instruction, and one for the end
  const BitMatrix& after() const { return after_; }
  const BitMatrix& interference() const { return interference_; }

 private:
  BitMatrix before_, after_, interference_, retained_;
};

/// For --dump=lifetime: a column a variable, a line an instruction.
std::string dump(const Lifetimes& lifetimes, const ir::Code& code);

}  // namespace pfman
