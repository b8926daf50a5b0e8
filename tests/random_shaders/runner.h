// Runs a program through the reference interpreter and through the compiler and the pixel processors, and compares.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/compile.h"
#include "tests/random_shaders/generator.h"

namespace random_shaders {

/// One way to execute a program.
struct Way {
  std::string name;  ///< "macro", "model, nothing optimised"
  pfman::Options options;
  std::function<std::unique_ptr<pixelflow::PixelArray>()> make_array;
};

struct Outcome {
  enum class Kind {
    Agrees,
    TooWide,   // both refuse an intermediate value of more than 64 bits
    TooLarge,  // the compiler: pixel memory does not suffice
    RunTime,   // an error while uniform code runs, which both find
    Differs,   // in a value, or in what is refused
  };
  Kind kind = Kind::Agrees;
  std::string text;  ///< of Differs: what, where
  int runs = 0;      ///< of streams on arrays
};

constexpr int kLanes = 256;

/// `seed` decides about the parameters' values.
Outcome check(const Program& program, std::uint64_t seed, const std::vector<Way>& ways);

}  // namespace random_shaders
