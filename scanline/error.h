// A user's mistake, with the place where it was made.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace scanline {

struct Diagnostic {
  std::string file;     ///< empty when there is none
  int line = 0;         ///< from 1; 0 when there is none
  int column = 0;       ///< from 1; 0 when there is none
  std::string message;  ///< no capital, no full stop
};

/// "file:line:column: error: message"; the parts that are not known are left out.
std::string format(const Diagnostic& diagnostic, const char* severity = "error");

/// Thrown by readers and checks; what() holds every diagnostic, a line each.
class UserError : public std::runtime_error {
 public:
  explicit UserError(Diagnostic diagnostic);
  explicit UserError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace scanline
