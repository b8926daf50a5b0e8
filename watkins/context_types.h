// What a Context takes and gives (watkins/context.h). Needs the standard library alone.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__GNUC__)
#define WATKINS_API __attribute__((visibility("default")))
#else
#define WATKINS_API
#endif

namespace watkins {

/// A mistake of the program or in a file; what() may have several lines.
class WATKINS_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Values = std::vector<double>;

enum class ShaderId : int {};  ///< of an instance
enum class LightId : int {};
constexpr ShaderId kOpenGlShader{0};  ///< the surface that everything has at first: opengl_surface
constexpr int kFirstLights = 8;       ///< LightId{0} to LightId{7} are there from the start: opengl_light

enum class Binding { Material, BoundMaterial };  ///< GL_MATERIAL_EXT, GL_BOUND_MATERIAL_EXT
enum class MatrixMode { Model, Texture };
enum class Level { Macro, Model, Rtl };  ///< of modelling; all give the same picture

/// Who gives a parameter its value: the application, or the machine itself (px_shader_view, px_shader_time...).
enum class Giver { Application, Machine };

struct Parameter {
  std::string name, type;  ///< type as pfman spells it: "fixed<8,8>[3]"
  int count = 1;           ///< of numbers
  bool varying = false;    ///< a uniform one can only be bound
  Giver giver = Giver::Application;
  Values defaults;  ///< empty for a standard parameter (px_...), which has none
};

/// A shading function of a loaded file.
struct Function {
  std::string name;
  bool is_light = false;
  std::vector<Parameter> parameters;
};

/// Who works, and how; no setting but `samples` and `rendering_nodes` changes a picture.
struct Machine {
  Level generator = Level::Rtl;  ///< of the Visible Segment Generator: Model or Rtl
  Level pixels = Level::Rtl;     ///< of the pixel processors
  int samples = 1;               ///< samples x samples of them make a pixel; 1 to 64
  int threads = 1;               ///< 1 to 256
  int rendering_nodes = 1;       ///< each has a share of the polygons; 1 to 64
  int shading_nodes = 4;         ///< 1 to 1024; for the counts
};

/// What a picture cost the machines.
struct Counts {
  std::int64_t polygons = 0;            ///< on the screen, those that face away included
  std::int64_t segment_references = 0;  ///< of the Visible Segment Generator to its memory
  std::int64_t regions = 0, covered_regions = 0;
  std::int64_t samples = 0, covered_samples = 0;
  std::int64_t shading_cycles = 0;  ///< of all regions
  std::int64_t slowest_region = 0;  ///< cycles
  std::int64_t busiest_node = 0;    ///< cycles of one shading node, when each of n shades every n-th region
  std::int64_t bytes_a_pixel = 0;   ///< of the largest transfer map, shader ID included
  std::int64_t packet_bytes = 0;    ///< from rendering to shading nodes
  std::int64_t texture_lookups = 0;
  std::int64_t streams_made = 0, streams_reused = 0;
};

struct Picture {
  int width = 0, height = 0;
  std::vector<float> colors;          ///< red, green, blue of a pixel after the other, 0 to 255, the top row first
  std::vector<std::string> warnings;  ///< polygons that are not planar or cross themselves
  Counts counts;

  WATKINS_API std::vector<std::uint8_t> bytes() const;  ///< `colors`, rounded
};

}  // namespace watkins
