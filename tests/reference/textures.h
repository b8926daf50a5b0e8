// Images that a shader looks up: given to the interpreter from outside.
#pragma once

#include <array>
#include <cstdint>

namespace reference {

class Textures {
 public:
  virtual ~Textures() = default;
  /// Components 0 to 255, of U(8,8).
  virtual std::array<std::uint8_t, 4> look_up(std::int64_t number, float s, float t) const = 0;
  virtual std::array<std::uint8_t, 4> environment(std::int64_t number, std::array<float, 3> direction) const = 0;
};

}  // namespace reference
