#include "tests/interface/drawing.h"

#include <unistd.h>

#include <atomic>

namespace interface_tests {

const char* const kShowShader = R"(
surface show(
    output varying fixed<8,8> px_shader_color[3],
    uniform transform_as_vector float shown[3] = { 0, 0, 0 },
    varying float shade = 0.5)
{
    px_shader_color = { shown[0] + shade, shown[1] + shade, shown[2] + shade };
}
surface show_texture_coordinates(
    output varying fixed<8,8> px_shader_color[3],
    varying transform_as_texture float px_shader_texcoord[3])
{
    px_shader_color = px_shader_texcoord;
}
surface look_up(
    output varying fixed<8,8> px_shader_color[3],
    varying transform_as_texture float px_shader_texcoord[2],
    uniform int image = 1)
{
    px_shader_color = texture(image, px_shader_texcoord[0], px_shader_texcoord[1]);
}
surface show_time(output varying fixed<8,8> px_shader_color[3], uniform float px_shader_time)
{
    px_shader_color = { px_shader_time, px_shader_time, px_shader_time };
}
)";

std::uint64_t TemporaryFile::unique() {
  static std::atomic<std::uint64_t> count{0};
  return static_cast<std::uint64_t>(getpid()) * 1000 + count++;
}

}  // namespace interface_tests
