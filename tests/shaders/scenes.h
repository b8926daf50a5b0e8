// Every surface of shaders/ with values and lights that show what it does.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/shaders/region.h"

namespace shader_tests {

/// Names of the surfaces' files.
std::vector<std::string> surface_files();

/// A surface on its shape under all lights that it can be used with, each of which reaches it.
struct Scene {
  Compiled surface;
  std::vector<Compiled> light_units;
  std::vector<pfman::Instance> instance;  ///< the surface's, one
  std::vector<pfman::Instance> lights;
  pfman::TestView view;
};
Scene make_scene(const std::string& surface, const pfman::Options& options = {});

}  // namespace shader_tests
