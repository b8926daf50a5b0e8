#include "pixelflow/compiler/listing.h"

#include <bit>
#include <cstdio>
#include <optional>

#include "cmodel/pixelflow/macro.h"
#include "pixelflow/compiler/instruction_text.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using pixelflow::Code;
using pixelflow::Operand;
using pixelflow::Operation;

constexpr int kCyclesWidth = 8;

std::string hexadecimal(int value) {
  constexpr char kDigits[] = "0123456789abcdef";
  return {kDigits[value >> 4 & 15], kDigits[value & 15]};
}

std::string right(std::uint64_t number, int width) {
  const std::string digits = std::to_string(number);
  const auto wanted = static_cast<std::size_t>(width);
  return (digits.size() < wanted ? std::string(wanted - digits.size(), ' ') : "") + digits;
}

std::string bytes_text(int address, int bytes) {
  return "[" + hexadecimal(address) + (bytes > 1 ? "-" + hexadecimal(address + bytes - 1) : "") + "]";
}

std::string operand_text(const Operand& operand, bool is_float, int count = 1) {
  if (!operand.uniform)
    return (operand.is_signed && !is_float ? "s" : "") + bytes_text(operand.address, operand.bytes * count);
  if (!is_float) {
    return operand.is_signed ? std::to_string(static_cast<std::int64_t>(operand.constant))
                             : std::to_string(operand.constant);
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.9g",
                static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(operand.constant))));
  return text;
}

std::string operation_text(const pixelflow::Step& step) {
  const Operation& o = *step.operation;
  const bool noise = o.code == Code::NoiseFixed || o.code == Code::NoiseFloat;
  const bool floats = pixelflow::takes_floats(o.code);
  std::string text = pixelflow::is_comparison(o.code) ? "K" : operand_text(o.d, pixelflow::gives_float(o.code));
  text += std::string(" := ") + pixelflow::name(o.code) + " " + operand_text(o.a, floats, noise ? o.scale : 1);
  if (pixelflow::operand_count(o.code) > 1) text += ", " + operand_text(o.b, floats);
  if (takes_scale(o.code) && !noise && o.scale != 0) text += ", scale " + std::to_string(o.scale);
  if (step.workspace_bytes > 0) text += "    work " + bytes_text(o.work, step.workspace_bytes);
  return text;
}

std::uint64_t cycles_of(const pixelflow::Program& program, const pixelflow::Step& step) {
  std::uint64_t sum = 0;
  for (std::uint32_t n = 0; n < step.count; ++n) {
    sum += static_cast<std::uint64_t>(pixelflow::cycles(program.instructions[step.first + n]));
  }
  return sum;
}

std::string place_text(Location where, const Diagnostics& files, const LineText& line_text) {
  const auto& names = files.files();
  std::string text = where.file < names.size() ? names[where.file] + ":" + std::to_string(where.line) : "";
  std::string line = line_text ? line_text(where.file, where.line) : "";
  line.erase(0, line.find_first_not_of(" \t"));
  return line.empty() ? text : text + ": " + line;
}

/// visit(name, stream) for each stream of a shader.
template <typename Visit>
void each_stage(const Streams& streams, Visit&& visit) {
  const bool single = streams.illum.empty() && streams.post.parts.empty();
  visit(std::string(single ? "all" : "pre-illum"), streams.pre);
  for (std::size_t n = 0; n < streams.illum.size(); ++n) {
    visit(streams.illum.size() > 1 ? "illum, light " + std::to_string(n + 1) : std::string("illum"), streams.illum[n]);
  }
  if (!single) visit(std::string("post-illum"), streams.post);
}

std::string lookup_text(const Lookup& lookup) {
  return std::string(lookup.shared ? "shared " : "") + std::string(lookup.environment ? "environment " : "texture ") +
         std::to_string(lookup.texture) + ", " + std::to_string(lookup.components) + " components";
}

}  // namespace

std::string listing(const Streams& streams, const Diagnostics& files, const LineText& line_text) {
  std::string text;
  each_stage(streams, [&](const std::string& name, const Stream& stream) {
    text += name + ": " + std::to_string(stream.cycles()) + " cycles\n";
    std::optional<Location> last;
    for (const Stream::Part& part : stream.parts) {
      for (std::size_t n = 0; n < part.program.steps.size(); ++n) {
        const pixelflow::Step& step = part.program.steps[n];
        const Location where = part.places[n];
        if (!last || last->line != where.line || last->file != where.file) {
          text += "  " + place_text(where, files, line_text) + "\n";
          last = where;
        }
        if (step.operation) {
          text += right(cycles_of(part.program, step), kCyclesWidth) + "  " + operation_text(step) + "\n";
          continue;
        }
        for (std::uint32_t i = 0; i < step.count; ++i) {
          const pixelflow::Instruction& instruction = part.program.instructions[step.first + i];
          text += right(static_cast<std::uint64_t>(pixelflow::cycles(instruction)), kCyclesWidth) + "  " +
                  instruction_text(instruction) + "\n";
        }
      }
      if (part.lookup) text += std::string(kCyclesWidth, ' ') + "  lookup: " + lookup_text(*part.lookup) + "\n";
    }
  });
  return text;
}

std::string cycles_text(const Streams& streams, const Diagnostics& files, const LineText& line_text) {
  std::string text;
  each_stage(streams, [&](const std::string& name, const Stream& stream) {
    text += right(stream.cycles(), kCyclesWidth) + "  " + name + "\n";
  });
  for (const auto& [place, cycles] : streams.cycles_by_line) {
    text += right(cycles, kCyclesWidth) + "  " + place_text({place.first, place.second, 1}, files, line_text) + "\n";
  }
  return text;
}

std::map<std::string, int> operation_counts(const Streams& streams) {
  std::map<std::string, int> counts;
  each_stage(streams, [&](const std::string&, const Stream& stream) {
    for (const Stream::Part& part : stream.parts) {
      for (const pixelflow::Step& step : part.program.steps) {
        if (step.operation) {
          ++counts[pixelflow::name(step.operation->code)];
        } else {
          counts["instructions"] += static_cast<int>(step.count);
        }
      }
      if (part.lookup) ++counts["lookup"];
    }
  });
  return counts;
}

}  // namespace pfman
