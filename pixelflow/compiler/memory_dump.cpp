// Lifetimes and the memory map as text.
#include <algorithm>
#include <string>
#include <vector>

#include "pixelflow/compiler/allocate.h"
#include "pixelflow/compiler/memory_layout.h"

namespace pfman {
namespace {

struct Span {
  int first = -1, last = -1;  ///< lines of the source
};

void extend(Span& span, std::uint32_t line) {
  if (line == 0) return;
  const int n = static_cast<int>(line);
  span.first = span.first < 0 ? n : std::min(span.first, n);
  span.last = std::max(span.last, n);
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

}  // namespace

std::string dump(const Lifetimes& lifetimes, const ir::Code& code) {
  const int size = static_cast<int>(code.code.size());
  std::vector<int> shown;
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    bool alive = false;
    for (int i = 0; i <= size && !alive; ++i) alive = lifetimes.alive_before(i, v);
    for (int i = 0; i < size && !alive; ++i) alive = lifetimes.alive_after(i, v);
    if (alive) shown.push_back(v);
  }
  std::string out = "lifetimes of " + code.name + ": instruction, line, variables alive before it\n";
  for (std::size_t n = 0; n < shown.size(); ++n) {
    const ir::Variable& variable = code.variables[shown[n]];
    out += std::string(14, ' ');
    for (std::size_t m = 0; m < n; ++m) out += "| ";
    out += label(variable) + ", " + std::to_string(variable.bytes()) +
           (lifetimes.retained(shown[n]) ? " bytes, retained over the lights\n" : " bytes\n");
  }
  for (int i = 0; i <= size; ++i) {
    std::string line = padded(std::to_string(i), 6);
    line += i < size ? padded(std::to_string(code.code[i].where.line), 8) : "end     ";
    for (const int v : shown) line += lifetimes.alive_before(i, v) ? "# " : ". ";
    line.pop_back();
    out += line + "\n";
  }
  return out;
}

std::string dump(const MemoryMap& map, const ir::Code& code) {
  const Lifetimes lifetimes(code);
  struct Row {
    int first, end;
    std::string name;
    Span lines;
    bool retained;
  };
  std::vector<Row> rows;
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    const int at = map.address[v];
    if (at < 0) continue;
    Span lines;
    for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
      if (lifetimes.alive_before(i, v) || lifetimes.alive_after(i, v)) extend(lines, code.code[i].where.line);
    }
    rows.push_back({at, at + code.variables[v].bytes(), label(code.variables[v]), lines, lifetimes.retained(v)});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return std::pair{a.first, a.lines.first} < std::pair{b.first, b.lines.first};
  });
  std::string out = "memory map of " + code.name + "\n";
  for (const Row& row : rows) {
    std::string line = "  " + padded(std::to_string(row.first) + "-" + std::to_string(row.end - 1), 10);
    line += padded(row.name, 24) + "  ";
    if (row.lines.first >= 0) {
      line += "lines " + std::to_string(row.lines.first) + "-" + std::to_string(row.lines.last);
    }
    if (row.retained) line += ", retained";
    while (line.back() == ' ') line.pop_back();
    out += line + "\n";
  }
  const auto add = [&](const char* what, int value) { out += "  " + padded(what, 36) + std::to_string(value) + "\n"; };
  add("received with the pixel, bytes", map.parameter_bytes);
  add("most in use at once, bytes", map.peak_bytes);
  if (map.peak_at < static_cast<int>(code.code.size())) {
    add("at line", static_cast<int>(code.code[map.peak_at].where.line));
  }
  if (code.kind == Shader::Kind::Surface) {
    add("first free byte", map.first_free);
    add("first byte for lights", map.high_water);
    add("bytes free", kSharedAt - map.first_free);
  } else {
    add("lowest byte in use", map.first_free);
  }
  add("uniform variables, bytes", map.uniform_bytes);
  add("varying variables, bytes", map.varying_bytes);
  add("these as allocated, bytes", map.allocated_bytes);
  return out;
}

}  // namespace pfman
