#include "scanline/error.h"

#include <utility>

namespace scanline {
namespace {

std::string join(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    if (!text.empty()) text += '\n';
    text += format(d);
  }
  return text;
}

}  // namespace

std::string format(const Diagnostic& d, const char* severity) {
  std::string text = d.file;
  if (d.line > 0) {
    if (!text.empty()) text.push_back(':');
    text.append(std::to_string(d.line));
    if (d.column > 0) {
      text.push_back(':');
      text.append(std::to_string(d.column));
    }
  }
  if (!text.empty()) text.append(": ");
  return text.append(severity).append(": ").append(d.message);
}

UserError::UserError(Diagnostic diagnostic) : UserError(std::vector<Diagnostic>{std::move(diagnostic)}) {}

UserError::UserError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace scanline
