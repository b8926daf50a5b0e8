#include "tests/pfman_memory/pixel_machine.h"

#include <algorithm>
#include <stdexcept>

#include "cmodel/pixelflow/macro.h"
#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"

namespace pfman_tests {

using pfman::ir::Access;
using pfman::ir::Instruction;
using pfman::ir::Operand;
using Kind = pfman::ir::Instruction::Kind;

namespace {

bool is_pixel(const Operand& o) { return o.kind == Operand::Kind::Pixel; }

pixelflow::Operand placed(const Operand& o, int place) {
  pixelflow::Operand out;
  out.address = static_cast<std::uint8_t>(place);
  out.bytes = static_cast<std::uint8_t>(o.bytes);
  out.is_signed = o.is_signed;
  out.uniform = o.kind == Operand::Kind::Uniform;
  return out;
}

}  // namespace

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9E3779B97F4A7C15u + b + 0x7F4A7C15u;
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

PixelMachine::PixelMachine(const pfman::ir::Code& code, Circumstances circumstances)
    : code_(code), circumstances_(circumstances) {
  int next = 0;
  for (int v = 0; v < static_cast<int>(code.variables.size()); ++v) {
    base_.push_back(next);
    next += bytes_of(v);
  }
  memory_.assign(static_cast<std::size_t>(next), 0);
}

PixelMachine::PixelMachine(const pfman::ir::Code& code, Circumstances circumstances, const pfman::MemoryMap& map,
                           const pfman::Lifetimes& lifetimes)
    : code_(code), circumstances_(circumstances), map_(&map), lifetimes_(&lifetimes), base_(map.address) {
  memory_.assign(pixelflow::kMemoryBytes, 0);
  overwrite(0, pixelflow::kMemoryBytes);
}

void PixelMachine::overwrite(int first, int end) {
  for (int at = first; at < end; ++at)
    memory_[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(mix(0xDEAD, ++poison_));
}

void PixelMachine::overwrite_dead(int at) {
  std::vector<bool> holds(pixelflow::kMemoryBytes, false);
  lifetimes_->before().each(at, [&](int v) {
    for (int n = 0; n < bytes_of(v); ++n)
      holds[static_cast<std::size_t>(base_[static_cast<std::size_t>(v)] + n)] = true;
  });
  // What is shared is none of the shader's.
  for (int byte = 0; byte < pfman::kSharedAt; ++byte) {
    if (!holds[static_cast<std::size_t>(byte)]) overwrite(byte, byte + 1);
  }
}

void PixelMachine::start() {
  const auto fill = [&](int v, std::uint64_t key) {
    const int base = base_[static_cast<std::size_t>(v)];
    if (base < 0) return;
    for (int n = 0; n < bytes_of(v); ++n) {
      memory_[static_cast<std::size_t>(base + n)] =
          static_cast<std::uint8_t>(mix(mix(circumstances_.values, key), static_cast<std::uint64_t>(n)));
    }
  };
  for (std::size_t p = 0; p < code_.parameters.size(); ++p) {
    for (const int v : code_.parameters[p].variables) fill(v, 1000 + p);
  }
  for (std::size_t m = 0; m < code_.mask_bytes.size(); ++m) fill(code_.mask_bytes[m], 2000 + m);
}

/// A light has run: the shared variables are new, and nothing is left from the high-water mark on.
void PixelMachine::shine(int light) {
  if (map_) overwrite(map_->high_water, pfman::kSharedAt);
  for (int v = 0; v < static_cast<int>(code_.variables.size()); ++v) {
    const pfman::ir::Variable& variable = code_.variables[static_cast<std::size_t>(v)];
    if (!pfman::ir::is_light_variable(variable) || base_[static_cast<std::size_t>(v)] < 0) continue;
    for (int n = 0; n < variable.bytes(); ++n) {
      memory_[static_cast<std::size_t>(base_[static_cast<std::size_t>(v)] + n)] =
          static_cast<std::uint8_t>(mix(mix(circumstances_.values, 3000 + static_cast<std::uint64_t>(light)),
                                        static_cast<std::uint64_t>(*variable.address + n)));
    }
  }
}

std::uint64_t PixelMachine::uniform(int number) {
  const pfman::Node& node = *code_.uniforms[static_cast<std::size_t>(number)];
  if (node.op == pfman::Node::Op::Literal && node.raw != 0) return node.raw;
  return mix(circumstances_.values, mix(static_cast<std::uint64_t>(number), ++evaluations_[number]));
}

bool PixelMachine::enabled() const {
  return !jump_ && std::all_of(conditions_.begin(), conditions_.end(), [](bool c) { return c; });
}

std::vector<std::uint8_t> PixelMachine::run() {
  start();
  const int size = static_cast<int>(code_.code.size());
  int illum = -1, post = size;
  for (int i = 0; i < size; ++i) {
    if (instruction(i).kind == Kind::Stage) (instruction(i).stage == 1 ? illum : post) = i;
  }
  const auto walk = [&](int first, int last) {
    for (int at = first; at < last;) at = step(at);
  };
  if (illum < 0) {
    walk(0, size);
  } else {
    walk(0, illum);
    if (circumstances_.lights == 0 && map_) overwrite(map_->high_water, pfman::kSharedAt);
    for (int light = 0; light < circumstances_.lights; ++light) {
      shine(light);
      walk(illum + 1, post);
    }
    if (map_) overwrite(map_->high_water, pfman::kSharedAt);
    walk(std::min(post + 1, size), size);
  }
  Bytes result;
  std::vector<int> outputs = pfman::ir::used_at_end(code_);
  // A light's variables may have other numbers after renaming, their addresses are the same.
  std::stable_sort(outputs.begin(), outputs.end(), [&](int a, int b) {
    return code_.variables[static_cast<std::size_t>(a)].address < code_.variables[static_cast<std::size_t>(b)].address;
  });
  outputs.insert(outputs.end(), code_.mask_bytes.begin(), code_.mask_bytes.end());
  for (const int v : outputs) {
    const auto first = memory_.begin() + base_[static_cast<std::size_t>(v)];
    result.insert(result.end(), first, first + bytes_of(v));
  }
  return result;
}

int PixelMachine::leave_loop(int loop) {
  loops_.pop_back();
  if (jump_ && jump_->loop == loop) jump_.reset();
  return instruction(loop).match + 1;
}

int PixelMachine::step(int at) {
  const Instruction& i = instruction(at);
  constexpr int kMostIterations = 4;
  switch (i.kind) {
    case Kind::If: return uniform(i.uniform) % 2 ? at + 1 : i.match + 1;
    case Kind::Else: return i.match + 1;
    case Kind::Loop: loops_.push_back({at, 0, static_cast<int>(uniform(i.uniform) % kMostIterations)}); return at + 1;
    case Kind::LoopTest: return loops_.back().iteration++ < loops_.back().iterations ? at + 1 : leave_loop(i.match);
    case Kind::LoopNext:
      if (jump_ && jump_->loop == i.match && !jump_->leaves) jump_.reset();
      return at + 1;
    case Kind::EndLoop: return i.match + 1;
    case Kind::Break: return leave_loop(i.match);
    case Kind::Continue:
      for (int next = at; next < instruction(i.match).match; ++next) {
        if (instruction(next).kind == Kind::LoopNext && instruction(next).match == i.match) return next;
      }
      throw std::logic_error("a loop without its step");
    case Kind::IfMasked: {
      if (enabled() && map_) overwrite_dead(at);
      bool condition = k_;
      if (enabled() && i.condition) condition = read(i, i.condition, 0)[0] & 1;
      conditions_.push_back(condition);
      return at + 1;
    }
    case Kind::ElseMasked: conditions_.back() = !conditions_.back(); return at + 1;
    case Kind::EndIfMasked: conditions_.pop_back(); return at + 1;
    case Kind::BreakMasked:
    case Kind::ContinueMasked:
      if (enabled()) jump_ = Jump{i.match, i.kind == Kind::BreakMasked};
      return at + 1;
    case Kind::EndIf:
    case Kind::Uniform: return at + 1;
    case Kind::Stage: throw std::logic_error("a stage begins within a stage");
    default: execute(at); return at + 1;
  }
}

std::int64_t PixelMachine::index_of(const Operand& operand) {
  return operand.index < 0
             ? 0
             : static_cast<std::int64_t>(uniform(operand.index) % static_cast<std::uint64_t>(operand.elements));
}

int PixelMachine::place(const Operand& operand, std::int64_t index) const {
  const auto v = static_cast<std::size_t>(operand.variable);
  if (base_[v] < 0) throw std::logic_error("an operand without a place");
  return base_[v] + operand.offset + static_cast<int>(index) * code_.variables[v].scalar.bytes();
}

std::vector<std::uint8_t> PixelMachine::read(const Instruction& of, const Operand& operand, std::int64_t index) {
  Bytes bytes;
  if (operand.kind == Operand::Kind::Uniform) {
    const std::uint64_t value = uniform(operand.uniform);
    for (int n = 0; n < operand.bytes; ++n) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * n)));
  } else if (is_pixel(operand)) {
    const auto first = memory_.begin() + place(operand, index);
    bytes.assign(first, first + pfman::ir::extent(code_, of, operand));
  }
  return bytes;
}

