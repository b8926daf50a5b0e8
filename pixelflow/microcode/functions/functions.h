// Microcode of the mathematical functions (Olano and Lastra 1998, section 6.1.4), bit for bit the native versions of
// cmodel/pixelflow/native, where the algorithms and formats are described. Both branches of every choice are executed.
//
// Each routine leaves the operands as they are until the result is complete, so that d may be an operand.
#pragma once

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/microcode/assembler.h"

namespace pixelflow {

void write_trigonometric(Assembler& a, const Operation& o);  ///< Sin Cos Tan and their fast versions
int trigonometric_workspace(const Operation& o);
void write_arcsine(Assembler& a, const Operation& o);  ///< Asin Acos and their fast versions
int arcsine_workspace(const Operation& o);
void write_inverse_square_root(Assembler& a, const Operation& o);
int inverse_square_root_workspace(const Operation& o);
void write_arctangent(Assembler& a, const Operation& o);  ///< Atan Atan2 and their fast versions
int arctangent_workspace(const Operation& o);
void write_exponential(Assembler& a, const Operation& o);  ///< Exp Exp2 and their fast versions
int exponential_workspace(const Operation& o);
void write_logarithm(Assembler& a, const Operation& o);  ///< Log Log2 and their fast versions
int logarithm_workspace(const Operation& o);
void write_power(Assembler& a, const Operation& o);  ///< Pow
int power_workspace(const Operation& o);

}  // namespace pixelflow
