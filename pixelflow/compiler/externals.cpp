#include "pixelflow/compiler/externals.h"

#include <map>
#include <mutex>

namespace pfman {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::string, UniformFunction> uniform;
  std::map<std::string, PixelExternal> pixel;
};

Registry& registry() {
  static Registry instance;
  return instance;
}

}  // namespace

void register_external(const std::string& name, UniformFunction function) {
  const std::lock_guard lock(registry().mutex);
  registry().uniform[name] = function;
}

void register_external(const std::string& name, PixelFunction function, int workspace_bytes) {
  const std::lock_guard lock(registry().mutex);
  registry().pixel[name] = {function, workspace_bytes};
}

UniformFunction uniform_external(const std::string& name) {
  const std::lock_guard lock(registry().mutex);
  const auto found = registry().uniform.find(name);
  return found == registry().uniform.end() ? nullptr : found->second;
}

PixelExternal pixel_external(const std::string& name) {
  const std::lock_guard lock(registry().mutex);
  const auto found = registry().pixel.find(name);
  return found == registry().pixel.end() ? PixelExternal{} : found->second;
}

std::uint8_t pixel_kind(const Scalar& scalar) { return scalar.is_float ? 2 : scalar.is_signed ? 1 : 0; }

}  // namespace pfman
