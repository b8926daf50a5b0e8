#include "pixelflow/microcode/library.h"

#include <array>
#include <stdexcept>
#include <string>

#include "pixelflow/microcode/functions/functions.h"
#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

using Write = void (*)(Assembler&, const Operation&);
using Workspace = int (*)(const Operation&);

/// What operands an operation takes: which there are, and whether they are floats.
enum class Shape { Unary, Binary, Compare, FloatUnary, FloatBinary, FloatCompare, ToFloat, ToFixed, Noise };

struct Entry {
  const char* name;
  Shape shape;
  Write write;
  Workspace workspace;
};

int no_workspace(const Operation&) { return 0; }

const Entry& entry(Code code) {
  static const std::array<Entry, static_cast<std::size_t>(Code::Count)> entries = [] {
    std::array<Entry, static_cast<std::size_t>(Code::Count)> e{};
    const auto set = [&](Code c, const char* name, Shape shape, Write write, Workspace workspace = no_workspace) {
      e[static_cast<std::size_t>(c)] = {name, shape, write, workspace};
    };
    set(Code::Copy, "copy", Shape::Unary, write_copy);
    set(Code::Add, "add", Shape::Binary, write_add);
    set(Code::Sub, "sub", Shape::Binary, write_add);
    set(Code::Multiply, "multiply", Shape::Binary, write_multiply, multiply_workspace);
    set(Code::Divide, "divide", Shape::Binary, write_divide, divide_workspace);
    set(Code::Remainder, "remainder", Shape::Binary, write_divide, divide_workspace);
    set(Code::ShiftLeft, "shift_left", Shape::Unary, write_shift_left);
    set(Code::ShiftRight, "shift_right", Shape::Unary, write_shift_right);
    set(Code::SquareRoot, "sqrt", Shape::Unary, write_square_root, square_root_workspace);
    set(Code::Wrap, "wrap", Shape::Unary, write_wrap);
    set(Code::Saturate, "saturate", Shape::Unary, write_saturate);
    set(Code::Less, "less", Shape::Compare, write_compare);
    set(Code::LessEqual, "less_equal", Shape::Compare, write_compare);
    set(Code::Equal, "equal", Shape::Compare, write_compare);
    set(Code::FloatAdd, "float_add", Shape::FloatBinary, write_float_add, float_add_workspace);
    set(Code::FloatSub, "float_sub", Shape::FloatBinary, write_float_add, float_add_workspace);
    set(Code::FloatMultiply, "float_multiply", Shape::FloatBinary, write_float_multiply, float_workspace);
    set(Code::FloatDivide, "float_divide", Shape::FloatBinary, write_float_divide, float_workspace);
    set(Code::FloatSquareRoot, "float_sqrt", Shape::FloatUnary, write_float_square_root, float_workspace);
    set(Code::FloatLess, "float_less", Shape::FloatCompare, write_float_compare, float_compare_workspace);
    set(Code::FloatLessEqual, "float_less_equal", Shape::FloatCompare, write_float_compare, float_compare_workspace);
    set(Code::FloatEqual, "float_equal", Shape::FloatCompare, write_float_compare, float_compare_workspace);
    set(Code::FixedToFloat, "fixed_to_float", Shape::ToFloat, write_fixed_to_float, fixed_to_float_workspace);
    set(Code::FloatToFixed, "float_to_fixed", Shape::ToFixed, write_float_to_fixed, float_to_fixed_workspace);
    set(Code::NoiseFixed, "noise_fixed", Shape::Noise, write_noise, noise_workspace);
    set(Code::NoiseFloat, "noise_float", Shape::Noise, write_noise, noise_workspace);
    set(Code::Sin, "sin", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::Cos, "cos", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::Tan, "tan", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::Asin, "asin", Shape::FloatUnary, write_arcsine, arcsine_workspace);
    set(Code::Acos, "acos", Shape::FloatUnary, write_arcsine, arcsine_workspace);
    set(Code::Atan, "atan", Shape::FloatUnary, write_arctangent, arctangent_workspace);
    set(Code::Exp, "exp", Shape::FloatUnary, write_exponential, exponential_workspace);
    set(Code::Exp2, "exp2", Shape::FloatUnary, write_exponential, exponential_workspace);
    set(Code::Log, "log", Shape::FloatUnary, write_logarithm, logarithm_workspace);
    set(Code::Log2, "log2", Shape::FloatUnary, write_logarithm, logarithm_workspace);
    set(Code::FastSin, "fast_sin", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::FastCos, "fast_cos", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::FastTan, "fast_tan", Shape::FloatUnary, write_trigonometric, trigonometric_workspace);
    set(Code::FastAsin, "fast_asin", Shape::FloatUnary, write_arcsine, arcsine_workspace);
    set(Code::FastAcos, "fast_acos", Shape::FloatUnary, write_arcsine, arcsine_workspace);
    set(Code::FastAtan, "fast_atan", Shape::FloatUnary, write_arctangent, arctangent_workspace);
    set(Code::FastExp, "fast_exp", Shape::FloatUnary, write_exponential, exponential_workspace);
    set(Code::FastExp2, "fast_exp2", Shape::FloatUnary, write_exponential, exponential_workspace);
    set(Code::FastLog, "fast_log", Shape::FloatUnary, write_logarithm, logarithm_workspace);
    set(Code::FastLog2, "fast_log2", Shape::FloatUnary, write_logarithm, logarithm_workspace);
    set(Code::InverseSquareRoot, "inversesqrt", Shape::FloatUnary, write_inverse_square_root,
        inverse_square_root_workspace);
    set(Code::Atan2, "atan2", Shape::FloatBinary, write_arctangent, arctangent_workspace);
    set(Code::FastAtan2, "fast_atan2", Shape::FloatBinary, write_arctangent, arctangent_workspace);
    set(Code::Pow, "pow", Shape::FloatBinary, write_power, power_workspace);
    return e;
  }();
  static const Entry unknown{};
  return code < Code::Count ? entries[static_cast<std::size_t>(code)] : unknown;
}

