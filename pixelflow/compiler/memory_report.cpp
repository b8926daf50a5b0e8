#include "pixelflow/compiler/memory_report.h"

#include <map>
#include <string>
#include <tuple>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

std::string bytes_text(int bytes) { return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes"); }

/// Elements of one variable of the source, or one temporary.
struct Entry {
  std::string name;
  Location where;
  bool temporary = false;
  bool is_float = false;
  int bytes = 0;
  int numbers = 0;
};

std::vector<Entry> alive(const ir::Code& code, const std::vector<int>& variables) {
  using Key = std::tuple<std::string, std::uint32_t, std::uint32_t, std::uint32_t>;
  std::vector<Entry> entries;
  std::map<Key, std::size_t> known;
  for (const int v : variables) {
    const ir::Variable& variable = code.variables[v];
    if (variable.address && *variable.address >= kSharedAt) continue;
    const std::string name = variable.temporary ? "" : variable.source.empty() ? variable.name : variable.source;
    const Key key{name, variable.where.file, variable.where.line, variable.where.column};
    const auto [it, is_new] = known.insert({key, entries.size()});
    if (is_new) entries.push_back({name, variable.where, variable.temporary, variable.scalar.is_float, 0, 0});
    Entry& entry = entries[it->second];
    entry.bytes += variable.bytes();
    entry.numbers += variable.count;
    entry.is_float = entry.is_float && variable.scalar.is_float;
  }
  return entries;
}

std::string text(const Entry& entry) {
  constexpr int kFixedBytes = 2;
  std::string line = entry.temporary ? "an intermediate result" : "'" + entry.name + "'";
  line += entry.is_float ? ": float, " : ": fixed, ";
  line += bytes_text(entry.bytes);
  if (entry.is_float) {
    line +=
        "; as fixed of 16 bits it would take " + std::to_string(entry.bytes - kFixedBytes * entry.numbers) + " less";
  }
  return line;
}

}  // namespace

bool check_transfer(const ir::Code& code, int parameter_bytes, Diagnostics& diagnostics) {
  constexpr int kMost = kMostPackets * kPacketPayload;
  if (parameter_bytes <= kMost) return true;
  diagnostics.add(502, code.where,
                  "shader '" + code.name + "' receives " + std::to_string(parameter_bytes) +
                      " bytes for each pixel, its ID included; the " + std::to_string(kMostPackets) +
                      " packets of a transfer have " + std::to_string(kMost));
  return false;
}

void report_full(const ir::Code& code, const Placement& placement, const Layout& layout, int available,
                 Diagnostics& diagnostics) {
  int peak = -1, at = 0;
  for (int i = 0; i < static_cast<int>(code.code.size()); ++i) {
    const int bytes = placement.bytes(i, layout);
    if (bytes <= peak) continue;
    peak = bytes;
    at = i;
  }
  // Where everything alive would fit but for gaps, the extent is what is needed.
  const int need = peak > available ? peak : layout.extent;
  Location line = code.where;
  if (!code.code.empty() && code.code[at].where.line != 0) line = code.code[at].where;
  Diagnostic diagnostic{501, code.where, "", {}};
  diagnostic.text = "shader '" + code.name + "' needs " + std::to_string(need) + " bytes of pixel memory at line " +
                    std::to_string(line.line) + ", " + std::to_string(available) + " are available";
  if (!code.code.empty()) {
    for (const Entry& entry : alive(code, placement.occupied(at)))
      diagnostic.notes.push_back({entry.where, text(entry)});
    const int work = placement.workspace(at, layout.address);
    if (work > 0) {
      const ir::Instruction& instruction = code.code[at];
      const std::string name = instruction.kind == ir::Instruction::Kind::Operate ? pixelflow::name(instruction.code)
                                                                                  : instruction.external->name;
      diagnostic.notes.push_back({line, "workspace of " + name + ": " + bytes_text(work)});
    }
  }
  diagnostics.add(std::move(diagnostic));
}

}  // namespace pfman
