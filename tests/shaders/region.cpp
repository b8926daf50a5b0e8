#include "tests/shaders/region.h"

#include <algorithm>
#include <filesystem>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/shading/test_textures.h"

namespace shader_tests {

std::vector<std::string> shader_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PFMAN_SHADERS)) {
    if (entry.path().extension() == ".pfman") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Compiled compile(const std::string& name, const pfman::Options& options) {
  pfman::Diagnostics diagnostics;
  Compiled compiled;
  compiled.unit = pfman::compile_file(std::string(PFMAN_SHADERS) + "/" + name + ".pfman", options, diagnostics);
  compiled.said = diagnostics.text();
  return compiled;
}

Shaded shade(const pfman::TestSurface& scene, pfman::Instance instance, const std::vector<pfman::Instance>& lights,
             int first_column, int first_row, pixelflow::PixelArray& array) {
  static const pfman::TextureMemory textures = pfman::test_textures();
  scene.place(instance);
  pfman::ShadingNode node({instance}, lights, &textures);
  scene.fill(instance, first_column, first_row, array);
  node.shade(array);
  const auto lanes = static_cast<std::size_t>(array.lanes());
  Shaded shaded{std::vector<std::uint8_t>(lanes), std::vector<std::uint8_t>(3 * lanes), node.cycles(),
                array.counters()};
  array.read(pfman::kShaderIdAt, shaded.ids);
  for (std::size_t n = 0; n < 3; ++n)
    array.read(pfman::kColorAt + static_cast<int>(n), std::span(shaded.color).subspan(n * lanes, lanes));
  return shaded;
}

}  // namespace shader_tests
