// The code as text: --dump=ssa and listings.
#include <algorithm>
#include <set>
#include <string>

#include "pixelflow/compiler/instruction_text.h"
#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/uniform_text.h"
#include "pixelflow/microcode/library.h"

namespace pfman::ir {
namespace {

using Kind = Instruction::Kind;
using pixelflow::Code;

const char* infix(Code code) {
  switch (code) {
    case Code::Add:
    case Code::FloatAdd: return " + ";
    case Code::Sub:
    case Code::FloatSub: return " - ";
    case Code::Multiply:
    case Code::FloatMultiply: return " * ";
    case Code::Divide:
    case Code::FloatDivide: return " / ";
    case Code::Remainder: return " % ";
    case Code::Less:
    case Code::FloatLess: return " < ";
    case Code::LessEqual:
    case Code::FloatLessEqual: return " <= ";
    case Code::Equal:
    case Code::FloatEqual: return " == ";
    default: return nullptr;
  }
}

class Writer {
 public:
  Writer(const ir::Code& code, const Diagnostics& diagnostics) : code_(code), diagnostics_(diagnostics) {}

  std::string write() {
    std::string out = code_.kind == Shader::Kind::Surface ? "surface " : "light ";
    out += code_.name + "\n";
    Location last;
    for (std::size_t i = 0; i < code_.code.size(); ++i) {
      const Instruction& instruction = code_.code[i];
      if (ends(instruction.kind) && depth_ > 0) --depth_;
      std::string line(static_cast<std::size_t>(2 * depth_ + 2), ' ');
      line += text(instruction);
      if (begins(instruction.kind)) ++depth_;
      // The place stands where it changes.
      const Location& where = instruction.where;
      if (where.line != 0 && (where.line != last.line || where.file != last.file)) {
        constexpr std::size_t kPlaceColumn = 60;
        line.resize(std::max(kPlaceColumn, line.size() + 2), ' ');
        line += "// " + diagnostics_.place(where);
        last = where;
      }
      out += line + "\n";
    }
    if (!code_.color.empty()) {
      out += "  color:";
      for (const int v : code_.color) out += " " + name_of(v);
      out += "\n";
    }
    return out;
  }

 private:
  static bool begins(Kind kind) {
    return kind == Kind::If || kind == Kind::Else || kind == Kind::Loop || kind == Kind::IfMasked ||
           kind == Kind::ElseMasked;
  }
  static bool ends(Kind kind) {
    return kind == Kind::Else || kind == Kind::EndIf || kind == Kind::EndLoop || kind == Kind::ElseMasked ||
           kind == Kind::EndIfMasked;
  }

  std::string uniform(int n) const {
    return n >= 0 && code_.uniforms[static_cast<std::size_t>(n)]
               ? uniform_text(*code_.uniforms[static_cast<std::size_t>(n)])
               : "";
  }

  /// φ(i2,i3) where the variable is the result of a φ-function: with what it may choose from in the end.
  std::string name_of(int variable) const {
    const auto phi_of = [&](int v) {
      return std::find_if(code_.phis.begin(), code_.phis.end(), [&](const Phi& phi) { return phi.d == v; });
    };
    if (phi_of(variable) == code_.phis.end()) return label(code_.variables[variable]);
    std::set<int> seen{variable};
    std::vector<int> open{variable}, chosen;
    while (!open.empty()) {
      const int v = open.back();
      open.pop_back();
      const auto phi = phi_of(v);
      if (phi == code_.phis.end()) {
        chosen.push_back(v);
        continue;
      }
      for (const int operand : phi->operands) {
        if (seen.insert(operand).second) open.push_back(operand);
      }
    }
    std::sort(chosen.begin(), chosen.end(),
              [&](int a, int b) { return code_.variables[a].versions < code_.variables[b].versions; });
    std::string text = "φ(";
    for (const int v : chosen) text += (v == chosen.front() ? "" : ",") + label(code_.variables[v]);
    return text + ")";
  }

  /// Bytes are named where they are not the whole variable.
  std::string operand(const Operand& o) const {
    if (o.kind == Operand::Kind::Uniform) return uniform(o.uniform);
    if (o.kind == Operand::Kind::None) return "K";
    const Variable& variable = code_.variables[o.variable];
    std::string text = name_of(o.variable);
    if (o.index >= 0) text += "[" + uniform(o.index) + "]";
    if (o.offset != 0 || (o.index < 0 && o.bytes != variable.bytes())) {
      text += "{" + std::to_string(o.offset) + ":" + std::to_string(o.bytes) + "}";
    }
    return text;
  }

  std::string operation(const Instruction& i) const {
    std::string text;
    if (const char* sign = infix(i.code)) {
      text = operand(i.a) + sign + operand(i.b);
    } else if (i.code == Code::Copy) {
      text = operand(i.a);
    } else {
      text = std::string(pixelflow::name(i.code)) + "(" + operand(i.a) + (i.b ? ", " + operand(i.b) : "") + ")";
    }
    if (takes_scale(i.code) && i.scale != 0) text += " scale " + std::to_string(i.scale);
    return text;
  }

  std::string text(const Instruction& i) const {
    const auto result = [&](const std::string& value) { return (i.d ? operand(i.d) : "K") + " = " + value; };
    const auto joined = [&](const char* sign) { return result(operand(i.a) + sign + operand(i.b)); };
    switch (i.kind) {
      case Kind::Operate: return result(operation(i));
      case Kind::And: return joined(" & ");
      case Kind::Or: return joined(" | ");
      case Kind::Xor: return joined(" ^ ");
      case Kind::Select: return result(operand(i.condition) + " ? " + operand(i.a) + " : " + operand(i.b));
      case Kind::Uniform: return "uniform " + uniform(i.uniform);
      case Kind::If: return "if uniform (" + uniform(i.uniform) + ")";
      case Kind::Else:
      case Kind::ElseMasked: return "else";
      case Kind::EndIf:
      case Kind::EndIfMasked: return "end if";
      case Kind::Loop: return std::string(i.mask >= 0 ? "loop, masked" : "loop");
      case Kind::LoopTest: return "while (" + uniform(i.uniform) + ")";
      case Kind::LoopNext: return "next";
      case Kind::EndLoop: return "end loop";
      case Kind::Break: return "break";
      case Kind::Continue: return "continue";
      case Kind::IfMasked: return "if (" + operand(i.condition) + ")";
      case Kind::BreakMasked: return "break, masked";
      case Kind::ContinueMasked: return "continue, masked";
      case Kind::Lookup:
        return result(std::string(i.environment ? "environment" : "texture") + "(" + uniform(i.uniform) + ", " +
                      operand(i.a) + ")");
      case Kind::External: {
        std::string call = i.external->name + "(";
        for (std::size_t n = 0; n < i.arguments.size(); ++n) call += (n ? ", " : "") + operand(i.arguments[n]);
        return call + ")";
      }
      case Kind::Stage: return i.stage == 1 ? "illum:" : "post-illum:";
    }
    return "";
  }

  const ir::Code& code_;
  const Diagnostics& diagnostics_;
  int depth_ = 0;
};

}  // namespace

std::string dump(const ir::Code& code, const Diagnostics& diagnostics) { return Writer(code, diagnostics).write(); }

}  // namespace pfman::ir
