#include "watkins/data_folder.h"

#include <dlfcn.h>

#include <cstdlib>

namespace watkins {
namespace {

namespace fs = std::filesystem;

/// The file that this code was loaded from: the program, or the library that it is part of.
fs::path own_file() {
  Dl_info info{};
  std::error_code error;
  if (dladdr(reinterpret_cast<const void*>(&data_folder), &info) != 0 && info.dli_fname != nullptr) {
    // A program is known here as it was called, which need not be a path.
    const fs::path file = fs::canonical(info.dli_fname, error);
    if (!error && fs::path(info.dli_fname).has_parent_path()) return file;
  }
  return fs::canonical("/proc/self/exe", error);
}

}  // namespace

fs::path data_folder() {
  const char* const from_environment = std::getenv("VSG_DATA");
  if (from_environment != nullptr && *from_environment != '\0') return from_environment;
  const fs::path own_folder = own_file().parent_path();
  std::error_code error;
  // Programs are installed in bin, libraries in lib or one folder below it.
  for (const char* const way : {"..", "../.."}) {
    const fs::path folder = (own_folder / way / "share" / "watkins").lexically_normal();
    if (!own_folder.empty() && fs::is_directory(folder / "shaders", error)) return folder;
  }
  return VSG_DATA_DIR;
}

}  // namespace watkins