[[noreturn]] void refuse(const Operation& o, const std::string& what) {
  throw std::invalid_argument(std::string(name(o.code)) + ": " + what);
}

void check_place(const Operation& o, const Operand& x, const char* which) {
  if (x.bytes < 1 || x.bytes > 8)
    refuse(o, std::string(which) + " has " + std::to_string(x.bytes) + " bytes, 1 to 8 are possible");
  if (!x.uniform && x.address + x.bytes > kMemoryBytes) refuse(o, std::string(which) + " leaves the memory");
}

/// The same number, or nothing in common: the routines write d byte by byte while they read.
void check_disjoint(const Operation& o, const Operand& source, const char* which) {
  if (overlap(o.d, source) && o.d.address != source.address) refuse(o, std::string("d overlaps ") + which);
}

void check(const Operation& o) {
  const Entry& e = entry(o.code);
  if (!e.write) refuse(o, "has no microcode");
  const Shape shape = e.shape;
  const bool binary =
      shape == Shape::Binary || shape == Shape::Compare || shape == Shape::FloatBinary || shape == Shape::FloatCompare;
  const bool writes = shape != Shape::Compare && shape != Shape::FloatCompare;
  Operation places = o;
  if (shape == Shape::Noise) places.a.bytes = static_cast<std::uint8_t>(o.a.bytes * o.scale);
  check_place(o, o.a, "a");
  if (!o.a.uniform && o.a.address + places.a.bytes > kMemoryBytes) refuse(o, "a leaves the memory");
  if (binary) check_place(o, o.b, "b");
  if (binary && o.a.uniform && o.b.uniform) refuse(o, "both operands are uniform");
  if (!binary && o.a.uniform && o.code != Code::Copy) refuse(o, "the operand is uniform");
  if (writes) {
    check_place(o, o.d, "d");
    if (o.d.uniform) refuse(o, "d is uniform");
    check_disjoint(places, places.a, "a");
    if (binary) check_disjoint(o, o.b, "b");
  }
  const auto four = [&](const Operand& x, const char* which) {
    if (x.bytes != 4) refuse(o, std::string(which) + " is a float and has 4 bytes");
  };
  const bool floats = shape == Shape::FloatUnary || shape == Shape::FloatBinary || shape == Shape::FloatCompare;
  if (floats || shape == Shape::ToFixed) four(o.a, "a");
  if (shape == Shape::Noise) {
    const int bytes = o.code == Code::NoiseFloat ? 4 : 2;
    if (o.a.bytes != bytes || o.d.bytes != bytes)
      refuse(o, "a coordinate and the result have " + std::to_string(bytes) + " bytes");
  }
  if (shape == Shape::FloatBinary || shape == Shape::FloatCompare) four(o.b, "b");
  if (shape == Shape::FloatUnary || shape == Shape::FloatBinary || shape == Shape::ToFloat) four(o.d, "d");
  switch (o.code) {
    case Code::Multiply:
    case Code::Divide:
      if (o.scale < 0 || o.scale > 8) refuse(o, "a scale of 0 to 8 bytes is possible");
      break;
    case Code::ShiftLeft:
    case Code::ShiftRight:
      if (o.scale < 0 || o.scale > 64) refuse(o, "0 to 64 places are possible");
      break;
    case Code::SquareRoot:
      if (o.scale < 0 || o.scale > 64) refuse(o, "a scale of 0 to 64 bits is possible");
      break;
    case Code::Wrap:
    case Code::Saturate:
      if (o.scale < 1 || o.scale > 8 * o.d.bytes) refuse(o, "needs a width within d");
      break;
    case Code::FixedToFloat:
    case Code::FloatToFixed:
      if (o.scale < -64 || o.scale > 128) refuse(o, "a scale of -64 to 128 bits is possible");
      break;
    case Code::NoiseFixed:
    case Code::NoiseFloat:
      if (o.scale < 1 || o.scale > 3) refuse(o, "one to three coordinates are possible");
      break;
    default: break;
  }
  const int work = e.workspace(o);
  if (work == 0) return;
  if (o.work + work > kMemoryBytes)
    refuse(o, "needs " + std::to_string(work) + " bytes of workspace from " + std::to_string(o.work) + " on");
  const auto clear_of = [&](const Operand& x, const char* which) {
    if (!x.uniform && o.work < x.address + x.bytes && x.address < o.work + work)
      refuse(o, std::string("the workspace overlaps ") + which);
  };
  if (writes) clear_of(o.d, "d");
  clear_of(places.a, "a");
  if (binary) clear_of(o.b, "b");
}

}  // namespace