void PixelMachine::execute(int at) {
  const Instruction& i = instruction(at);
  // The host evaluates indices and uniform operands in any case.
  const std::int64_t d_index = index_of(i.d), a_index = index_of(i.a), b_index = index_of(i.b);
  if (enabled() && map_) overwrite_dead(at);
  const Bytes a = read(i, i.a, a_index), b = read(i, i.b, b_index);
  if (!enabled()) return;
  const int d = is_pixel(i.d) ? place(i.d, d_index) : 0;
  const int length = is_pixel(i.d) ? pfman::ir::extent(code_, i, i.d) : 0;
  const auto byte = [&](const Operand& o, const Bytes& value, std::int64_t index, int n) {
    return is_pixel(o) ? memory_[static_cast<std::size_t>(place(o, index) + n)] : value[static_cast<std::size_t>(n)];
  };
  const auto write = [&](int n, std::uint64_t value) {
    memory_[static_cast<std::size_t>(d + n)] = static_cast<std::uint8_t>(value);
  };
  if (i.kind == Kind::Select || i.kind == Kind::And || i.kind == Kind::Or || i.kind == Kind::Xor) {
    const bool condition = i.condition ? read(i, i.condition, 0)[0] & 1 : k_;
    for (int n = 0; n < length; ++n) {
      const unsigned x = byte(i.a, a, a_index, n), y = byte(i.b, b, b_index, n);
      write(n, i.kind == Kind::Select ? (condition ? x : y)
               : i.kind == Kind::And  ? x & y
               : i.kind == Kind::Or   ? x | y
                                      : x ^ y);
    }
    return;
  }
  if (i.kind == Kind::Operate && map_) {
    pixelflow::Operation operation;
    operation.code = i.code;
    operation.scale = i.scale;
    operation.d = is_pixel(i.d) ? placed(i.d, d) : pixelflow::Operand{};
    operation.a = placed(i.a, is_pixel(i.a) ? place(i.a, a_index) : 0);
    operation.b = placed(i.b, is_pixel(i.b) ? place(i.b, b_index) : 0);
    operation.work = static_cast<std::uint8_t>(i.work);
    overwrite(i.work, i.work + pixelflow::workspace_bytes(operation));
    if (is_pixel(i.a) && read(i, i.a, a_index) != a) throw std::logic_error("the workspace lies on an operand");
  }
  if (i.kind == Kind::Operate && i.code == pixelflow::Code::Copy) {
    for (int n = 0; n < length; ++n) write(n, n < static_cast<int>(a.size()) ? a[static_cast<std::size_t>(n)] : 0u);
    return;
  }
  std::uint64_t hash = mix(static_cast<std::uint64_t>(i.kind),
                           static_cast<std::uint64_t>(i.code) * 100 + static_cast<std::uint64_t>(i.scale));
  for (const Bytes* bytes : {&a, &b}) {
    for (const std::uint8_t x : *bytes) hash = mix(hash, x);
  }
  if (i.kind == Kind::Operate && pixelflow::is_comparison(i.code)) {
    k_ = hash & 1;
    for (int n = 0; n < length; ++n) write(n, n == 0 && k_);
    return;
  }
  for (int n = 0; n < length; ++n) write(n, mix(hash, static_cast<std::uint64_t>(n)));
}

void check_operations(const pfman::ir::Code& code, const pfman::MemoryMap& map) {
  for (const Instruction& i : code.code) {
    if (i.kind != Kind::Operate) continue;
    const auto elements = [](const Operand& o) { return o.index < 0 ? 1 : o.elements; };
    for (int n = 0; n < elements(i.d) * elements(i.a) * elements(i.b); ++n) {
      const auto at = [&](const Operand& o, int index) {
        if (!is_pixel(o)) return placed(o, 0);
        const auto v = static_cast<std::size_t>(o.variable);
        return placed(o, map.address[v] + o.offset + index * code.variables[v].scalar.bytes());
      };
      pixelflow::Operation operation;
      operation.code = i.code;
      operation.scale = i.scale;
      operation.d = at(i.d, n % elements(i.d));
      operation.a = at(i.a, n / elements(i.d) % elements(i.a));
      operation.b = at(i.b, n / elements(i.d) / elements(i.a));
      operation.work = static_cast<std::uint8_t>(i.work);
      pixelflow::Program program;
      pixelflow::append(program, operation);
    }
  }
}

}  // namespace pfman_tests
