#include "scanline/fields/field_reader.h"

#include <sstream>

#include "scanline/fields/extraction.h"
#include "scanline/fields/geometry.h"
#include "scanline/fields/grid_field.h"
#include "scanline/fields/mesh_field.h"
#include "scanline/fields/operations.h"
#include "scanline/fields/primitives.h"
#include "scanline/mesh_reader.h"

namespace scanline {
namespace {

constexpr int kUsualCells = 64;
constexpr int kDeepest = 32;
constexpr int kMostNodes = 4096;
/// Lengths of a field; their ratios stay such that doubles can tell the small from the large.
constexpr Range kLength{1e-6, 1e6};
constexpr Range kLengthOrNone{0, 1e6};
constexpr Range kPlace{-1e9, 1e9};

/// `[[x, y, z], [x, y, z]]`; nothing when missing or wrong.
std::optional<Bounds> read_bounds(TomlTable& t) {
  const toml::node* node = t.node("bounds");
  if (!node) return std::nullopt;
  const auto number = [](const toml::node& n) {
    const auto value = n.is_number() ? n.value<double>() : std::nullopt;
    return value && std::abs(*value) <= kPlace.high ? value : std::nullopt;
  };
  Bounds box;
  const toml::array* rows = node->as_array();
  bool is_right = rows && rows->size() == 2;
  for (std::size_t r = 0; is_right && r < 2; ++r) {
    const toml::array* row = (*rows)[r].as_array();
    is_right = row && row->size() == 3;
    for (int k = 0; is_right && k < 3; ++k) {
      const auto value = number((*row)[static_cast<std::size_t>(k)]);
      is_right = value.has_value();
      if (value) (r == 0 ? box.low : box.high)[k] = *value;
    }
  }
  if (is_right && glm::all(glm::greaterThanEqual(box.high - box.low, glm::dvec3(kLength.low)))) return box;
  t.mistakes().add(node->source(), "'bounds' of a field must be [[x, y, z], [x, y, z]], the lower corner first");
  return std::nullopt;
}

/// A box without size is nothing's: that the field has no surface is found out later.
bool is_measurable(const Bounds& box) {
  const glm::dvec3 size = box.high - box.low, farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
  const double longest = std::max({size.x, size.y, size.z});
  return (longest >= 1e-9 || longest == 0) && std::max({farthest.x, farthest.y, farthest.z}) <= 1e12;
}

class FieldReader {
 public:
  FieldReader(TomlMistakes& mistakes, const std::filesystem::path& folder) : mistakes_(mistakes), folder_(folder) {}

  /// Nothing when something is wrong with it or what it is made of.
  FieldPointer read(TomlTable& t, int depth) {
    const std::size_t before = mistakes_.list.size();
    if (++nodes_ == kMostNodes + 1) {
      mistakes_.add(t.where(), "a field has more than " + std::to_string(kMostNodes) + " parts");
    }
    if (depth > kDeepest) {
      mistakes_.add(t.where(), "a field is nested more than " + std::to_string(kDeepest) + " levels deep");
    }
    if (mistakes_.list.size() != before || nodes_ > kMostNodes) {
      t.ignore_unknown();
      return nullptr;
    }
    static const std::vector<std::string> kinds{"sphere",       "box",         "plane",        "torus",  "cylinder",
                                                "cone",         "ellipsoid",   "triangle",     "mesh",   "union",
                                                "intersection", "subtraction", "smooth_union", "repeat", "grid"};
    using Read = FieldPointer (FieldReader::*)(TomlTable&, int);
    static constexpr Read readers[] = {
        &FieldReader::read_sphere,       &FieldReader::read_box,          &FieldReader::read_plane,
        &FieldReader::read_torus,        &FieldReader::read_cylinder,     &FieldReader::read_cone,
        &FieldReader::read_ellipsoid,    &FieldReader::read_triangle,     &FieldReader::read_mesh,
        &FieldReader::read_union,        &FieldReader::read_intersection, &FieldReader::read_subtraction,
        &FieldReader::read_smooth_union, &FieldReader::read_repeat,       &FieldReader::read_grid};
    if (!t.has("kind")) t.missing("kind");
    const std::size_t kind = t.choice("kind", kinds, kinds.size());
    if (kind == kinds.size()) {
      t.ignore_unknown();
      return nullptr;
    }
    FieldPointer field = (this->*readers[kind])(t, depth);
    fields::Placement placement;
    placement.translate = t.vector<3>("translate", placement.translate, kPlace);
    placement.rotate = t.vector<3>("rotate", placement.rotate);
    placement.scale = t.number("scale", placement.scale, kLength);
    return mistakes_.list.size() == before ? fields::place(std::move(field), placement) : nullptr;
  }

 private:
  FieldPointer read_sphere(TomlTable& t, int) { return fields::sphere(t.number("radius", 0.5, kLength)); }

