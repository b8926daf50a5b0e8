#include "pixelflow/compiler/uniform_text.h"

#include <bit>
#include <charconv>
#include <cmath>

#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using Op = Node::Op;

template <typename Number>
std::string number_text(Number value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string literal_text(const Node& node) {
  const Scalar& scalar = node.type.scalar;
  if (scalar.is_float) return number_text(std::bit_cast<float>(static_cast<std::uint32_t>(node.raw)));
  const auto raw = static_cast<std::int64_t>(node.raw);
  if (scalar.exponent == 0) return scalar.is_signed ? std::to_string(raw) : std::to_string(node.raw);
  const double value = scalar.is_signed ? static_cast<double>(raw) : static_cast<double>(node.raw);
  return number_text(std::ldexp(value, -scalar.exponent));
}

const char* infix(Op op) {
  switch (op) {
    case Op::Add: return " + ";
    case Op::Subtract: return " - ";
    case Op::Multiply: return " * ";
    case Op::Divide: return " / ";
    case Op::Remainder: return " % ";
    case Op::ShiftLeft: return " << ";
    case Op::ShiftRight: return " >> ";
    case Op::BitAnd: return " & ";
    case Op::BitOr: return " | ";
    case Op::BitXor: return " ^ ";
    case Op::Less: return " < ";
    case Op::LessEqual: return " <= ";
    case Op::Equal: return " == ";
    case Op::NotEqual: return " != ";
    case Op::And: return " && ";
    case Op::Or: return " || ";
    case Op::Assign:
    case Op::Postfix: return " = ";
    default: return nullptr;
  }
}

const char* prefix(Op op) {
  switch (op) {
    case Op::Negate: return "-";
    case Op::Complement: return "~";
    case Op::Not: return "!";
    default: return nullptr;
  }
}

std::string function_text(const Node& node) {
  switch (node.op) {
    case Op::Convert: return spelling(node.type.scalar);
    case Op::Saturate: return "sat " + spelling(node.type.scalar);
    case Op::Abs: return "abs";
    case Op::Floor: return "floor";
    case Op::Ceil: return "ceil";
    case Op::Round: return "round";
    case Op::SquareRoot: return "sqrt";
    case Op::Math: return pixelflow::name(node.math);
    case Op::Noise: return "noise";
    case Op::CellNoise: return "cellnoise";
    case Op::Turbulence: return "turbulence";
    case Op::Texture: return "texture";
    case Op::Environment: return "environment";
    case Op::Call: return node.function ? node.function->name : "function";
    default: return "";
  }
}

std::string list(const Node& node) {
  std::string text;
  for (const NodePtr& operand : node.operands) text += (text.empty() ? "" : ", ") + uniform_text(*operand);
  return text;
}

/// As an operand of something else.
std::string inner(const Node& node) {
  const bool bare = infix(node.op) == nullptr && node.op != Op::Select;
  return bare ? uniform_text(node) : "(" + uniform_text(node) + ")";
}

}  // namespace

std::string uniform_text(const Node& node) {
  const auto& operands = node.operands;
  switch (node.op) {
    case Op::Literal: return literal_text(node);
    case Op::Variable: return node.variable->name;
    case Op::Element: return uniform_text(*operands[0]) + "[" + uniform_text(*operands[1]) + "]";
    case Op::Array: return "{" + list(node) + "}";
    case Op::Select: return inner(*operands[0]) + " ? " + inner(*operands[1]) + " : " + inner(*operands[2]);
    case Op::Sequence: return "(" + list(node) + ")";
    default: break;
  }
  if (const char* text = infix(node.op)) return inner(*operands[0]) + text + inner(*operands[1]);
  if (const char* text = prefix(node.op)) return text + inner(*operands[0]);
  return function_text(node) + "(" + list(node) + ")";
}

}  // namespace pfman
