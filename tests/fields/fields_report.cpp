// Prints the table of docs/fields.md: what extraction makes of solids, and how far that is from them.
#include <fmt/format.h>

#include <vector>

#include "scanline/fields/extraction.h"
#include "scanline/fields/field_error.h"
#include "scanline/fields/grid_field.h"
#include "scanline/fields/operations.h"

int main() {
  namespace fields = scanline::fields;
  using scanline::FieldPointer;
  const FieldPointer cube = fields::box(glm::dvec3(1)), hole = fields::frustum(0.3, 0.3, 2), ball = fields::sphere(0.5);
  const std::pair<const char*, FieldPointer> solids[] = {
      {"sphere", ball},
      {"torus, 0.5 and 0.15", fields::torus(0.5, 0.15)},
      {"ellipsoid, 0.5, 0.25, 0.125", fields::ellipsoid({0.5, 0.25, 0.125})},
      {"box", fields::box({1, 0.5, 0.25})},
      {"box, turned", fields::place(fields::box({1, 0.5, 0.25}), {{}, {10, 20, 30}, 1})},
      {"cylinder", fields::frustum(0.5, 0.5, 1)},
      {"cone", fields::frustum(0.5, 0, 1)},
      {"cube, drilled twice", fields::subtract({cube, hole, fields::place(hole, {{}, {90, 0, 0}, 1})})},
      {"two balls, blended over 0.3", fields::smooth_join({ball, fields::place(ball, {{0.6, 0, 0}, {}, 1})}, 0.3)},
      {"grid of 64 of the torus", fields::grid_field(*fields::torus(0.5, 0.15), 64)}};
  fmt::print(
      "| solid | cells | polygons | largest error | mean error | surface missed by |\n|---|---|---|---|---|---|\n");
  for (const auto& [name, field] : solids) {
    for (const int cells : {16, 32, 64, 128}) {
      const scanline::Mesh mesh = scanline::extract_surface(*field, cells);
      const scanline::FieldError error = scanline::measure(*field, mesh);
      // Rounding is no news.
      const auto shown = [](double value) { return value < 1e-12 ? std::string("0") : fmt::format("{:.1e}", value); };
      fmt::print("| {} | {} | {} | {} | {} | {} |\n", name, cells, mesh.polygons.size(), shown(error.largest),
                 shown(error.mean), shown(error.missed));
    }
  }
}
