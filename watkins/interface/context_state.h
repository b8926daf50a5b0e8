// What a Context holds.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scanline/scene.h"
#include "watkins/context.h"
#include "watkins/interface/functions.h"
#include "watkins/interface/instances.h"
#include "watkins/interface/matrices.h"
#include "watkins/interface/polygons.h"
#include "watkins/renderer.h"

namespace watkins {

struct Context::State {
  FunctionLibrary library;
  std::vector<SurfaceInstance> shaders;  ///< index: ShaderId
  bool defining = false;                 ///< the last of them, between new_shader and end_shader
  std::size_t current = 0;
  std::vector<LightInstance> lights;  ///< index: LightId
  MaterialState materials;
  Matrices matrices;
  Polygons polygons;
  Machine machine;
  int frame = 1;
  /// Camera, size, background, textures, frame rate; render() adds what is drawn.
  scanline::Scene scene;
  std::unique_ptr<Renderer> renderer;
  Machine renderer_machine;  ///< and size: what it was made for
  int renderer_width = 0, renderer_height = 0;

  State();
  std::size_t index(ShaderId id) const;  ///< throws Error for an instance that there is not
  LightInstance& at(LightId id);
  /// Throws Error between begin and end, and between new_shader and end_shader.
  void check_outside(const char* call) const;
  void check_between_frames(const char* call) const;

  /// Puts polygons, instances and lights into the scene.
  void complete_scene();
  Picture draw();
};

}  // namespace watkins
