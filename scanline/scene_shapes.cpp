#include "scanline/scene_shapes.h"

#include "scanline/fields/field_reader.h"
#include "scanline/mesh_reader.h"
#include "scanline/patches.h"
#include "scanline/polygon.h"
#include "scanline/shapes.h"
#include "scanline/terrain/terrain_reader.h"
#include "scanline/text_reader.h"

namespace scanline {
namespace {

constexpr int kMostSegments = 1024;
constexpr std::size_t kMostPoints = 1'000'000;

Box read_box(TomlTable& t) {
  Box box;
  box.size = t.vector_or_number("size", box.size, kPositive);
  // A top of no width would leave polygons without area; a ridge or a point is only nearly one.
  box.top = t.vector<2>("top", box.top, {0, 1e6, true});
  return box;
}

Mesh read_boxes(TomlTable& t) {
  std::vector<Box> boxes;
  if (!t.has("list")) t.missing("list");
  t.tables("list", "box", [&](TomlTable& entry) {
    boxes.push_back(read_box(entry));
    boxes.back().center = entry.vector<3>("center", {0, 0, 0});
  });
  if (boxes.empty() && t.has("list")) t.mistakes().add(t.where("list"), "'list' of shape boxes holds no box");
  return make_boxes(boxes);
}

Mesh read_plane(TomlTable& t) {
  const glm::dvec2 size = t.vector<2>("size", {1, 1}, kPositive);
  const glm::dvec2 divisions = t.vector<2>("divisions", {1, 1}, {1, kMostSegments});
  return make_plane(size, glm::ivec2(divisions));
}

Mesh read_sphere(TomlTable& t) {
  const double radius = t.number("radius", 0.5, kPositive);
  const int segments = t.integer("segments", 24, 3, kMostSegments);
  return make_sphere(radius, segments, t.integer("rings", 12, 2, kMostSegments));
}

Mesh read_cylinder(TomlTable& t) {
  const double radius = t.number("radius", 0.5, kPositive), height = t.number("height", 1, kPositive);
  return make_cone(radius, radius, height, t.integer("segments", 24, 3, kMostSegments));
}

Mesh read_cone(TomlTable& t) {
  const double radius = t.number("radius", 0.5, kPositive), top = t.number("top_radius", 0, kNotNegative);
  const double height = t.number("height", 1, kPositive);
  return make_cone(radius, top, height, t.integer("segments", 24, 3, kMostSegments));
}

Mesh read_tube(TomlTable& t) {
  const double radius = t.number("radius", 0.5, kPositive), inner = t.number("inner_radius", radius / 2, kPositive);
  const double height = t.number("height", 1, kPositive);
  const int segments = t.integer("segments", 24, 3, kMostSegments);
  if (inner >= radius) t.mistakes().add(t.where("inner_radius"), "'inner_radius' of a tube must be less than 'radius'");
  return make_tube(radius, inner, height, segments);
}

Mesh read_torus(TomlTable& t) {
  const double radius = t.number("radius", 0.5, kPositive), thickness = t.number("thickness", radius / 3, kPositive);
  const int segments = t.integer("segments", 32, 3, kMostSegments), sides = t.integer("sides", 16, 3, kMostSegments);
  if (thickness >= radius) t.mistakes().add(t.where("thickness"), "'thickness' of a torus must be less than 'radius'");
  return make_torus(radius, thickness, segments, sides);
}

Mesh read_prism(TomlTable& t) {
  if (!t.has("outline")) t.missing("outline");
  const auto numbers = t.numbers("outline", 6, kMostPoints);
  const double depth = t.number("depth", 1, kPositive);
  if (!numbers) return {};
  if (numbers->size() % 2 != 0) {
    t.mistakes().add(t.where("outline"), "'outline' of a prism must hold pairs of numbers: x, y, x, y...");
    return {};
  }
  std::vector<glm::dvec2> outline;
  std::vector<glm::dvec3> points;
  for (std::size_t k = 0; k < numbers->size(); k += 2) {
    outline.emplace_back((*numbers)[k], (*numbers)[k + 1]);
    points.emplace_back(outline.back(), 0);
  }
  if (!has_area(points)) t.mistakes().add(t.where("outline"), "'outline' of a prism encloses no area");
  return make_prism(outline, depth);
}

Mesh read_shape(TomlTable& t) {
  static const std::vector<std::string> names{"box",  "boxes", "plane", "sphere", "cylinder",
                                              "cone", "tube",  "torus", "prism"};
  using Reader = Mesh (*)(TomlTable&);
  static constexpr Reader readers[] = {[](TomlTable& box) { return make_boxes(std::vector<Box>{read_box(box)}); },
                                       read_boxes,
                                       read_plane,
                                       read_sphere,
                                       read_cylinder,
                                       read_cone,
                                       read_tube,
                                       read_torus,
                                       read_prism};
  const std::size_t shape = t.choice("shape", names, names.size());
  if (!t.has("shape")) t.missing("shape");
  if (shape == names.size()) {
    t.ignore_unknown();
    return {};
  }
  const std::size_t before = t.mistakes().list.size();
  Mesh mesh = readers[shape](t);
  if (mesh.polygons.empty() && t.mistakes().list.size() == before) {
    t.mistakes().add(t.where("shape"), "the " + names[shape] + " has no polygon with an area");
  }
  return mesh;
}

/// A file that the object names, read by `read`; mistakes in it are noted after the line that names it.
template <typename Read>
Mesh read_named_file(TomlTable& t, const std::filesystem::path& folder, Read read) {
  const std::string file = t.text("file", "");
  if (!t.has("file")) t.missing("file");
  if (file.empty()) return {};
  try {
    return read(folder / file);
  } catch (const UserError& e) {
    t.mistakes().add(t.where("file"), "cannot read '" + file + "'");
    t.mistakes().list.insert(t.mistakes().list.end(), e.diagnostics().begin(), e.diagnostics().end());
    return {};
  }
}

}  // namespace

Geometry read_geometry(TomlTable& object, const std::filesystem::path& folder) {
  static const std::vector<std::string> kinds{"mesh", "shape", "patches", "terrain", "field"};
  if (!object.has("geometry")) object.missing("geometry");
  switch (object.choice("geometry", kinds, kinds.size())) {
    case 0: return {read_named_file(object, folder, read_mesh_file), {}, {}};
    case 1: return {read_shape(object), {}, {}};
    case 2: {
      const int level = object.integer("level", 6, 1, 256);
      const auto read = [&](const std::filesystem::path& path) {
        return tessellate(read_patches(read_text_file(path), path.string()), level);
      };
      return {read_named_file(object, folder, read), {}, {}};
    }
    case 3: return read_terrain(object, folder);
    case 4: return read_field_geometry(object, folder);
    default: object.ignore_unknown(); return {};
  }
}

}  // namespace scanline
