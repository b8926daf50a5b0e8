// Shader instances and lights as a program makes them (Olano and Lastra 1998, sections 4.3 and 4.4).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scanline/scene.h"
#include "watkins/interface/functions.h"

namespace watkins {

/// A surface with its bound parameters. Values that an application binds are in the world already.
class SurfaceInstance {
 public:
  explicit SurfaceInstance(const LoadedFunction& function);

  const LoadedFunction& function() const { return *function_; }
  /// Throws Error for parameters that the binding is not possible for.
  void set_binding(const std::string& parameter, Binding binding);
  /// Throws Error for a parameter that is not bound.
  const LoadedParameter& bindable(const std::string& parameter) const;
  void bind(const std::string& parameter, Values values) { bound_[parameter] = std::move(values); }

  /// Parameters that come with the vertices, in the order of declaration.
  std::vector<const LoadedParameter*> ordinary() const;
  scanline::ShaderCall call() const;

 private:
  bool is_ordinary(const LoadedParameter& parameter) const;
  const LoadedFunction* function_;
  std::map<std::string, Binding> bindings_;
  std::map<std::string, Values> bound_;
};

struct LightInstance {
  const LoadedFunction* function = nullptr;
  std::map<std::string, Values> values;
  bool enabled = false;

  scanline::Light light() const;
};

/// What OpenGL's state holds for a standard parameter at first; zeros for one that OpenGL does not have.
Values initial_value(const Parameter& parameter);

}  // namespace watkins
