// The mathematical functions on arrays of float32 bit patterns: the macro level's native versions, bit for bit what the
// microcode of pixelflow/microcode/functions computes. Any pattern is allowed; nothing fails. Results: NaN is
// 0x7FC00000. Accuracy and formats: docs/pixelflow_functions.md. Arrays may be the same, but must not overlap
// otherwise.
#ifndef VSG_CMODEL_PIXELFLOW_NATIVE_FUNCTIONS_H_
#define VSG_CMODEL_PIXELFLOW_NATIVE_FUNCTIONS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace pixelflow::native {

using UnaryBatch = void (*)(const uint32_t* x, uint32_t* result, std::size_t count);
using BinaryBatch = void (*)(const uint32_t* x, const uint32_t* y, uint32_t* result, std::size_t count);

struct UnaryFunction {
  std::string_view name;
  UnaryBatch batch;
};

struct BinaryFunction {
  std::string_view name;
  BinaryBatch batch;  // atan2: the first operand is y
};

// sin cos tan asin acos atan exp exp2 log log2 inversesqrt, then the fast versions.
std::span<const UnaryFunction> unary_functions();
// atan2 fast_atan2 pow
std::span<const BinaryFunction> binary_functions();

}  // namespace pixelflow::native

#endif