void append_plane(Program& program, int d, int bytes, std::int64_t a, std::int64_t b, std::int64_t c) {
  if (bytes < 1 || bytes > 8 || d < 0 || d + bytes > kMemoryBytes) {
    throw std::invalid_argument("plane: a number of " + std::to_string(bytes) + " bytes does not fit at " +
                                std::to_string(d));
  }
  append_instructions(program, [&](Assembler& code) {
    code.clear_w();
    code.alu(Alu::Or, To::M, P::Zero, Q::Port, {.imm = kPortX});
    code.alu(Alu::Or, To::X, P::Zero, Q::Port, {.imm = kPortY});
    const auto byte = [](std::int64_t value, int n) { return static_cast<int>(value >> (8 * n) & 0xFF); };
    for (int n = 0; n < bytes; ++n) {
      code.multiply_m_constant(byte(a, n));
      code.multiply_x_constant(byte(b, n));
      code.alu(Alu::Add, To::Memory, P::W, Q::Immediate,
               {.addr = d + n, .imm = byte(c, n), .cin = n ? Carry::C : Carry::Zero, .c = true, .down = true});
    }
  });
}

const char* name(Code code) {
  const char* text = entry(code).name;
  return text ? text : "operation";
}

int workspace_bytes(const Operation& operation) {
  const Entry& e = entry(operation.code);
  return e.workspace ? e.workspace(operation) : 0;
}

void append(Program& program, const Operation& operation) {
  check(operation);
  const Entry& e = entry(operation.code);
  const auto first = static_cast<std::uint32_t>(program.instructions.size());
  Assembler assembler(program.instructions);
  e.write(assembler, operation);
  program.steps.push_back({operation, first, static_cast<std::uint32_t>(program.instructions.size()) - first,
                           static_cast<std::uint8_t>(e.workspace(operation))});
}

}  // namespace pixelflow
