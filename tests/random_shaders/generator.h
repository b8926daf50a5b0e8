// Random programs of the shading language, valid by construction but for intermediates of more than 64 bits and pixel
// memory, which are found out afterwards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/random_shaders/piece.h"
#include "tests/random_shaders/random.h"
#include "tests/reference/interpreter.h"

namespace random_shaders {

struct Program {
  Piece text;
  std::string surface;              ///< its name; empty for a program that is a light alone
  std::vector<std::string> lights;  ///< shaders that light the surface, or the one that is tested
};

struct Settings {
  int statements = 6;  ///< of a body, at most
  int depth = 3;       ///< of an expression
  bool costly = true;  ///< functions of the library that take thousands of cycles
};

Program random_program(std::uint64_t seed, const Settings& settings);

/// Values of a parameter, extreme ones among them: raw bits of `count` numbers.
reference::RawValues random_values(Random& random, const reference::Number& number, int count);

}  // namespace random_shaders
