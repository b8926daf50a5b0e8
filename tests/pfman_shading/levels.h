// Arrays of every level of modelling that is built.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#ifdef VSG_HAVE_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace pfman_tests {

struct LevelArray {
  std::string name;
  std::unique_ptr<pixelflow::PixelArray> array;
};

/// `lanes`: a multiple of a chip's elements.
inline std::vector<LevelArray> all_levels(int lanes = pixelflow::kElements) {
  std::vector<LevelArray> all;
  all.push_back({"macro", pixelflow::make_golden_array(pixelflow::Level::Macro, lanes)});
  all.push_back({"model", pixelflow::make_golden_array(pixelflow::Level::Model, lanes)});
#ifdef VSG_HAVE_RTL
  all.push_back({"rtl", tb::make_rtl_array(lanes)});
#endif
  return all;
}

}  // namespace pfman_tests
