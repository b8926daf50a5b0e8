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

void report_full(const ir::Code& code, const Placement& placement, int need, int available, Diagnostics& diagnostics) {
  const ir::Instruction& peak = code.code[placement.least_at()];
  const Location where = peak.where.line != 0 ? peak.where : code.where;
  Diagnostic diagnostic{501, code.where, "", {}};
  diagnostic.text = "shader '" + code.name + "' needs " + std::to_string(need) + " bytes of pixel memory at line " +
                    std::to_string(where.line) + ", " + std::to_string(available) + " are available";
  for (const Entry& entry : alive(code, placement.least_variables())) {
    diagnostic.notes.push_back({entry.where, text(entry)});
  }
  if (placement.least_workspace() > 0) {
    const bool external = peak.kind == ir::Instruction::Kind::External;
    const std::string name = external ? peak.external->name : pixelflow::name(peak.code);
    diagnostic.notes.push_back({where, "workspace of " + name + ": " + bytes_text(placement.least_workspace())});
  }
  diagnostics.add(std::move(diagnostic));
}

}  // namespace pfman
