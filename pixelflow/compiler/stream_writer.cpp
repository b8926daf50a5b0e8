#include "pixelflow/compiler/stream_writer.h"

#include <stdexcept>
#include <string>

namespace pfman {
namespace {

using pixelflow::Alu;
using pixelflow::Assembler;
using pixelflow::Code;
using pixelflow::Gate;
using pixelflow::Operand;
using pixelflow::P;
using pixelflow::Q;
using pixelflow::To;

constexpr std::size_t kMostInstructions = std::size_t{1} << 22;  // nested loops soon make more than memory holds
constexpr std::uint64_t kFloatOne = 0x3F800000;
constexpr std::uint64_t kFloatMinusZero = 0x80000000;

bool is(const Operand& operand, std::uint64_t constant) {
  return operand.uniform && (operand.constant & 0xFFFFFFFF) == constant;
}

/// The operand that the result equals bit for bit, or null. A float is never changed by these: there is one NaN, and
/// subnormal numbers are kept.
const Operand* unchanged(const pixelflow::Operation& o) {
  switch (o.code) {
    case Code::Copy: return &o.a;
    case Code::FloatMultiply:
      if (o.flush) return nullptr;
      return is(o.b, kFloatOne) ? &o.a : is(o.a, kFloatOne) ? &o.b : nullptr;
    case Code::FloatDivide: return !o.flush && is(o.b, kFloatOne) ? &o.a : nullptr;
    case Code::FloatAdd:
      if (o.flush) return nullptr;
      return is(o.b, kFloatMinusZero) ? &o.a : is(o.a, kFloatMinusZero) ? &o.b : nullptr;
    case Code::FloatSub: return !o.flush && is(o.b, 0) ? &o.a : nullptr;
    default: return nullptr;
  }
}

std::uint8_t byte_of(const Operand& operand, int n) { return static_cast<std::uint8_t>(operand.constant >> (8 * n)); }

/// A byte of an operation's result or operand: in memory, or known.
struct Byte {
  bool known = false;
  int value = 0;  ///< known: the value; otherwise the address
  friend bool operator==(const Byte&, const Byte&) = default;
};

Byte byte(const Operand& operand, int n) {
  if (operand.uniform) return {true, byte_of(operand, n)};
  return {false, operand.address + n};
}

void move(Assembler& out, int to, const Byte& from) {
  if (from.known) {
    out.store_constant(from.value, to);
  } else if (from.value != to) {
    out.load_m(from.value);
    out.store(P::M, to);
  }
}

void logic_byte(Assembler& out, Alu function, int to, Byte a, Byte b) {
  if (a.known && !b.known) std::swap(a, b);
  if (!b.known) {
    out.load_m(a.value);
    out.alu(function, To::M, P::M, Q::Memory, {.addr = b.value});
    out.store(P::M, to);
    return;
  }
  const int identity = function == Alu::And ? 0xFF : 0;
  if (b.value == identity) return move(out, to, a);
  if (function == Alu::And && b.value == 0) return move(out, to, {true, 0});
  if (function == Alu::Or && b.value == 0xFF) return move(out, to, {true, 0xFF});
  out.load_m(a.value);
  out.alu(function, To::Memory, P::M, Q::Immediate, {.addr = to, .imm = b.value});
}

void move_where(Assembler& out, int to, const Byte& from, Gate gate) {
  if (from.known) {
    out.store_constant(from.value, to, gate);
  } else {
    out.load_m(from.value);
    out.store(P::M, to, gate);
  }
}

void select_byte(Assembler& out, int to, const Byte& a, const Byte& b) {
  const Byte target{false, to};
  if (a == b) return move(out, to, a);
  if (b == target) return move_where(out, to, a, Gate::EAndK);
  if (a == target) return move_where(out, to, b, Gate::EAndNotK);
  if (a.known && b.known) {
    out.store_constant(a.value, to, Gate::EAndK);
    out.store_constant(b.value, to, Gate::EAndNotK);
  } else if (a.known) {
    out.load_m(b.value);
    out.alu(Alu::Select, To::Memory, P::Immediate, Q::M, {.addr = to, .imm = a.value});
  } else if (b.known) {
    out.load_m(a.value);
    out.alu(Alu::Select, To::Memory, P::M, Q::Immediate, {.addr = to, .imm = b.value});
  } else {
    out.load_m(a.value);
    out.alu(Alu::Or, To::M, P::Zero, Q::MemoryOrM, {.addr = b.value});
    out.store(P::M, to);
  }
}

void check_length(const Operand& d, const Operand& operand) {
  if (!operand.uniform && operand.bytes != d.bytes) throw std::logic_error("bytes are joined one by one");
}

}  // namespace

void StreamWriter::operate(pixelflow::Operation operation) {
  if (const Operand* same = unchanged(operation)) {
    const Operand source = *same;
    if (!source.uniform && source.address == operation.d.address && source.bytes >= operation.d.bytes) return;
    operation = {.code = Code::Copy, .d = operation.d, .a = source, .b = {}, .scale = 0, .flush = false, .work = 0};
  }
  pixelflow::append(program(), operation);
  close_step();
}

void StreamWriter::close_step() {
  if (program().instructions.size() > kMostInstructions) {
    throw UniformError(where_, "the stream has more than " + std::to_string(kMostInstructions) + " instructions");
  }
  auto& steps = program().steps;
  auto& places = stream_.parts.back().places;
  const pixelflow::Step last = steps.back();
  if (last.count == 0) {
    steps.pop_back();
    return;
  }
  if (steps.size() > 1 && !last.operation) {
    pixelflow::Step& before = steps[steps.size() - 2];
    if (!before.operation && places.back() == where_) {
      before.count += last.count;
      steps.pop_back();
      return;
    }
  }
  places.push_back(where_);
}

void StreamWriter::logic(Alu function, const Operand& d, const Operand& a, const Operand& b) {
  check_length(d, a);
  check_length(d, b);
  bare([&](Assembler& out) {
    for (int n = 0; n < d.bytes; ++n) logic_byte(out, function, d.address + n, byte(a, n), byte(b, n));
  });
}

void StreamWriter::select(const Operand& d, const Operand& a, const Operand& b) {
  check_length(d, a);
  check_length(d, b);
  bare([&](Assembler& out) {
    for (int n = 0; n < d.bytes; ++n) select_byte(out, d.address + n, byte(a, n), byte(b, n));
  });
}

void StreamWriter::send(const Lookup& lookup, int coordinates, int bytes) {
  bare([&](Assembler& out) {
    for (int n = 0; n < bytes; ++n) {
      out.load_m(coordinates + n);
      out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = n});
    }
    out.control(pixelflow::Control::Send);
  });
  share(lookup);
}

void StreamWriter::share(const Lookup& lookup) {
  stream_.parts.back().lookup = lookup;
  stream_.parts.emplace_back();
}

void StreamWriter::receive(int address, int bytes) {
  bare([&](Assembler& out) {
    out.control(pixelflow::Control::WaitInbound);
    for (int n = 0; n < bytes; ++n) out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = address + n, .imm = n});
    out.control(pixelflow::Control::FreeInbound);
  });
}

}  // namespace pfman
