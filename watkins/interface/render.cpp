// From a context's state to a picture: the scene that the renderer draws.
#include <algorithm>
#include <cmath>
#include <utility>

#include "watkins/interface/context_state.h"

namespace watkins {
namespace {

const char* name(Level level) { return level == Level::Macro ? "macro" : level == Level::Model ? "model" : "rtl"; }

RenderOptions render_options(const Machine& machine) {
  RenderOptions options;
  options.generator.vsg = name(machine.generator);
  options.pixels.level = name(machine.pixels);
  options.samples = machine.samples;
  options.threads = machine.threads;
  options.rendering_nodes = machine.rendering_nodes;
  return options;
}

/// Whether a renderer made for one does for the other.
bool same(const Machine& a, const Machine& b) {
  return a.generator == b.generator && a.pixels == b.pixels && a.samples == b.samples && a.threads == b.threads &&
         a.rendering_nodes == b.rendering_nodes;
}

std::int64_t count(std::uint64_t number) { return static_cast<std::int64_t>(number); }

Counts counts_of(const RenderedFrame& rendered, int shading_nodes) {
  const FrameCounts& counts = rendered.counts;
  Counts result;
  for (const vsg::FrameAnswer& answer : rendered.answers) {
    result.polygons += answer.counters.polygon_blocks;
    result.segment_references += answer.counters.segment_references;
  }
  result.regions = counts.regions;
  result.covered_regions = counts.covered_regions;
  result.samples = counts.samples;
  result.covered_samples = counts.covered_samples;
  result.shading_cycles = count(counts.sum.shading());
  for (const std::uint64_t cycles : counts.region_cycles) {
    result.slowest_region = std::max(result.slowest_region, count(cycles));
  }
  result.busiest_node = count(busiest_node(counts, shading_nodes));
  result.bytes_a_pixel = counts.largest_map;
  result.packet_bytes = counts.packet_bytes;
  result.texture_lookups = count(counts.sum.lookups);
  result.streams_made = counts.streams_made;
  result.streams_reused = counts.streams_reused;
  return result;
}

}  // namespace

std::vector<std::uint8_t> Picture::bytes() const {
  std::vector<std::uint8_t> result;
  result.reserve(colors.size());
  for (const float value : colors) {
    result.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f))));
  }
  return result;
}

void Context::State::complete_scene() {
  scene.objects.clear();
  for (Polygons::Run& run : polygons.take()) {
    scanline::Object& object = scene.objects.emplace_back();
    object.name = shaders[run.instance].function().name + " " + std::to_string(scene.objects.size());
    object.shader = shaders[run.instance].call();
    object.mesh = run.builder.take();
    object.keys = {{}};
  }
  scene.lights.clear();
  for (const LightInstance& light : lights) {
    if (light.enabled) scene.lights.push_back(light.light());
  }
}

Picture Context::State::draw() {
  const double moment = frame++;
  complete_scene();
  if (renderer && same(renderer_machine, machine) && renderer_width == scene.width && renderer_height == scene.height) {
    renderer->scene_changed();
  } else {
    renderer = std::make_unique<Renderer>(scene, "", render_options(machine));
    renderer_machine = machine;
    renderer_width = scene.width;
    renderer_height = scene.height;
  }
  const RenderedFrame rendered = renderer->shade(renderer->find_visible(moment));
  Picture result;
  result.width = rendered.picture.width();
  result.height = rendered.picture.height();
  result.colors = rendered.picture.colors();
  for (const scanline::Diagnostic& warning : rendered.warnings) result.warnings.push_back(warning.message);
  result.counts = counts_of(rendered, machine.shading_nodes);
  return result;
}

}  // namespace watkins
