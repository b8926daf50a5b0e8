// Both machines for programs: OpenGL's manner of drawing, extended for procedural shading (Olano and Lastra 1998,
// section 4; each call's name there stands beside it). docs/interface.md explains.
//
// Angles are in degrees; the eye looks along -z; polygons are seen from the side where they run counter-clockwise.
// Every call may throw Error, and then has changed nothing. A context is used by one thread at a time; several contexts
// don't know each other.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "watkins/context_types.h"

namespace watkins {

class WATKINS_API Context {
 public:
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  static bool has_rtl();                          ///< whether the library holds the verilated machines
  Machine machine() const;                        ///< at first the deepest levels there are
  void machine(const Machine& machine);           ///< of the frames to come, this one included
  void size(int width, int height);               ///< of the picture; at first 512 x 512
  void background(double r, double g, double b);  ///< 0 to 1; glClearColor

  /// glLoadExtensionCodeEXT: compiles a file of shaders and says what it holds. A name that is not found from here is
  /// looked for among the shaders that are installed with the library.
  std::vector<Function> load_extension_code(const std::string& file);
  std::vector<Function> functions() const;  ///< that are loaded: opengl_surface and opengl_light from the start

  ShaderId new_shader(const std::string& function);  ///< glNewShaderEXT
  /// glShaderParameterBindingEXT, between new_shader and end_shader. Where it is not called, standard parameters
  /// (px_...) are ordinary and all others bound.
  void shader_parameter_binding(const std::string& parameter, Binding binding);
  void end_shader();  ///< glEndShaderEXT
  /// glBoundMaterialEXT. With a transformation attribute the value goes through the model matrix of this moment. Not
  /// while the frame shows the instance: bound parameters change between frames.
  void bound_material(ShaderId shader, const std::string& parameter, const Values& values);
  void shader(ShaderId shader);  ///< glShaderEXT: of the polygons that follow

  /// glMaterial: the current value of an ordinary parameter, for all shaders that have one of this name.
  void material(const std::string& parameter, const Values& values);
  void normal(double x, double y, double z);                           ///< px_material_normal
  void tex_coord(double s, double t = 0, double r = 0, double q = 1);  ///< px_shader_texcoord
  void color(double r, double g, double b);                            ///< px_material_diffuse

  void begin();  ///< a polygon of three or more vertices, convex or not
  void vertex(double x, double y, double z = 0);
  void end();  ///< with fewer vertices: Error, and there is no polygon

  void matrix_mode(MatrixMode mode);  ///< the matrix that the calls up to pop_matrix are about; at first Model
  void load_identity();
  void load_matrix(const std::array<double, 16>& matrix);  ///< column by column
  void multiply_matrix(const std::array<double, 16>& matrix);
  void translate(double x, double y, double z);
  void rotate(double angle, double x, double y, double z);
  void scale(double x, double y, double z);
  void push_matrix();
  void pop_matrix();

  /// The camera is the frame's: as it is when the frame is rendered. At first at (0, 0, 5), looking along -z.
  void look_at(const std::array<double, 3>& eye, const std::array<double, 3>& target, const std::array<double, 3>& up);
  void perspective(double field_of_view, double near, double far);  ///< vertical; at first 45, 0.1, 100
  void orthographic(double height, double near, double far);        ///< height of what the picture shows

  LightId new_light(const std::string& function);  ///< glNewLightEXT: beyond the first eight, off at first
  void enable(LightId light);
  void disable(LightId light);
  /// glLight. Positions and directions go through the model matrix of this moment. Like enable and disable, not while
  /// the frame has polygons: lights change between frames.
  void light(LightId light, const std::string& parameter, const Values& values);

  void texture(int number, const std::string& file);  ///< an image for shaders that look up this number, 1 to 65535
  void frame_rate(double frames_a_second);            ///< px_shader_time is the frame's number over it; at first 30
  void frame(int number);                             ///< of the picture to come; at first 1, and counts up

  /// Draws the frame and begins the next one, which has no polygons; all other state stays. The frame is over also when
  /// this throws.
  Picture render();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace watkins
