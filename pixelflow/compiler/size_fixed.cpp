// From the root of a fixed-point expression to its leaves: each node is asked for no more integer and fraction bits
// than its parent uses (Olano and Lastra 1998, section 6.3.2). Dropping high bits never changes what is stored, since
// sums, products and constant shifts commute with reduction modulo a power of two; low bits are only dropped at
// products and quotients, which keep kGuard more of them where a sum follows.
#include "pixelflow/compiler/size_fixed.h"

#include <algorithm>

#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/host_numbers.h"

namespace pfman {
namespace {

using Op = Node::Op;

constexpr int kGuard = 4;
constexpr int kAll = 1 << 24;
constexpr int kWidest = 64;

struct Demand {
  int integer;   ///< integer bits, the sign among them
  int fraction;  ///< fraction bits
  bool under = false;
};
constexpr Demand kEverything{kAll, kAll, false};

const char* named(Op op) {
  switch (op) {
    case Op::Negate:
    case Op::Subtract: return "the result of '-'";
    case Op::Add: return "the result of '+'";
    case Op::Multiply: return "the result of '*'";
    case Op::Divide: return "the result of '/'";
    case Op::Remainder: return "the result of '%'";
    case Op::ShiftLeft: return "the result of '<<'";
    case Op::ShiftRight: return "the result of '>>'";
    case Op::BitAnd: return "the result of '&'";
    case Op::BitOr: return "the result of '|'";
    case Op::BitXor: return "the result of '^'";
    case Op::Select: return "what two branches have in common";
    case Op::Array: return "what the elements of an array have in common";
    default: return "the value here";
  }
}

NodePtr aligned(NodePtr node, const Scalar& scalar) {
  if (node->type.scalar == scalar) return node;
  if (node->op == Op::Literal) {
    node->raw = convert(node->raw, node->type.scalar, scalar);
    node->type.scalar = scalar;
    node->exact = scalar;
    return node;
  }
  auto conversion = std::make_unique<Node>();
  conversion->op = Op::Convert;
  conversion->where = node->where;
  conversion->type = node->type;
  conversion->type.scalar = scalar;
  conversion->exact = scalar;
  conversion->operands.push_back(std::move(node));
  return conversion;
}

class Sizer {
 public:
  explicit Sizer(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void root(Node& node) {
    reported_ = false;
    size(node, kEverything);
  }

 private:
  void size(Node& node, Demand demand);
  void roots(Node& node, std::size_t first = 0) {
    for (std::size_t n = first; n < node.operands.size(); ++n) size(*node.operands[n], kEverything);
  }
  void convert(Node& node, const Demand& demand);
  void shift(Node& node, const Demand& demand);
  void parts(Node& node, const Demand& demand, std::size_t first);
  void multiply(Node& node, const Demand& demand);
  void align_exactly(const Node& node);

  /// Gives the node its final type: `size` bits at `exponent`, less what is above the integer bits wanted.
  void set(Node& node, int size, int exponent, const Demand& demand) {
    Scalar& scalar = node.type.scalar;
    scalar = node.exact;
    scalar.exponent = exponent;
    scalar.size = std::max(1, std::min(size, demand.integer + exponent));
    if (scalar.size > kWidest) report(node, std::string(named(node.op)), scalar.size);
  }
  /// A sum's type: what its operands hand on, with its own integer bits.
  void set_sum(Node& node, int exponent, const Demand& demand) {
    set(node, node.exact.magnitude() + exponent + node.exact.sign_bits(), exponent, demand);
  }
  void report(const Node& node, const std::string& what, int bits) {
    if (reported_) return;
    reported_ = true;
    diagnostics_.add(210, node.where, what + " needs " + std::to_string(bits) + " bits; 64 are possible");
  }

  Diagnostics& diagnostics_;
  bool reported_ = false;
};

void Sizer::size(Node& node, Demand demand) {
  if (node.precise) {
    demand.fraction = kAll;
    demand.under = false;
  }
  node.under = demand.under;
  const int extra = demand.under ? kGuard : 0;
  const Scalar exact = node.exact;
  switch (node.op) {
    case Op::Convert:
    case Op::Saturate: return convert(node, demand);
    case Op::Sequence:
      for (std::size_t n = 0; n + 1 < node.operands.size(); ++n) size(*node.operands[n], kEverything);
      size(*node.operands.back(), demand);
      node.type.scalar = node.operands.back()->type.scalar;
      return;
    case Op::Assign: {
      size(*node.operands[0], kEverything);
      const Scalar& target = node.operands[0]->type.scalar;
      size(*node.operands[1], {target.size - target.exponent, target.exponent, false});
      node.type.scalar = target;
      return;
    }
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::NotEqual:
      roots(node);
      align_exactly(node);
      return;
    case Op::Select: size(*node.operands[0], kEverything); return parts(node, demand, 1);
    case Op::Array: return parts(node, demand, 0);
    default: break;
  }
  if (node.type.is_void || node.type.scalar.is_float) return roots(node);
  switch (node.op) {
    case Op::Literal:
      set(node, exact.size, exact.exponent, demand);
      node.raw = wrap(node.raw, node.type.scalar);
      return;
    case Op::Element: roots(node); return set(node, exact.size, exact.exponent, demand);
    case Op::Negate:
      size(*node.operands[0], demand);
      return set_sum(node, node.operands[0]->type.scalar.exponent, demand);
    case Op::Add:
    case Op::Subtract:
      for (const NodePtr& operand : node.operands) size(*operand, {demand.integer, demand.fraction, true});
      return set_sum(node, std::max(node.operands[0]->type.scalar.exponent, node.operands[1]->type.scalar.exponent),
                     demand);
    case Op::Multiply: return multiply(node, demand);
    case Op::Divide: {
      roots(node);
      const int exponent = std::min(exact.exponent, demand.fraction + extra);
      return set(node, exact.size - (exact.exponent - exponent), exponent, demand);
    }
    case Op::Remainder:
      roots(node);
      align_exactly(node);
      return set(node, exact.size, exact.exponent, demand);
    case Op::ShiftLeft:
    case Op::ShiftRight: return shift(node, demand);
    case Op::BitAnd:
    case Op::BitOr:
    case Op::BitXor:
      for (const NodePtr& operand : node.operands) size(*operand, {demand.integer, kAll, false});
      return set(node, exact.size, exact.exponent, demand);
    case Op::Complement:
      size(*node.operands[0], {demand.integer, kAll, demand.under});
      return set(node, exact.size, exact.exponent, demand);
    case Op::SquareRoot:
      roots(node);
      if (node.operands[0]->type.scalar.exponent > kWidest) {
        report(node, "the root of a number with so many fraction bits", node.operands[0]->type.scalar.exponent);
      }
      return set(node, exact.size, exact.exponent, demand);
    case Op::Abs:
    case Op::Floor:
    case Op::Ceil:
    case Op::Round: roots(node); return set(node, exact.size, exact.exponent, demand);
    case Op::Variable: return set(node, exact.size, exact.exponent, demand);
    default:
      // Calls, increments, noise and lookups give what they give.
      roots(node);
      node.type.scalar = exact;
      return;
  }
}

void Sizer::convert(Node& node, const Demand& demand) {
  Node& source = *node.operands[0];
  const Scalar target = node.exact;
  if (source.type.scalar.is_float || target.is_float || target == Scalar::boolean()) {
    size(source, kEverything);
    node.type.scalar = target;
    return;
  }
  const bool saturates = node.op == Op::Saturate;
  size(source, {saturates ? kAll : target.size - target.exponent, target.exponent, false});
  if (saturates) {
    node.type.scalar = target;
    return;
  }
  set(node, target.size, target.exponent, demand);
  // A conversion to bool would compare with zero.
  if (node.type.scalar == Scalar::boolean()) node.type.scalar.size = 2;
}

void Sizer::shift(Node& node, const Demand& demand) {
  const bool left = node.op == Op::ShiftLeft;
  size(*node.operands[1], kEverything);
  if (node.operands[1]->op != Op::Literal) {
    size(*node.operands[0], kEverything);
    return set(node, node.exact.size, node.exact.exponent, demand);
  }
  const int places = static_cast<int>(node.operands[1]->raw) * (left ? 1 : -1);
  size(*node.operands[0], {demand.integer - places, demand.fraction + places, demand.under});
  const Scalar& inner = node.operands[0]->type.scalar;
  set(node, inner.size, inner.exponent - places, demand);
}

/// Branches of a Select and elements of an Array: all of one type in the end.
void Sizer::parts(Node& node, const Demand& demand, std::size_t first) {
  for (std::size_t n = first; n < node.operands.size(); ++n) size(*node.operands[n], demand);
  if (node.type.scalar.is_float) return;
  int exponent = node.operands[first]->type.scalar.exponent;
  bool alike = true;
  for (std::size_t n = first; n < node.operands.size(); ++n) {
    exponent = std::max(exponent, node.operands[n]->type.scalar.exponent);
  }
  set_sum(node, exponent, demand);
  for (std::size_t n = first; n < node.operands.size(); ++n) {
    alike = alike && node.operands[n]->type.scalar == node.type.scalar;
  }
  if (!alike && node.type.scalar == Scalar::boolean()) node.type.scalar.size = 2;
  for (std::size_t n = first; n < node.operands.size(); ++n) {
    node.operands[n] = aligned(std::move(node.operands[n]), node.type.scalar);
  }
}

void Sizer::multiply(Node& node, const Demand& demand) {
  Node &a = *node.operands[0], &b = *node.operands[1];
  const Scalar x = a.exact, y = b.exact;
  size(a, {demand.integer + y.exponent, demand.fraction + y.magnitude() + kGuard, false});
  size(b, {demand.integer + x.exponent, demand.fraction + x.magnitude() + kGuard, false});
  const int exponent =
      std::min(a.type.scalar.exponent + b.type.scalar.exponent, demand.fraction + (demand.under ? kGuard : 0));
  set(node, node.exact.size - (node.exact.exponent - exponent), exponent, demand);
}

/// Comparisons and remainders bring both operands to the greater exponent.
void Sizer::align_exactly(const Node& node) {
  const Scalar &a = node.operands[0]->type.scalar, &b = node.operands[1]->type.scalar;
  if (a.is_float) return;
  const int exponent = std::max(a.exponent, b.exponent);
  const int bits = std::max(a.size + exponent - a.exponent, b.size + exponent - b.exponent);
  if (bits > kWidest) report(node, "an operand, brought to the other one's exponent,", bits);
}

class UnitSizer {
 public:
  UnitSizer(Tree& tree, Diagnostics& diagnostics) : tree_(tree), diagnostics_(diagnostics) {}

  void run() {
    for (const NodePtr& constant : tree_.constants) expression(constant);
    for (const auto& function : tree_.functions) {
      statements(function->body);
      expression(function->value);
    }
    for (const auto& shader : tree_.shaders) {
      for (const ShaderParameter& parameter : shader->parameters) expression(parameter.initial);
      statements(shader->body);
    }
  }

 private:
  void expression(const NodePtr& node) {
    if (node) size_root(*node, diagnostics_);
  }
  void statement(const Statement& statement) {
    expression(statement.expression);
    statements(statement.body);
    if (statement.step) this->statement(*statement.step);
  }
  void statements(const std::vector<StatementPtr>& list) {
    for (const StatementPtr& one : list) statement(*one);
  }

  Tree& tree_;
  Diagnostics& diagnostics_;
};

}  // namespace

void size_root(Node& node, Diagnostics& diagnostics) { Sizer(diagnostics).root(node); }

void size_fixed(Tree& tree, Diagnostics& diagnostics) { UnitSizer(tree, diagnostics).run(); }

}  // namespace pfman
