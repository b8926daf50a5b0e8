// The typed tree as text.
#include <array>
#include <sstream>

#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/tree.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

const char* spelling(Node::Op op) {
  constexpr std::array kNames = {
      "literal",  "variable",    "element",   "array",      "negate",      "add",        "subtract",
      "multiply", "divide",      "remainder", "shift_left", "shift_right", "complement", "and_bits",
      "or_bits",  "xor_bits",    "less",      "less_equal", "equal",       "not_equal",  "not",
      "and",      "or",          "select",    "convert",    "saturate",    "abs",        "floor",
      "ceil",     "round",       "sqrt",      "math",       "noise",       "cellnoise",  "turbulence",
      "texture",  "environment", "assign",    "sequence",   "postfix",     "call",
  };
  static_assert(kNames.size() == static_cast<std::size_t>(Node::Op::Call) + 1);
  return kNames[static_cast<std::size_t>(op)];
}

/// U(8,8), S(36,32): as the language manual writes sizes.
std::string sizes(const Scalar& scalar) {
  return (scalar.is_signed ? "S(" : "U(") + std::to_string(scalar.size) + "," + std::to_string(scalar.exponent) + ")";
}

class TreeText {
 public:
  std::string text() const { return out_.str(); }

  void line(int depth, const std::string& text) {
    out_ << std::string(static_cast<std::size_t>(2 * depth), ' ') << text << '\n';
  }

  void node(const Node& node, int depth) {
    std::string text = spelling(node.op);
    if (node.op == Node::Op::Literal) text += " " + number(node);
    if (node.variable != nullptr) text += " " + named(*node.variable);
    if (node.function != nullptr) text += " " + node.function->name;
    if (node.op == Node::Op::Math) text += std::string(" ") + pixelflow::name(node.math);
    text += " : ";
    if (node.type.is_void) {
      text += "void";
    } else {
      text += node.type.varying ? "varying " : "uniform ";
      text += pfman::spelling(node.type);
      if (!node.type.scalar.is_float) text += ", " + sizes(node.exact) + " -> " + sizes(node.type.scalar);
      if (node.under) text += " under a sum";
    }
    line(depth, text);
    for (const NodePtr& operand : node.operands) this->node(*operand, depth + 1);
  }

  void statements(const std::vector<StatementPtr>& list, int depth) {
    for (const StatementPtr& one : list) statement(*one, depth);
  }

  void variable(const std::string& what, const Variable& variable, int depth) {
    std::string text = what + " " + named(variable) + " : ";
    text += variable.type.varying ? "varying " : "uniform ";
    line(depth, text + pfman::spelling(variable.type));
  }

 private:
  static std::string named(const Variable& variable) {
    return variable.role == Variable::Role::Hidden ? variable.name + "#" + std::to_string(variable.id) : variable.name;
  }
  static std::string number(const Node& node) {
    std::ostringstream out;
    out.precision(17);
    out << to_double(node.raw, node.type.scalar);
    return out.str();
  }

  void statement(const Statement& statement, int depth) {
    using Kind = Statement::Kind;
    const std::string masked = statement.masked ? " masked" : "";
    switch (statement.kind) {
      case Kind::Evaluate: node(*statement.expression, depth); return;
      case Kind::Declare: variable("declare", *statement.variable, depth); return;
      case Kind::Block: line(depth, "block"); break;
      case Kind::If: line(depth, statement.expression->type.varying ? "if masked" : "if"); break;
      case Kind::Loop: {
        std::string text = statement.test_last ? "loop tested last" : "loop";
        if (statement.masked_breaks) text += ", masked breaks";
        if (statement.masked_continues) text += ", masked continues";
        line(depth, text);
        break;
      }
      case Kind::Break: line(depth, "break" + masked); return;
      case Kind::Continue: line(depth, "continue" + masked); return;
      case Kind::Illuminance: line(depth, "illuminance"); break;
    }
    if (statement.expression) {
      line(depth + 1, "condition");
      node(*statement.expression, depth + 2);
    }
    statements(statement.body, depth + 1);
    if (statement.step) {
      line(depth + 1, "step");
      this->statement(*statement.step, depth + 2);
    }
  }

  std::ostringstream out_;
};

}  // namespace

std::string dump(const Tree& tree) {
  TreeText text;
  for (const NodePtr& constant : tree.constants) text.node(*constant, 0);
  for (const auto& function : tree.functions) {
    const std::string kind = function->is_external ? "external function " : "function ";
    text.line(0, kind + function->name + " : " + spelling(function->result));
    for (const Variable* parameter : function->parameters) {
      text.variable(parameter->output ? "output parameter" : "parameter", *parameter, 1);
    }
    text.statements(function->body, 1);
    if (function->value) {
      text.line(1, "return");
      text.node(*function->value, 2);
    }
  }
  for (const auto& shader : tree.shaders) {
    text.line(0, (shader->kind == Shader::Kind::Surface ? "surface " : "light ") + shader->name);
    for (const ShaderParameter& parameter : shader->parameters) {
      text.variable(parameter.used ? "parameter" : "unused parameter", *parameter.variable, 1);
      if (parameter.initial) text.node(*parameter.initial, 2);
    }
    text.statements(shader->body, 1);
  }
  return text.text();
}

}  // namespace pfman
