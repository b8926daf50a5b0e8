#include "scanline/scene_frame.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <span>

#include "scanline/camera.h"
#include "scanline/clipper.h"
#include "scanline/polygon.h"

namespace scanline {
namespace {

/// Beyond this, products of coordinates would leave the doubles' range or lose the picture in rounding.
constexpr double kLargestCoordinate = 1e12;

/// Attributes of all objects by name; each object says which of its own goes where.
void declare_attributes(std::span<const Mesh* const> meshes, SceneFrame& result) {
  for (const Mesh* mesh : meshes) {
    for (const MeshAttribute& a : mesh->attributes) {
      const auto known = std::find_if(result.attributes.begin(), result.attributes.end(),
                                      [&](const FrameAttribute& f) { return f.name == a.name; });
      if (known == result.attributes.end()) {
        result.attributes.push_back({a.name, a.components, {}});
      } else {
        known->components = std::max(known->components, a.components);
      }
    }
  }
}

/// One object on its way into the frame.
class ObjectProcessor {
 public:
  ObjectProcessor(const Scene& scene, std::uint32_t index, const Mesh& mesh, const glm::dmat4& to_world,
                  const glm::dmat4& world_to_clip, SceneFrame& result)
      : object_(scene.objects[index]),
        mesh_(mesh),
        index_(index),
        result_(result),
        first_(first_corners(mesh_.polygons)) {
    const double determinant = glm::determinant(glm::dmat3(to_world));
    flat_ = determinant == 0;
    mirrored_ = determinant < 0;
    if (!flat_) transform(to_world, world_to_clip);
  }

  void run() {
    check_polygons();
    if (flat_) return;  // scaled to nothing at this moment
    std::vector<double> corners = corner_values();
    Clipper clipper(std::move(clip_), world_, std::move(corners), stride_);
    numbers_.assign(clipper.vertex_count(), 0);
    for (std::uint32_t p = 0; p < mesh_.polygons.size(); ++p) {
      const std::vector<ClipLoop>& loops = clipper.clip(mesh_.polygons[p], first_[p]);
      if (loops.empty()) continue;
      numbers_.resize(clipper.vertex_count(), 0);
      const glm::dvec3 normal = world_normal(p);
      for (const ClipLoop& loop : loops) add_polygon(clipper, loop, p, normal);
    }
  }

 private:
  void transform(const glm::dmat4& to_world, const glm::dmat4& world_to_clip) {
    normal_matrix_ = glm::transpose(glm::inverse(glm::dmat3(to_world)));
    world_.reserve(mesh_.positions.size());
    clip_.reserve(mesh_.positions.size());
    for (const glm::dvec3& position : mesh_.positions) {
      const glm::dvec3 world(to_world * glm::dvec4(position, 1));
      const glm::dvec4 clip = world_to_clip * glm::dvec4(world, 1);
      for (int k = 0; k < 4; ++k) {
        // The comparison is false for what is not a number, too.
        if (std::abs(clip[k]) <= kLargestCoordinate && std::abs(world[k % 3]) <= kLargestCoordinate) continue;
        throw UserError({object_.file, object_.line, 0,
                         "object '" + object_.name + "': a vertex lies outside the range of numbers (1e12)"});
      }
      world_.push_back(world);
      clip_.push_back(clip);
    }
  }

  /// All attributes of corner 0, then of corner 1...; normals already in world space.
  std::vector<double> corner_values() {
    const std::vector<MeshAttribute>& attributes = mesh_.attributes;
    stride_ = 0;
    sources_.assign(result_.attributes.size(), {});
    for (const MeshAttribute& a : attributes) {
      for (std::size_t k = 0; k < sources_.size(); ++k) {
        if (result_.attributes[k].name == a.name) sources_[k] = {stride_, a.components};
      }
      stride_ += a.components;
    }
    std::vector<double> values(std::size_t{first_.back()} * static_cast<std::size_t>(stride_));
    std::size_t offset = 0;
    for (const MeshAttribute& a : attributes) {
      const auto n = static_cast<std::size_t>(a.components);
      for (std::size_t c = 0; c < first_.back(); ++c) {
        double* to = &values[c * static_cast<std::size_t>(stride_) + offset];
        std::copy_n(&a.values[c * n], n, to);
        if (a.name == "normal" && n == 3) {
          const glm::dvec3 normal = normal_matrix_ * glm::dvec3(to[0], to[1], to[2]);
          for (int k = 0; k < 3; ++k) to[k] = normal[k];
        }
      }
      offset += n;
    }
    return values;
  }