  FieldPointer read_box(TomlTable& t, int) {
    const glm::dvec3 size = t.vector_or_number("size", glm::dvec3(1), kLength);
    const double round = t.number("round", 0, kLengthOrNone);
    if (round > std::min({size.x, size.y, size.z}) / 2) {
      mistakes_.add(t.where("round"), "'round' of a box must be at most half its smallest side");
    }
    return fields::box(size, round);
  }

  FieldPointer read_plane(TomlTable& t, int) {
    const glm::dvec3 normal = t.vector<3>("normal", {0, 1, 0}, kPlace);
    if (normal == glm::dvec3(0)) mistakes_.add(t.where("normal"), "'normal' of a plane has no length");
    return fields::plane(normal);
  }

  FieldPointer read_torus(TomlTable& t, int) {
    const double radius = t.number("radius", 0.5, kLength), thickness = t.number("thickness", radius / 3, kLength);
    if (thickness >= radius) mistakes_.add(t.where("thickness"), "'thickness' of a torus must be less than 'radius'");
    return fields::torus(radius, thickness);
  }

  FieldPointer read_cylinder(TomlTable& t, int) {
    const double radius = t.number("radius", 0.5, kLength);
    return fields::frustum(radius, radius, t.number("height", 1, kLength));
  }

  FieldPointer read_cone(TomlTable& t, int) {
    const double radius = t.number("radius", 0.5, kLength), top = t.number("top_radius", 0, kLengthOrNone);
    return fields::frustum(radius, top, t.number("height", 1, kLength));
  }

  FieldPointer read_ellipsoid(TomlTable& t, int) {
    if (!t.has("radii")) t.missing("radii");
    return fields::ellipsoid(t.vector<3>("radii", glm::dvec3(0.5), kLength));
  }

  FieldPointer read_triangle(TomlTable& t, int) {
    std::array<glm::dvec3, 3> corners{};
    static constexpr const char* kNames[] = {"a", "b", "c"};
    for (int k = 0; k < 3; ++k) {
      if (!t.has(kNames[k])) t.missing(kNames[k]);
      corners[k] = t.vector<3>(kNames[k], glm::dvec3(0), {-1e6, 1e6});
    }
    return fields::triangle(corners, t.number("thickness", 0.05, kLength));
  }

  FieldPointer read_mesh(TomlTable& t, int) {
    const std::string file = t.text("file", "");
    if (!t.has("file")) t.missing("file");
    if (file.empty()) return nullptr;
    try {
      const Mesh mesh = read_mesh_file(folder_ / file);
      const std::string fault = fields::mesh_fault(mesh);
      if (fault.empty()) return fields::mesh_field(mesh);
      mistakes_.add(t.where("file"), "'" + file + "' cannot be a field: " + fault);
    } catch (const UserError& e) {
      mistakes_.add(t.where("file"), "cannot read '" + file + "'");
      mistakes_.list.insert(mistakes_.list.end(), e.diagnostics().begin(), e.diagnostics().end());
    }
    return nullptr;
  }

  std::vector<FieldPointer> read_parts(TomlTable& t, int depth, std::size_t least) {
    std::vector<FieldPointer> parts;
    if (!t.has("of")) t.missing("of");
    const std::size_t before = mistakes_.list.size();
    t.tables("of", "field", [&](TomlTable& part) {
      // A part with mistakes is replaced, so that the others are read as well.
      FieldPointer field = read(part, depth + 1);
      parts.push_back(field ? std::move(field) : fields::sphere(1));
    });
    if (t.has("of") && parts.size() < least && mistakes_.list.size() == before) {
      mistakes_.add(t.where("of"), least == 1 ? "'of' holds no field" : "'of' must hold two fields or more");
    }
    if (parts.empty()) parts.push_back(fields::sphere(1));
    return parts;
  }

  FieldPointer read_union(TomlTable& t, int depth) { return fields::join(read_parts(t, depth, 1)); }
  FieldPointer read_intersection(TomlTable& t, int depth) { return fields::intersect(read_parts(t, depth, 1)); }
  FieldPointer read_subtraction(TomlTable& t, int depth) { return fields::subtract(read_parts(t, depth, 2)); }

  FieldPointer read_smooth_union(TomlTable& t, int depth) {
    if (!t.has("radius")) t.missing("radius");
    const double radius = t.number("radius", 1, kLength);
    return fields::smooth_join(read_parts(t, depth, 1), radius);
  }

  /// The one field that another is made of.
  FieldPointer read_part(TomlTable& t, int depth) {
    if (!t.has("of")) t.missing("of");
    FieldPointer field;
    if (auto part = t.table("of", "field")) {
      field = read(*part, depth + 1);
      part->finish();
    }
    return field ? field : fields::sphere(1);
  }

