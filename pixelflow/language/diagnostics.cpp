#include "pixelflow/language/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace pfman {

std::uint32_t Diagnostics::add_file(const std::string& name) {
  const auto found = std::find(files_.begin(), files_.end(), name);
  if (found != files_.end()) return static_cast<std::uint32_t>(found - files_.begin());
  files_.push_back(name);
  return static_cast<std::uint32_t>(files_.size() - 1);
}

void Diagnostics::add(Diagnostic diagnostic) {
  const bool known = std::any_of(all_.begin(), all_.end(), [&](const Diagnostic& other) {
    return other.code == diagnostic.code && other.where == diagnostic.where && other.text == diagnostic.text;
  });
  if (known) return;
  if (diagnostic.is_error()) ++errors_;
  all_.push_back(std::move(diagnostic));
}

std::string Diagnostics::place(Location where) const {
  std::string text = where.file < files_.size() ? files_[where.file] : "?";
  if (where.line > 0) text += ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
  return text;
}

std::string Diagnostics::text(const Diagnostic& diagnostic) const {
  const bool error = diagnostic.is_error();
  std::string text = place(diagnostic.where) + (error ? ": error: " : ": warning: ") + diagnostic.text +
                     (error ? " [E" : " [W") + std::to_string(diagnostic.code) + "]";
  for (const Note& note : diagnostic.notes) text += "\n" + place(note.where) + ": note: " + note.text;
  return text;
}

std::string Diagnostics::text() const {
  std::vector<const Diagnostic*> sorted;
  sorted.reserve(all_.size());
  for (const Diagnostic& diagnostic : all_) sorted.push_back(&diagnostic);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic* a, const Diagnostic* b) {
    return std::tie(a->where.file, a->where.line, a->where.column) <
           std::tie(b->where.file, b->where.line, b->where.column);
  });
  std::string all;
  for (const Diagnostic* diagnostic : sorted) all += text(*diagnostic) + "\n";
  return all;
}

}  // namespace pfman