  glm::dvec3 world_normal(std::uint32_t polygon) {
    points_.clear();
    for (const std::uint32_t v : mesh_.polygons[polygon]) points_.push_back(world_[v]);
    const glm::dvec3 normal = newell_vector(points_);
    const double length = glm::length(normal) * (mirrored_ ? -1 : 1);
    return length == 0 ? glm::dvec3(0) : normal / length;
  }

  /// The frame's number of a vertex, which it gets when a polygon first uses it.
  std::uint32_t number(const Clipper& clipper, std::uint32_t vertex) {
    if (numbers_[vertex] != 0) return numbers_[vertex];
    const glm::dvec4& p = clipper.position(vertex);
    const double width = result_.frame.width - 2, height = result_.frame.height - 1;
    // Rounding may leave the border by the last bit: the frame file's ranges are kept exactly.
    const auto on_screen = [&](double value, double size, double low) {
      return std::clamp(low + size * (value / p.w + 1) / 2, low, low + size);
    };
    result_.frame.vertices.push_back(
        {on_screen(p.x, width, 1.5), on_screen(p.y, height, 0.5), on_screen(p.z, kDepthRange, 0)});
    result_.world.push_back(clipper.world(vertex));
    result_.w.push_back(p.w);
    return numbers_[vertex] = static_cast<std::uint32_t>(result_.frame.vertices.size());
  }

  void add_polygon(const Clipper& clipper, const ClipLoop& loop, std::uint32_t polygon, const glm::dvec3& normal) {
    // Counter-clockwise in front becomes clockwise; in a mirrored object it already is.
    ClipLoop& kept = kept_;
    kept.clear();
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) kept.push_back(loop[mirrored_ ? k : (n - k) % n]);
    const auto same_place = [&](const ClipCorner& a, const ClipCorner& b) {
      const FrameVertex &p = result_.frame.vertices[number(clipper, a.vertex) - 1],
                        &q = result_.frame.vertices[number(clipper, b.vertex) - 1];
      return p.x == q.x && p.y == q.y && p.z == q.z;
    };
    for (const ClipCorner& c : kept) number(clipper, c.vertex);
    kept.erase(std::unique(kept.begin(), kept.end(), same_place), kept.end());
    while (kept.size() > 1 && same_place(kept.front(), kept.back())) kept.pop_back();
    if (kept.size() < 3) return;

    std::vector<std::uint32_t>& numbers = result_.frame.polygons.emplace_back();
    numbers.reserve(kept.size());
    for (const ClipCorner& c : kept) {
      numbers.push_back(numbers_[c.vertex]);
      add_corner(stride_ > 0 ? clipper.corner(c.corner) : std::span<const double>{});
    }
    result_.polygons.push_back({index_, polygon, normal});
  }

  void add_corner(std::span<const double> values) {
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      FrameAttribute& to = result_.attributes[k];
      const auto begin = values.begin() + sources_[k].offset;
      to.values.insert(to.values.end(), begin, begin + sources_[k].components);
      to.values.insert(to.values.end(), static_cast<std::size_t>(to.components - sources_[k].components), 0.0);
    }
  }