  FieldPointer read_repeat(TomlTable& t, int depth) {
    const std::size_t before = mistakes_.list.size();
    FieldPointer part = read_part(t, depth);
    if (!t.has("spacing")) t.missing("spacing");
    const glm::dvec3 spacing = t.vector<3>("spacing", glm::dvec3(0), kLengthOrNone);
    const glm::dvec3 counts = t.vector<3>("count", glm::dvec3(0), {0, 1e6});
    if (counts != glm::floor(counts)) mistakes_.add(t.where("count"), "'count' of a repeat must be whole numbers");
    if (mistakes_.list.size() != before) return part;
    if (spacing == glm::dvec3(0)) mistakes_.add(t.where("spacing"), "'spacing' of a repeat is 0 along all axes");
    const Bounds box = part->bounds();
    for (int k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      if (spacing[k] == 0 && counts[k] > 1) {
        mistakes_.add(t.where("count"), "'count' of a repeat asks for copies along " + axis + ", where 'spacing' is 0");
      }
      if (spacing[k] == 0) continue;
      const double size = box.high[k] - box.low[k];
      if (!std::isfinite(size)) {
        mistakes_.add(t.where("of"), "what is repeated along " + axis + " is infinite there");
      } else if (size > fields::kMostOverlap * spacing[k]) {
        mistakes_.add(t.where("spacing"),
                      "'spacing' of a repeat along " + axis + " is less than a quarter of what is repeated");
      }
    }
    if (mistakes_.list.size() != before) return part;
    return fields::repeat(std::move(part), spacing, glm::ivec3(counts));
  }

  FieldPointer read_grid(TomlTable& t, int depth) {
    const std::size_t before = mistakes_.list.size();
    FieldPointer part = read_part(t, depth);
    const int cells = t.integer("cells", 64, 2, fields::kMostGridCells);
    const std::optional<Bounds> bounds = read_bounds(t);
    if (mistakes_.list.size() != before) return part;
    if (bounds) part = fields::intersect({part, fields::box(*bounds)});
    if (is_finite(part->bounds())) {
      if (is_measurable(part->bounds())) return fields::grid_field(*part, cells);
      mistakes_.add(t.where("of"), "what a grid is made of is larger than 1e12, or smaller than 1e-9");
      return part;
    }
    mistakes_.add(t.where("of"), "what a grid is made of is infinite: the grid needs the key 'bounds'");
    return part;
  }

  TomlMistakes& mistakes_;
  const std::filesystem::path& folder_;
  int nodes_ = 0;
};

Mesh polygons(TomlTable& object, const Field& field, int cells) {
  Mesh mesh;
  try {
    mesh = extract_surface(field, cells);
    if (!mesh.polygons.empty()) return mesh;
    object.mistakes().add(object.where("field"), "the field has no surface that its cells would show");
  } catch (const UserError& e) {
    object.mistakes().add(object.where("field"), e.diagnostics()[0].message);
  }
  return mesh;
}

Mesh polygons_within(TomlTable& object, const Field& field, double error) {
  MeasuredSurface surface = extract_within(field, error);
  std::ostringstream message;
  if (surface.mesh.polygons.empty()) {
    message << "the field has no surface that cells would show";
  } else if (!(surface.error.worst() <= error)) {
    message << "the polygons come no nearer to the field than " << surface.error.worst() << ", with " << surface.cells
            << " cells and " << surface.mesh.polygons.size() << " polygons";
  } else {
    return std::move(surface.mesh);
  }
  object.mistakes().add(object.where("error"), message.str());
  return {};
}

}  // namespace

Geometry read_field_geometry(TomlTable& object, const std::filesystem::path& folder) {
  TomlMistakes& mistakes = object.mistakes();
  const std::size_t before = mistakes.list.size();
  FieldPointer field;
  if (!object.has("field")) object.missing("field");
  if (auto table = object.table("field", "field")) {
    field = FieldReader(mistakes, folder).read(*table, 1);
    table->finish();
  }
  const std::optional<Bounds> bounds = read_bounds(object);
  const int cells = object.integer("cells", kUsualCells, kFewestCells, kMostCells);
  const double error = object.number("error", 0, kLength);
  if (object.has("cells") && object.has("error")) {
    mistakes.add(object.where("error"), "a field has either 'cells' or 'error'");
  }
  if (mistakes.list.size() != before || !field) return {};
  // The field itself ends at its bounds, so that its surface is the polygons' everywhere.
  if (bounds) field = fields::intersect({field, fields::box(*bounds)});
  if (!is_finite(field->bounds())) {
    mistakes.add(object.where("field"), "this field is infinite: the object needs the key 'bounds'");
    return {};
  }
  if (!is_measurable(field->bounds())) {
    mistakes.add(object.where("field"), "this field is larger than 1e12, or smaller than 1e-9");
    return {};
  }
  Mesh mesh = object.has("error") ? polygons_within(object, *field, error) : polygons(object, *field, cells);
  if (mistakes.list.size() != before) return {};
  return {std::move(mesh), {}, std::move(field)};
}

}  // namespace scanline
