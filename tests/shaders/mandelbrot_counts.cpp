#include "tests/shaders/mandelbrot_counts.h"

#include <mpfr.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>

namespace shader_tests {
namespace {

/// MPFR's numbers of one precision, freed at the end.
class Numbers {
 public:
  explicit Numbers(int bits) : rounding_(std::ldexp(1.0, 6 - bits)) {
    for (auto& number : numbers_) mpfr_init2(number, bits);
  }
  ~Numbers() {
    for (auto& number : numbers_) mpfr_clear(number);
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  /// None where the precision does not suffice to decide a comparison: a bound of z's error goes along.
  std::optional<int> count(double real, double imaginary, int iterations) {
    auto& [cr, ci, zr, zi, r2, i2, sum] = numbers_;
    mpfr_set_d(cr, real, MPFR_RNDN);
    mpfr_set_d(ci, imaginary, MPFR_RNDN);
    mpfr_set_zero(zr, 1);
    mpfr_set_zero(zi, 1);
    double error = 0;
    for (int n = 0; n < iterations; ++n) {
      mpfr_sqr(r2, zr, MPFR_RNDN);
      mpfr_sqr(i2, zi, MPFR_RNDN);
      mpfr_add(sum, r2, i2, MPFR_RNDN);
      // |z| <= 6.6 where it is compared: all numbers of a step are below 64, and so is 2^6 times a rounding.
      const double reach = 2 * std::sqrt(mpfr_get_d(sum, MPFR_RNDU)) * error + error * error + rounding_;
      mpfr_sub_ui(sum, sum, 4, MPFR_RNDN);
      const double over = mpfr_get_d(sum, MPFR_RNDN);
      if (!(std::fabs(over) > 2 * reach)) return std::nullopt;
      if (over > 0) return n;
      mpfr_mul(zi, zr, zi, MPFR_RNDN);
      mpfr_mul_2ui(zi, zi, 1, MPFR_RNDN);
      mpfr_add(zi, zi, ci, MPFR_RNDN);
      mpfr_sub(zr, r2, i2, MPFR_RNDN);
      mpfr_add(zr, zr, cr, MPFR_RNDN);
      error = reach * (1 + 1e-9) + rounding_;
    }
    return iterations;
  }

 private:
  std::array<mpfr_t, 7> numbers_;
  double rounding_;
};

int exact_count(double real, double imaginary, int iterations) {
  for (int bits = 192;; bits *= 2) {
    Numbers numbers(bits);
    if (const auto count = numbers.count(real, imaginary, iterations)) return *count;
    // Points whose orbit meets the circle exactly would never be decided.
    if (bits > 1 << 16) throw std::runtime_error("a point of the Mandelbrot set cannot be decided");
  }
}

}  // namespace

std::vector<int> counted(const std::string& shader, const MandelbrotView& view) {
  const Compiled compiled = compile(shader);
  if (!compiled.said.empty()) throw std::logic_error(compiled.said);
  pfman::Instance instance(compiled.shader(), 1);
  pfman::TestSurface::make_ordinary(instance);
  instance.set("center", {view.real, view.imaginary});
  instance.set("scale", {view.width});
  instance.set("iterations", {static_cast<double>(view.iterations)});
  instance.set("plain", {1});
  const pfman::TestSurface scene({.width = view.pixels, .height = view.pixels});
  const auto array =
      pixelflow::make_golden_array(pixelflow::Level::Macro, pixelflow::kRegionWidth * pixelflow::kRegionHeight);
  const auto lanes = static_cast<std::size_t>(array->lanes());
  std::vector<int> counts(static_cast<std::size_t>(view.pixels) * static_cast<std::size_t>(view.pixels));
  for (int row = 0; row < view.pixels; row += pixelflow::kRegionHeight) {
    for (int column = 0; column < view.pixels; column += pixelflow::kRegionWidth) {
      const Shaded shaded = shade(scene, instance, {}, column, row, *array);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const int x = column + static_cast<int>(lane) % pixelflow::kRegionWidth;
        const int y = row + static_cast<int>(lane) / pixelflow::kRegionWidth;
        if (x >= view.pixels || y >= view.pixels) continue;
        counts[static_cast<std::size_t>(y * view.pixels + x)] = shaded.color[lane] + 256 * shaded.color[lanes + lane];
      }
    }
  }
  return counts;
}

std::vector<int> exact_counts(const MandelbrotView& view) {
  std::vector<int> counts;
  for (int row = 0; row < view.pixels; ++row) {
    for (int column = 0; column < view.pixels; ++column) {
      const double s = (column + 0.5) / view.pixels - 0.5, t = 0.5 - (row + 0.5) / view.pixels;
      counts.push_back(exact_count(view.real + view.width * s, view.imaginary + view.width * t, view.iterations));
    }
  }
  return counts;
}

CountErrors compare(const std::vector<int>& counts, const std::vector<int>& exact) {
  CountErrors errors;
  for (std::size_t n = 0; n < exact.size(); ++n) {
    errors.wrong += counts.at(n) != exact[n];
    errors.mean_error += std::abs(counts[n] - exact[n]);
  }
  errors.mean_error /= static_cast<double>(exact.size());
  return errors;
}

}  // namespace shader_tests
