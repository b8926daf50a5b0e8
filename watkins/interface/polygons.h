// Polygons as a program draws them: current values become attributes of corners (Olano and Lastra 1998, section 4.2).
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scanline/mesh.h"
#include "watkins/interface/instances.h"
#include "watkins/interface/matrices.h"

namespace watkins {

/// The current values of ordinary parameters, by name: OpenGL's global state.
class MaterialState {
 public:
  void set(const std::string& parameter, Values values) { values_[parameter] = std::move(values); }
  /// As many numbers as the parameter has, but all that are set for px_shader_texcoord; its default, or OpenGL's first
  /// value, where nothing has been set. Throws Error where the current value is of another length.
  Values value(const LoadedParameter& parameter) const;

 private:
  std::map<std::string, Values> values_;
};

/// The polygons of a frame, in the world: a mesh for each run of polygons of the same instance.
class Polygons {
 public:
  struct Run {
    std::size_t instance = 0;
    scanline::MeshBuilder builder;
  };

  bool is_open() const { return open_.has_value(); }
  bool empty() const { return runs_.empty(); }
  bool shows(std::size_t instance) const;

  /// The calls throw Error where they are out of place.
  void begin(std::size_t instance, const SurfaceInstance& surface);
  void vertex(const glm::dvec3& position, const Matrices& matrices, const MaterialState& state);
  void end();

  /// The frame's polygons, which are then no longer here.
  std::vector<Run> take();

 private:
  struct Open {
    std::size_t instance;
    std::vector<const LoadedParameter*> parameters;
    std::vector<glm::dvec3> positions;
    std::vector<double> corners;
  };
  std::optional<Open> open_;
  std::vector<Run> runs_;
};

}  // namespace watkins
