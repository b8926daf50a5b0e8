#include "watkins/interface/polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace watkins {
namespace {

const std::string kTexCoord = "px_shader_texcoord";

/// Attributes have their parameters' names; those that files of meshes know by another name have that.
std::string attribute_name(const Parameter& parameter) {
  if (parameter.name == "px_material_normal" && parameter.count == 3) return "normal";
  if (parameter.name == kTexCoord && parameter.count == 2) return "uv";
  return parameter.name;
}

std::vector<scanline::MeshBuilder::Attribute> attributes(const std::vector<const LoadedParameter*>& parameters) {
  std::vector<scanline::MeshBuilder::Attribute> result;
  for (const LoadedParameter* p : parameters) result.push_back({attribute_name(p->said), p->said.count});
  return result;
}

}  // namespace

Values MaterialState::value(const LoadedParameter& parameter) const {
  const Parameter& said = parameter.said;
  const auto current = values_.find(said.name);
  if (current == values_.end()) return said.defaults.empty() ? initial_value(said) : said.defaults;
  const auto count = static_cast<std::size_t>(said.count);
  if (current->second.size() != count && said.name != kTexCoord) {
    throw Error("parameter '" + said.name + "' has " + std::to_string(count) +
                " number(s) here, and its current value " + std::to_string(current->second.size()));
  }
  return current->second;
}

bool Polygons::shows(std::size_t instance) const {
  return std::any_of(runs_.begin(), runs_.end(), [&](const Run& run) { return run.instance == instance; });
}

void Polygons::begin(std::size_t instance, const SurfaceInstance& surface) {
  if (open_) throw Error("begin within begin and end");
  open_ = Open{instance, surface.ordinary(), {}, {}};
}

void Polygons::vertex(const glm::dvec3& position, const Matrices& matrices, const MaterialState& state) {
  if (!open_) throw Error("vertex outside of begin and end");
  const glm::dvec4 moved = matrices.model() * glm::dvec4(position, 1);
  const glm::dvec3 world = glm::dvec3(moved) / moved.w;
  if (!std::isfinite(world.x) || !std::isfinite(world.y) || !std::isfinite(world.z)) {
    throw Error("a vertex lies outside the range of numbers");
  }
  std::vector<double> corner;
  for (const LoadedParameter* parameter : open_->parameters) {
    // Of texture coordinates a shader may take fewer than the four that the matrix needs.
    Values values = matrices.transform(state.value(*parameter), parameter->transform);
    values.resize(static_cast<std::size_t>(parameter->said.count), 0.0);
    corner.insert(corner.end(), values.begin(), values.end());
  }
  open_->positions.push_back(world);
  open_->corners.insert(open_->corners.end(), corner.begin(), corner.end());
}

void Polygons::end() {
  if (!open_) throw Error("end without begin");
  const Open polygon = *std::exchange(open_, std::nullopt);
  if (polygon.positions.size() < 3) {
    throw Error("a polygon has three or more vertices, not " + std::to_string(polygon.positions.size()));
  }
  if (runs_.empty() || runs_.back().instance != polygon.instance) {
    runs_.push_back({polygon.instance, scanline::MeshBuilder(attributes(polygon.parameters))});
  }
  scanline::MeshBuilder& builder = runs_.back().builder;
  std::vector<std::uint32_t> vertices;
  for (const glm::dvec3& position : polygon.positions) vertices.push_back(builder.vertex(position));
  builder.polygon(vertices, polygon.corners);
}

std::vector<Polygons::Run> Polygons::take() {
  open_.reset();
  return std::exchange(runs_, {});
}

}  // namespace watkins
