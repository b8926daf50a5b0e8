// The routines behind the library, one for each kind of operation. Each writes the instructions and expects a checked
// operation; each _workspace function gives the bytes it uses from operation.work on.
#pragma once

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/microcode/assembler.h"

namespace pixelflow {

// Operands of fixed-point routines: byte `index` of the number, extended by zeros or by its sign.
/// The byte of a uniform operand.
int constant_byte(const Operand& operand, int index);
/// True where the byte has to be made of the number's sign.
bool is_sign_fill(const Operand& operand, int index);
/// M := byte. A sign fill is made from K, which must hold the number's sign (load_sign).
void load_byte(Assembler& a, const Operand& operand, int index);
void load_sign(Assembler& a, Flag flag, const Operand& operand);
bool overlap(const Operand& one, const Operand& other);

void write_copy(Assembler& a, const Operation& o);
void write_add(Assembler& a, const Operation& o);
void write_compare(Assembler& a, const Operation& o);
void write_multiply(Assembler& a, const Operation& o);
int multiply_workspace(const Operation& o);
void write_divide(Assembler& a, const Operation& o);
int divide_workspace(const Operation& o);
void write_shift_left(Assembler& a, const Operation& o);
void write_shift_right(Assembler& a, const Operation& o);
void write_square_root(Assembler& a, const Operation& o);
int square_root_workspace(const Operation& o);
void write_wrap(Assembler& a, const Operation& o);
void write_saturate(Assembler& a, const Operation& o);

void write_float_add(Assembler& a, const Operation& o);
void write_float_multiply(Assembler& a, const Operation& o);
void write_float_divide(Assembler& a, const Operation& o);
void write_float_square_root(Assembler& a, const Operation& o);
void write_float_compare(Assembler& a, const Operation& o);
void write_fixed_to_float(Assembler& a, const Operation& o);
void write_float_to_fixed(Assembler& a, const Operation& o);
int float_workspace(const Operation& o);
int float_add_workspace(const Operation& o);
int float_compare_workspace(const Operation& o);
int fixed_to_float_workspace(const Operation& o);
int float_to_fixed_workspace(const Operation& o);

void write_noise(Assembler& a, const Operation& o);
int noise_workspace(const Operation& o);

}  // namespace pixelflow
