#include "tests/fields/random_field.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scanline/fields/operations.h"
#include "tests/fields/surface_oracle.h"

namespace fields_tests {
namespace {

namespace fields = scanline::fields;

RandomField random_solid(Random& random, bool with_planes) {
  const auto size = [&] { return between(random, 0.3, 1); };
  switch (std::uniform_int_distribution<int>(0, with_planes ? 5 : 4)(random)) {
    case 0: {
      const double r = size();
      return {fields::sphere(r), sphere_solid(r).is_inside, "sphere"};
    }
    case 1: {
      const glm::dvec3 s(size(), size(), size());
      return {fields::box(s), box_solid(s).is_inside, "box"};
    }
    case 2: {
      const double r = size(), thickness = r * between(random, 0.2, 0.9);
      return {fields::torus(r, thickness), torus_solid(r, thickness).is_inside, "torus"};
    }
    case 3: {
      const double r = size(), top = between(random, 0, 1), height = size();
      return {fields::frustum(r, top, height), frustum_solid(r, top, height).is_inside, "frustum"};
    }
    case 4: {
      const glm::dvec3 r(size(), size(), size());
      return {fields::ellipsoid(r), ellipsoid_solid(r).is_inside, "ellipsoid"};
    }
    default: {
      const glm::dvec3 n = vector_between(random, -1, 1);
      return {fields::plane(n), [=](const glm::dvec3& p) { return p.x * n.x + p.y * n.y + p.z * n.z < 0; }, "plane"};
    }
  }
}

RandomField placed(Random& random, const RandomField& part) {
  fields::Placement placement{vector_between(random, -0.7, 0.7), vector_between(random, -180, 180),
                              between(random, 0.5, 1.5)};
  if (random() % 4 == 0) placement.rotate = glm::dvec3(0, 90 * double(random() % 4), 0);
  glm::dmat4 m = glm::translate(glm::dmat4(1), placement.translate);
  m = glm::rotate(m, glm::radians(placement.rotate.z), glm::dvec3(0, 0, 1));
  m = glm::rotate(m, glm::radians(placement.rotate.y), glm::dvec3(0, 1, 0));
  m = glm::rotate(m, glm::radians(placement.rotate.x), glm::dvec3(1, 0, 0));
  m = glm::inverse(glm::scale(m, glm::dvec3(placement.scale)));
  RandomField result{fields::place(part.field, placement), nullptr, part.text};
  if (part.is_inside) {
    result.is_inside = [=, inside = part.is_inside](const glm::dvec3& p) { return inside(m * glm::dvec4(p, 1)); };
  }
  return result;
}

RandomField repeated(Random& random, const RandomField& part) {
  const scanline::Bounds box = part.field->bounds();
  const glm::dvec3 size = box.high - box.low;
  glm::dvec3 spacing(0);
  glm::ivec3 counts(0);
  for (int k = 0; k < 3; ++k) {
    if (random() % 2 == 0 || !std::isfinite(size[k])) continue;
    spacing[k] = size[k] * between(random, 0.3, 1.5);
    counts[k] = 1 + static_cast<int>(random() % 3);
  }
  RandomField result{fields::repeat(part.field, spacing, counts), nullptr, "repeat(" + part.text + ")"};
  if (!part.is_inside) return result;
  result.is_inside = [=, inside = part.is_inside](const glm::dvec3& p) {
    for (int x = 0; x < std::max(counts.x, 1); ++x) {
      for (int y = 0; y < std::max(counts.y, 1); ++y) {
        for (int z = 0; z < std::max(counts.z, 1); ++z) {
          glm::dvec3 q = p;
          for (int k = 0; k < 3; ++k) {
            const int number = k == 0 ? x : k == 1 ? y : z;
            if (counts[k] > 0) q[k] -= spacing[k] * (number - (counts[k] - 1) / 2.0);
          }
          if (inside(q)) return true;
        }
      }
    }
    return false;
  };
  return result;
}

}  // namespace

double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

glm::dvec3 vector_between(Random& random, double low, double high) {
  const double x = between(random, low, high), y = between(random, low, high);
  return {x, y, between(random, low, high)};
}

RandomField random_field(Random& random, int depth, bool with_planes) {
  if (depth == 0) return placed(random, random_solid(random, with_planes));
  const int kind = static_cast<int>(random() % 5);
  if (kind == 4) return placed(random, repeated(random, random_field(random, depth - 1, with_planes)));
  std::vector<RandomField> parts;
  std::vector<scanline::FieldPointer> pointers;
  std::string text;
  bool is_known = kind != 3;
  for (int k = 0; k < 2 + static_cast<int>(random() % 2); ++k) {
    // An intersection is bounded by its first part already; planes may cut off the rest.
    parts.push_back(random_field(random, depth - 1, with_planes || ((kind == 1 || kind == 2) && k > 0)));
    pointers.push_back(parts.back().field);
    text += (k == 0 ? "" : ", ") + parts.back().text;
    is_known &= static_cast<bool>(parts.back().is_inside);
  }
  RandomField result;
  static const char* const kNames[] = {"union", "intersection", "subtraction", "smooth_union"};
  result.text = std::string(kNames[kind]) + "(" + text + ")";
  switch (kind) {
    case 0: result.field = fields::join(pointers); break;
    case 1: result.field = fields::intersect(pointers); break;
    case 2: result.field = fields::subtract(pointers); break;
    default: result.field = fields::smooth_join(pointers, between(random, 0.05, 0.6)); break;
  }
  if (is_known) {
    result.is_inside = [=](const glm::dvec3& p) {
      bool any = false, all = true, others = false;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const bool inside = parts[k].is_inside(p);
        any |= inside;
        all &= inside;
        others |= inside && k > 0;
      }
      return kind == 0 ? any : kind == 1 ? all : parts[0].is_inside(p) && !others;
    };
  }
  return result;
}

}  // namespace fields_tests
