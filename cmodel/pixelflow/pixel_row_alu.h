// The ALU of the pixel elements on rows of vectors; part of pixel_row.cpp, apart because every function is a loop of
// its own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cmodel/pixelflow/instruction.h"
#include "cmodel/pixelflow/row_vectors.h"

namespace pixelflow {

/// Operands and results of one ALU instruction: rows, with the distance from one vector to the next (0 for a constant,
/// or for a result that nobody wants). A result may lie where an operand lies.
struct AluRows {
  int vectors;
  const std::uint8_t* p;
  std::ptrdiff_t p_stride;
  const std::uint8_t* q;
  std::ptrdiff_t q_stride;
  const std::uint8_t* cin = nullptr;  ///< masks
  std::ptrdiff_t cin_stride = 0;
  const std::uint8_t* k = nullptr;  ///< the condition, a row of masks
  const std::uint8_t* e = nullptr;  ///< the enable flag, a row of masks
  Gate gate = Gate::None;
  std::uint8_t* result = nullptr;
  std::ptrdiff_t result_stride = 0;
  bool set_c = false;   ///< the carry is wanted
  bool set_zs = false;  ///< zero or sign are wanted
  std::uint8_t* c_out = nullptr;
  std::uint8_t* s_out = nullptr;
  std::uint8_t* z_out = nullptr;
  const std::uint8_t* z_in = nullptr;  ///< ANDed to the zero flag
  std::ptrdiff_t c_stride = 0, s_stride = 0, z_stride = 0, z_in_stride = 0;
};

/// R := fn(P, Q, cin) and its flags; codes without a function give 0.
void run_alu(std::uint8_t fn, const AluRows& rows);

alignas(vectors::kWidth) extern const std::uint8_t kZeros[vectors::kWidth];
alignas(vectors::kWidth) extern const std::uint8_t kOnes[vectors::kWidth];  ///< masks that are all set

}  // namespace pixelflow
