// Figure 4 of Olano and Lastra 1998: iterations of the Mandelbrot set, from the pixel processors and exactly.
#pragma once

#include <vector>

#include "tests/shaders/region.h"

namespace shader_tests {

/// A square of the plane of complex numbers. Center and width must be exact in float.
struct MandelbrotView {
  double real = 0, imaginary = 0, width = 1;
  int pixels = 128;  ///< a side
  int iterations = 100;
};

/// Iterations that a shader of shaders/ counts, row by row from the top.
std::vector<int> counted(const std::string& shader, const MandelbrotView& view);

/// The same with so many bits that rounding cannot change a count: a bound of the error decides how many.
std::vector<int> exact_counts(const MandelbrotView& view);

struct CountErrors {
  int wrong = 0;          ///< pixels with another count
  double mean_error = 0;  ///< of all pixels, in iterations
};
CountErrors compare(const std::vector<int>& counts, const std::vector<int>& exact);

}  // namespace shader_tests
