#include "tests/pfman_check/checked.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "pixelflow/compiler/check.h"
#include "pixelflow/compiler/host.h"
#include "pixelflow/compiler/size_fixed.h"
#include "pixelflow/language/parser.h"
#include "pixelflow/microcode/library.h"

namespace pfman_tests {
namespace {

using pfman::Node;
using pfman::Statement;
using pfman::StatementPtr;
using Op = Node::Op;

class Writer {
 public:
  std::string formula(const Node& node) {
    const auto operand = [&](std::size_t n) { return formula(*node.operands.at(n)); };
    const auto infix = [&](const char* op) { return "(" + operand(0) + " " + op + " " + operand(1) + ")"; };
    const auto listed = [&](const std::string& open, const std::string& close) {
      std::string text = open;
      for (std::size_t n = 0; n < node.operands.size(); ++n) text += (n > 0 ? ", " : "") + operand(n);
      return text + close;
    };
    switch (node.op) {
      case Op::Literal: return number(node);
      case Op::Variable: return name(*node.variable);
      case Op::Element: return operand(0) + "[" + operand(1) + "]";
      case Op::Array: return listed("{", "}");
      case Op::Negate: return "-" + operand(0);
      case Op::Add: return infix("+");
      case Op::Subtract: return infix("-");
      case Op::Multiply: return infix("*");
      case Op::Divide: return infix("/");
      case Op::Remainder: return infix("%");
      case Op::ShiftLeft: return infix("<<");
      case Op::ShiftRight: return infix(">>");
      case Op::Complement: return "~" + operand(0);
      case Op::BitAnd: return infix("&");
      case Op::BitOr: return infix("|");
      case Op::BitXor: return infix("^");
      case Op::Less: return infix("<");
      case Op::LessEqual: return infix("<=");
      case Op::Equal: return infix("==");
      case Op::NotEqual: return infix("!=");
      case Op::Not: return "!" + operand(0);
      case Op::And: return infix("&&");
      case Op::Or: return infix("||");
      case Op::Select: return "(" + operand(0) + " ? " + operand(1) + " : " + operand(2) + ")";
      case Op::Convert: return pfman::spelling(node.type.scalar) + "(" + operand(0) + ")";
      case Op::Saturate: return "sat " + pfman::spelling(node.type.scalar) + "(" + operand(0) + ")";
      case Op::Abs: return "abs(" + operand(0) + ")";
      case Op::Floor: return "floor(" + operand(0) + ")";
      case Op::Ceil: return "ceil(" + operand(0) + ")";
      case Op::Round: return "round(" + operand(0) + ")";
      case Op::SquareRoot: return "sqrt(" + operand(0) + ")";
      case Op::Math: return listed(std::string(pixelflow::name(node.math)) + "(", ")");
      case Op::Noise: return listed("noise(", ")");
      case Op::CellNoise: return listed("cellnoise(", ")");
      case Op::Turbulence: return listed("turbulence(", ")");
      case Op::Texture: return listed("texture" + std::to_string(node.type.dimensions[0]) + "(", ")");
      case Op::Environment: return listed("environment(", ")");
      case Op::Assign: return operand(0) + " = " + operand(1);
      case Op::Sequence: return listed("(", ")");
      case Op::Postfix: return operand(0) + "++ = " + operand(1);
      case Op::Call: return listed(node.function->name + "(", ")");
    }
    throw std::logic_error("a node of no kind");
  }

  void statements(const std::vector<StatementPtr>& list, int depth) {
    for (const StatementPtr& one : list) statement(*one, depth);
  }
  std::string text() const { return out_.str(); }

 private:
  std::string name(const pfman::Variable& variable) {
    if (variable.role != pfman::Variable::Role::Hidden) return variable.name;
    const auto [at, is_new] = hidden_.emplace(&variable, static_cast<int>(hidden_.size()) + 1);
    return "v" + std::to_string(at->second);
  }
  static std::string number(const Node& node) {
    std::ostringstream out;
    out << pfman::to_double(node.raw, node.type.scalar);
    return out.str();
  }
  void line(int depth, const std::string& text) {
    out_ << std::string(static_cast<std::size_t>(2 * depth), ' ') << text << '\n';
  }

  void statement(const Statement& statement, int depth) {
    const std::string masked = statement.masked ? "masked " : "";
    switch (statement.kind) {
      case Statement::Kind::Evaluate: return line(depth, formula(*statement.expression));
      case Statement::Kind::Declare: return line(depth, "declare " + statement.variable->name);
      case Statement::Kind::Break: return line(depth, masked + "break");
      case Statement::Kind::Continue: return line(depth, masked + "continue");
      case Statement::Kind::Block: return statements(statement.body, depth);
      case Statement::Kind::Illuminance: line(depth, "illuminance"); break;
      case Statement::Kind::If: {
        const std::string rate = statement.expression->type.varying ? "if masked " : "if ";
        line(depth, rate + formula(*statement.expression));
        statements(statement.body[0]->body, depth + 1);
        if (statement.body.size() < 2) return;
        line(depth, "else");
        return statements(statement.body[1]->body, depth + 1);
      }
      case Statement::Kind::Loop: {
        std::string text = statement.test_last ? "do" : "while";
        if (statement.masked_breaks) text += " with masked breaks";
        if (statement.masked_continues) text += " with masked continues";
        if (statement.expression) text += " " + formula(*statement.expression);
        line(depth, text);
        statements(statement.body, depth + 1);
        if (statement.step) {
          line(depth, "step");
          this->statement(*statement.step, depth + 1);
        }
        return;
      }
    }
    statements(statement.body, depth + 1);
  }

  std::ostringstream out_;
  std::map<const pfman::Variable*, int> hidden_;
};

}  // namespace

Checked::Checked(const std::string& text) {
  unit_ = pfman::parse_text(text, "t.pfman", {}, diagnostics_);
  if (diagnostics_.has_errors()) return;
  tree_ = pfman::check(unit_, diagnostics_);
  if (!diagnostics_.has_errors()) pfman::size_fixed(tree_, diagnostics_);
}

const pfman::Shader& Checked::shader(const std::string& name) const {
  for (const auto& shader : tree_.shaders) {
    if (shader->name == name) return *shader;
  }
  throw std::logic_error("no shader " + name + "; " + messages());
}

const pfman::Function& Checked::function(const std::string& name) const {
  for (const auto& function : tree_.functions) {
    if (function->name == name) return *function;
  }
  throw std::logic_error("no function " + name + "; " + messages());
}

std::string Checked::statements(const std::string& name) const {
  Writer writer;
  writer.statements(shader(name).body, 0);
  return writer.text();
}

std::string formula(const Node& node) { return Writer().formula(node); }

std::string surface(const std::string& statements, const std::string& parameters) {
  return "surface s(output varying fixed<8,8> px_shader_color[3]" + (parameters.empty() ? "" : "; " + parameters) +
         ") {\n" + statements + "\n}\n";
}

}  // namespace pfman_tests