  /// Chapter V: points of a polygon should lie on a plane and its edges never cross. In object space, as neither
  /// depends on the view.
  void check_polygons() {
    std::size_t crossing = 0, first_crossing = 0, uneven = 0, first_uneven = 0;
    const PolygonList& polygons = mesh_.polygons;
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      if (polygons[p].size() < 4) continue;
      points_.clear();
      for (const std::uint32_t v : polygons[p]) points_.push_back(mesh_.positions[v]);
      if (unevenness(points_) > kPlanarTolerance && uneven++ == 0) first_uneven = p + 1;
      if (crosses_itself(points_) && crossing++ == 0) first_crossing = p + 1;
    }
    warn(crossing, first_crossing, "crosses itself", "cross themselves");
    warn(uneven, first_uneven, "is not planar", "are not planar");
  }

  void warn(std::size_t count, std::size_t first, const char* one, const char* many) {
    if (count == 0) return;
    const std::string subject = "object '" + object_.name + "': polygon ";
    const std::string text = count == 1 ? std::to_string(first) + " " + one
                                        : std::to_string(first) + " and " + std::to_string(count - 1) + " more " + many;
    result_.warnings.push_back({object_.file, object_.line, 0, subject + text});
  }

  /// Where a frame's attribute stands among the values of this object's corners; no components: it has none.
  struct Source {
    int offset = 0, components = 0;
  };

  const Object& object_;
  const Mesh& mesh_;
  std::uint32_t index_;
  SceneFrame& result_;
  std::vector<std::uint32_t> first_;
  bool flat_ = false, mirrored_ = false;
  glm::dmat3 normal_matrix_{1};
  std::vector<glm::dvec3> world_, points_;
  std::vector<glm::dvec4> clip_;
  ClipLoop kept_;
  int stride_ = 0;
  std::vector<Source> sources_;         ///< one a frame attribute
  std::vector<std::uint32_t> numbers_;  ///< of the frame's vertices, from 1; 0: not used so far
};

Viewer viewer_of(const Camera& camera, const glm::dmat4& to_world, int height) {
  const glm::dmat4 to_object = glm::inverse(to_world);
  Viewer viewer;
  viewer.perspective = camera.projection == Projection::kPerspective;
  viewer.position = glm::dvec3(to_object * glm::dvec4(camera.position, 1));
  viewer.pixel_angle = 2 * std::tan(glm::radians(camera.field_of_view) / 2) / height;
  // An object that is scaled unevenly is looked at along its largest scale.
  const glm::dmat3 axes(to_world);
  const double scale = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  viewer.pixel_size = camera.height / height / scale;
  return viewer;
}

}  // namespace

SceneFrame make_scene_frame(const Scene& scene, double moment, int width, int height) {
  if (width < 1 || height < 1 || width > kMostPictureWidth || height > kMostPictureHeight) {
    throw UserError({"", 0, 0,
                     "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                         " is not possible: it is at least 1 x 1 and at most " + std::to_string(kMostPictureWidth) +
                         " x " + std::to_string(kMostPictureHeight)});
  }
  SceneFrame result;
  result.frame.width = width + 2;
  result.frame.height = height + 1;
  const Camera camera = camera_at(scene, moment);
  const std::string fault = camera_fault(camera);
  if (!fault.empty()) throw UserError({"", 0, 0, "frame " + std::to_string(moment) + ": " + fault});
  const glm::dmat4 world_to_clip = camera_matrix(camera, static_cast<double>(width) / height);

  std::vector<glm::dmat4> to_world;
  std::deque<Mesh> made;
  std::vector<const Mesh*> meshes;
  for (const Object& object : scene.objects) {
    to_world.push_back(object_matrix(object.keys, moment));
    if (object.source && glm::determinant(glm::dmat3(to_world.back())) != 0) {
      made.push_back(object.source->mesh(viewer_of(camera, to_world.back(), height)));
      meshes.push_back(&made.back());
    } else {
      meshes.push_back(&object.mesh);
    }
  }
  declare_attributes(meshes, result);
  for (std::uint32_t k = 0; k < scene.objects.size(); ++k) {
    ObjectProcessor(scene, k, *meshes[k], to_world[k], world_to_clip, result).run();
  }
  result.first_corner = first_corners(result.frame.polygons);
  return result;
}

}  // namespace scanline
