// Figure 5 of Olano and Lastra's paper: one shading function, two walls. Fat red bricks and thin yellow ones are
// instances of it; a lamp in the corner is the ninth light.
#include <watkins/context.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

constexpr double kLength = 4, kHeight = 2.4;

watkins::ShaderId brick(watkins::Context& context, double width, double height, const watkins::Values& color) {
  const watkins::ShaderId id = context.new_shader("simple_brick");
  context.bound_material(id, "width", {width});
  context.bound_material(id, "height", {height});
  context.bound_material(id, "brick_color", color);
  context.end_shader();
  return id;
}

/// A wall in the plane z = 0, seen from +z.
void draw_wall(watkins::Context& context) {
  constexpr double kCorners[4][2] = {{0, 0}, {kLength, 0}, {kLength, kHeight}, {0, kHeight}};
  context.normal(0, 0, 1);
  context.begin();
  for (const auto& corner : kCorners) {
    context.tex_coord(corner[0], corner[1]);
    context.vertex(corner[0], corner[1]);
  }
  context.end();
}

void draw_floor(watkins::Context& context) {
  context.normal(0, 1, 0);
  context.begin();
  context.vertex(0, 0, -4);
  context.vertex(-4, 0, 0);
  context.vertex(0, 0, 4);
  context.vertex(4, 0, 0);
  context.end();
}

watkins::Picture draw(watkins::Context& context) {
  context.size(320, 200);
  context.background(0.55, 0.7, 0.85);
  context.look_at({0, 1.3, 4.5}, {0, 1.1, 0}, {0, 1, 0});
  context.perspective(45, 0.5, 20);

  context.load_extension_code("simple_brick.pfman");
  const watkins::ShaderId fat_red = brick(context, 0.5, 0.25, {0.62, 0.16, 0.10});
  const watkins::ShaderId thin_yellow = brick(context, 0.25, 0.08, {0.80, 0.66, 0.22});

  // The default surface wants lights of three colours, as OpenGL has them; a lamp has one.
  context.load_extension_code("matte.pfman");
  const watkins::ShaderId floor = context.new_shader("matte");
  context.bound_material(floor, "rgb", {0.45, 0.5, 0.45});
  context.end_shader();

  context.load_extension_code("point_light.pfman");
  const watkins::LightId lamp = context.new_light("point_light");
  context.light(lamp, "position", {0, 1.8, -0.6});
  context.light(lamp, "intensity", {1.2});
  context.light(lamp, "falloff", {0.5});
  context.enable(lamp);
  const watkins::LightId sun{0};
  context.light(sun, "position", {0.2, 1, 1, 0});
  context.light(sun, "diffuse", {0.6, 0.6, 0.55});
  context.enable(sun);

  context.shader(floor);
  draw_floor(context);
  // The walls meet in the corner at (0, 0, -2).
  context.shader(fat_red);
  context.push_matrix();
  context.translate(0, 0, -2);
  context.rotate(45, 0, 1, 0);
  context.translate(-kLength, 0, 0);
  draw_wall(context);
  context.pop_matrix();
  context.shader(thin_yellow);
  context.push_matrix();
  context.translate(0, 0, -2);
  context.rotate(-45, 0, 1, 0);
  draw_wall(context);
  context.pop_matrix();
  return context.render();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "walls.ppm";
  try {
    watkins::Context context;
    const watkins::Picture picture = draw(context);
    const auto bytes = picture.bytes();
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << picture.width << " " << picture.height << "\n255\n";
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw watkins::Error("cannot write '" + file + "'");
    std::printf("%s: %lld polygons, %lld regions, %lld cycles of shading\n", file.c_str(),
                static_cast<long long>(picture.counts.polygons), static_cast<long long>(picture.counts.covered_regions),
                static_cast<long long>(picture.counts.shading_cycles));
  } catch (const watkins::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
