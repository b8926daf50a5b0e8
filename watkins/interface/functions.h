// Shading functions that a program has loaded (Olano and Lastra 1998, section 4.1).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "watkins/context_types.h"

namespace watkins {

struct LoadedParameter {
  Parameter said;
  pfman::ast::Transform transform = pfman::ast::Transform::None;
  bool settable = true;  ///< false: found on the shading node or set for every frame
};

struct LoadedFunction {
  std::string name;
  bool is_light = false;
  std::filesystem::path file;  ///< absolute
  std::vector<LoadedParameter> parameters;

  /// Throws Error for a parameter that it does not have.
  const LoadedParameter& parameter(const std::string& name) const;
  Function said() const;
};

/// px_...: a parameter that OpenGL knows or that the machine gives.
bool is_standard(const std::string& parameter);

class FunctionLibrary {
 public:
  /// Loads a file, once. Throws Error with everything that the compiler says.
  std::vector<const LoadedFunction*> load(const std::string& file);

  const std::vector<std::unique_ptr<LoadedFunction>>& functions() const { return functions_; }
  /// Throws Error for a function that is not loaded or of the other kind.
  const LoadedFunction& find(const std::string& name, bool is_light) const;

 private:
  std::vector<std::unique_ptr<LoadedFunction>> functions_;
  std::vector<std::filesystem::path> files_;
};

/// Throws Error unless the values are numbers and as many as the parameter has.
void check_values(const LoadedParameter& parameter, const Values& values);

}  // namespace watkins
