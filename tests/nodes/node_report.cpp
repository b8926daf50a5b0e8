// Prints by how many pixels several rendering nodes show something else than one does, and why: a row of a Markdown
// table a scene and number of nodes. docs/deferred_shading.md is made from it by scripts/node-differences.
//
//   node_report SCENE...
#include <cstdio>
#include <filesystem>
#include <string>

#include "scanline/error.h"
#include "tests/nodes/node_differences.h"

namespace {

void print_row(const std::string& name, int count, const nodes::Comparison& c) {
  const double million = c.covered ? 1e6 * static_cast<double>(c.total()) / static_cast<double>(c.covered) : 0;
  std::printf("| %s | %d | %lld | %lld | %.0f |", name.c_str(), count, static_cast<long long>(c.covered),
              static_cast<long long>(c.total()), million);
  for (const auto kind : c.differing) std::printf(" %lld |", static_cast<long long>(kind));
  std::printf(" %lld |\n", static_cast<long long>(c.composed_wrong));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::printf("| scene | rendering nodes | covered pixels | differing | a million |");
    for (const auto& name : nodes::kDifferenceNames) std::printf(" %s |", std::string(name).c_str());
    std::printf(" composed wrong |\n|---|---|---|---|---|");
    for (std::size_t n = 0; n < nodes::kDifferenceNames.size(); ++n) std::printf("---|");
    std::printf("---|\n");
    for (int n = 1; n < argc; ++n) {
      const scanline::Scene scene = scanline::read_scene_file(argv[n]);
      for (const int count : {2, 3, 4, 8}) {
        const nodes::Comparison c = nodes::compare(scene, nodes::render(scene, argv[n], count, 2));
        print_row(std::filesystem::path(argv[n]).stem().string(), count, c);
        if (!c.first.empty()) std::fprintf(stderr, "%s: %s\n", argv[n], c.first.c_str());
      }
    }
    return 0;
  } catch (const std::exception& mistake) {
    std::fprintf(stderr, "%s\n", mistake.what());
    return 1;
  }
}
