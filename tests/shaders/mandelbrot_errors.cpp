// Prints the table of figure 4: wrong counts of iterations, float against fixed point, at several depths.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "tests/shaders/mandelbrot_counts.h"

int main(int argc, char** argv) {
  CLI::App app{"Iterations of the Mandelbrot set by the pixel processors against exact arithmetic"};
  shader_tests::MandelbrotView view;
  view.real = -0.101096391677856;
  view.imaginary = 0.956286549568176;
  view.pixels = 256;
  view.iterations = 250;
  int first = 4, last = 19, step = 3;
  app.add_option("--real", view.real, "Middle of the views, to 24 fraction bits")->capture_default_str();
  app.add_option("--imaginary", view.imaginary, "Middle of the views, to 24 fraction bits")->capture_default_str();
  app.add_option("--pixels", view.pixels, "A side")->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--iterations", view.iterations)->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--first", first, "Widths from 2^-FIRST")->check(CLI::Range(0, 24))->capture_default_str();
  app.add_option("--last", last, "to 2^-LAST")->check(CLI::Range(0, 24))->capture_default_str();
  app.add_option("--step", step)->check(CLI::Range(1, 24))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  // Both formats hold the middle exactly, so that all of the error is that of their arithmetic.
  view.real = std::ldexp(std::round(std::ldexp(view.real, 24)), -24);
  view.imaginary = std::ldexp(std::round(std::ldexp(view.imaginary, 24)), -24);

  fmt::print("Around {:.9f} + {:.9f} i, {} x {} pixels, at most {} iterations.\n\n", view.real, view.imaginary,
             view.pixels, view.pixels, view.iterations);
  fmt::print("| width of the view | float: wrong pixels | mean error | fixed: wrong pixels | mean error |\n");
  fmt::print("|---:|---:|---:|---:|---:|\n");
  const double all = static_cast<double>(view.pixels) * view.pixels;
  for (int depth = first; depth <= last; depth += step) {
    view.width = std::ldexp(1.0, -depth);
    const std::vector<int> exact = shader_tests::exact_counts(view);
    const auto floats = shader_tests::compare(shader_tests::counted("mandelbrot_float", view), exact);
    const auto fixed = shader_tests::compare(shader_tests::counted("mandelbrot_fixed", view), exact);
    fmt::print("| 2^-{} | {:.2f} % | {:.3f} | {:.2f} % | {:.3f} |\n", depth, 100 * floats.wrong / all,
               floats.mean_error, 100 * fixed.wrong / all, fixed.mean_error);
  }
  return 0;
}
