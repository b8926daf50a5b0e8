// Shaders of the project on a part of a region, for tests: compiled, shown on a test surface, shaded.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/compile.h"
#include "pixelflow/shading/shading_node.h"
#include "pixelflow/shading/test_surface.h"

namespace shader_tests {

/// Names of all files of shaders/, without their suffix, in alphabetical order.
std::vector<std::string> shader_files();

struct Compiled {
  std::unique_ptr<pfman::CompiledUnit> unit;
  std::string said;  ///< every error and warning
  const pfman::CompiledShader& shader() const { return unit->shaders.front(); }
};
Compiled compile(const std::string& name, const pfman::Options& options = {});

/// What a shape's pixels hold after shading.
struct Shaded {
  std::vector<std::uint8_t> ids, color;  ///< of every element; three colours each, component after component
  pfman::ShadingNode::Cycles cycles;
  pixelflow::ArrayCounters counters;
};

/// `instance` must have the ID 1 to 255. Rows of `region_row` on in the picture of `view`, as many as the array has.
Shaded shade(const pfman::TestSurface& scene, pfman::Instance instance, const std::vector<pfman::Instance>& lights,
             int first_column, int first_row, pixelflow::PixelArray& array);

}  // namespace shader_tests
