#include "cmodel/pixelflow/native/functions.h"

#include <array>

#include "cmodel/pixelflow/native/arcsine.h"
#include "cmodel/pixelflow/native/arctangent.h"
#include "cmodel/pixelflow/native/exponential.h"
#include "cmodel/pixelflow/native/logarithm.h"
#include "cmodel/pixelflow/native/power.h"
#include "cmodel/pixelflow/native/trigonometry.h"

namespace pixelflow::native {
namespace {

// Free of branches, so that the compiler works a whole vector of arguments at a time.
#ifdef __clang__
#define PIXELFLOW_VECTORS
#else
#define PIXELFLOW_VECTORS _Pragma("GCC ivdep")
#endif
#define PIXELFLOW_UNARY(function)                                                         \
  void batch_##function(const uint32_t* x, uint32_t* result, std::size_t count) {         \
    PIXELFLOW_VECTORS for (std::size_t i = 0; i < count; ++i) result[i] = function(x[i]); \
  }
#define PIXELFLOW_BINARY(function)                                                                   \
  void batch_##function(const uint32_t* x, const uint32_t* y, uint32_t* result, std::size_t count) { \
    PIXELFLOW_VECTORS for (std::size_t i = 0; i < count; ++i) result[i] = function(x[i], y[i]);      \
  }

PIXELFLOW_UNARY(sin)
PIXELFLOW_UNARY(cos)
PIXELFLOW_UNARY(tan)
PIXELFLOW_UNARY(asin)
PIXELFLOW_UNARY(acos)
PIXELFLOW_UNARY(atan)
PIXELFLOW_UNARY(exp)
PIXELFLOW_UNARY(exp2)
PIXELFLOW_UNARY(log)
PIXELFLOW_UNARY(log2)
PIXELFLOW_UNARY(inversesqrt)
PIXELFLOW_UNARY(fast_sin)
PIXELFLOW_UNARY(fast_cos)
PIXELFLOW_UNARY(fast_tan)
PIXELFLOW_UNARY(fast_asin)
PIXELFLOW_UNARY(fast_acos)
PIXELFLOW_UNARY(fast_atan)
PIXELFLOW_UNARY(fast_exp)
PIXELFLOW_UNARY(fast_exp2)
PIXELFLOW_UNARY(fast_log)
PIXELFLOW_UNARY(fast_log2)
PIXELFLOW_BINARY(atan2)
PIXELFLOW_BINARY(fast_atan2)
PIXELFLOW_BINARY(pow)

}  // namespace

std::span<const UnaryFunction> unary_functions() {
  static constexpr std::array kFunctions = {
      UnaryFunction{"sin", batch_sin},
      UnaryFunction{"cos", batch_cos},
      UnaryFunction{"tan", batch_tan},
      UnaryFunction{"asin", batch_asin},
      UnaryFunction{"acos", batch_acos},
      UnaryFunction{"atan", batch_atan},
      UnaryFunction{"exp", batch_exp},
      UnaryFunction{"exp2", batch_exp2},
      UnaryFunction{"log", batch_log},
      UnaryFunction{"log2", batch_log2},
      UnaryFunction{"inversesqrt", batch_inversesqrt},
      UnaryFunction{"fast_sin", batch_fast_sin},
      UnaryFunction{"fast_cos", batch_fast_cos},
      UnaryFunction{"fast_tan", batch_fast_tan},
      UnaryFunction{"fast_asin", batch_fast_asin},
      UnaryFunction{"fast_acos", batch_fast_acos},
      UnaryFunction{"fast_atan", batch_fast_atan},
      UnaryFunction{"fast_exp", batch_fast_exp},
      UnaryFunction{"fast_exp2", batch_fast_exp2},
      UnaryFunction{"fast_log", batch_fast_log},
      UnaryFunction{"fast_log2", batch_fast_log2},
  };
  return kFunctions;
}

std::span<const BinaryFunction> binary_functions() {
  static constexpr std::array kFunctions = {
      BinaryFunction{"atan2", batch_atan2},
      BinaryFunction{"fast_atan2", batch_fast_atan2},
      BinaryFunction{"pow", batch_pow},
  };
  return kFunctions;
}

}  // namespace pixelflow::native
