#include "tests/pfman_shading/masked_code.h"

#include <algorithm>

namespace pfman_tests {
namespace {

using namespace pfman;
using Kind = MaskedStatement::Kind;
using Op = Node::Op;
using IrKind = ir::Instruction::Kind;

const Scalar kByte = Scalar::fixed(false, 8, 0);

enum class Way { On, Break, Continue };

/// A uniform break takes those pixels along that have left the iteration before.
bool ends_for_all(const std::vector<MaskedStatement>& body, int iteration) {
  for (const MaskedStatement& s : body) {
    if (s.number != iteration) continue;
    if (s.kind == Kind::BreakAll) return true;
    if (s.kind == Kind::ContinueAll) return false;
  }
  return false;
}

Way execute(const std::vector<MaskedStatement>& block, State& state, int iteration) {
  for (const MaskedStatement& s : block) {
    const auto to = static_cast<std::size_t>(s.to), from = static_cast<std::size_t>(s.from);
    switch (s.kind) {
      case Kind::Add: state[to] = static_cast<std::uint8_t>(state[to] + state[from] + s.number); break;
      case Kind::If: {
        const Way way = execute(state[from] < s.number ? s.first : s.second, state, iteration);
        if (way != Way::On) return way;
        break;
      }
      case Kind::Loop:
        for (int i = 0; i < s.number; ++i) {
          if (execute(s.first, state, i) == Way::Break || ends_for_all(s.first, i)) break;
        }
        break;
      case Kind::Break: return Way::Break;
      case Kind::Continue: return Way::Continue;
      case Kind::BreakAll:
        if (iteration == s.number) return Way::Break;
        break;
      case Kind::ContinueAll:
        if (iteration == s.number) return Way::Continue;
        break;
    }
  }
  return Way::On;
}

/// A jump of the pixel's own that belongs to the loop around the block.
bool jumps(const std::vector<MaskedStatement>& block, Kind kind) {
  return std::any_of(block.begin(), block.end(), [&](const MaskedStatement& s) {
    return s.kind == kind || (s.kind == Kind::If && (jumps(s.first, kind) || jumps(s.second, kind)));
  });
}

ir::Operand pixel(int variable) {
  ir::Operand operand;
  operand.kind = ir::Operand::Kind::Pixel;
  operand.variable = variable;
  operand.bytes = 1;
  return operand;
}

NodePtr node(Op op, const Scalar& scalar, std::vector<NodePtr> operands = {}) {
  auto made = std::make_unique<Node>();
  made->op = op;
  made->type.scalar = scalar;
  made->operands = std::move(operands);
  return made;
}
NodePtr literal(int value) {
  NodePtr made = node(Op::Literal, Scalar::integer());
  made->raw = static_cast<std::uint64_t>(value);
  return made;
}
NodePtr reference(Variable* variable) {
  NodePtr made = node(Op::Variable, variable->type.scalar);
  made->variable = variable;
  return made;
}
NodePtr two(Op op, const Scalar& scalar, NodePtr a, NodePtr b) {
  std::vector<NodePtr> operands;
  operands.push_back(std::move(a));
  operands.push_back(std::move(b));
  return node(op, scalar, std::move(operands));
}

ir::Instruction marker(IrKind kind, int match = -1) {
  ir::Instruction i;
  i.kind = kind;
  i.match = match;
  return i;
}

}  // namespace

MaskedProgram::MaskedProgram(std::mt19937_64& random, int depth) {
  shader_.name = "masks";
  compiled_.shader = &shader_;
  compiled_.tree = &tree_;
  ir::Code& code = compiled_.code;
  for (int n = 0; n <= kBytes; ++n) {  // the last one for conditions
    ir::Variable variable;
    variable.scalar = kByte;
    code.variables.push_back(variable);
    compiled_.map.address.push_back(kStateAt + n);
  }
  body_ = block(random, depth, {});
  write(body_, 0);
  for (int bits = 8; bits < code.mask_bits; bits += 8) {
    ir::Variable variable;
    variable.scalar = kByte;
    code.mask_bytes.push_back(static_cast<int>(code.variables.size()));
    compiled_.map.address.push_back(kDeepMasksAt + bits / 8 - 1);
    code.variables.push_back(variable);
  }
}

std::vector<MaskedStatement> MaskedProgram::block(std::mt19937_64& random, int depth, Within within) {
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  std::vector<MaskedStatement> statements;
  const int count = 1 + below(3);
  for (int n = 0; n < count; ++n) {
    MaskedStatement s;
    s.to = below(kBytes);
    s.from = below(kBytes);
    s.number = below(256);
    const int kind = below(10);
    if (kind < 5 && depth > 0) {
      s.kind = Kind::If;
      s.by_byte = below(2) == 0;
      s.has_else = below(2) == 0;
      s.first = block(random, depth - 1, {within.loop, within.loop});
      if (s.has_else) s.second = block(random, depth - 1, {within.loop, within.loop});
    } else if (kind < 7 && depth > 0) {
      s.kind = Kind::Loop;
      s.number = below(4);
      s.first = block(random, depth - 1, {true, false});
    } else if (kind == 7 && within.loop) {
      s.number = below(3);
      if (within.masked) {
        s.kind = below(2) == 0 ? Kind::Break : Kind::Continue;
      } else {
        s.kind = below(2) == 0 ? Kind::BreakAll : Kind::ContinueAll;
      }
    }
    statements.push_back(std::move(s));
  }
  return statements;
}

void MaskedProgram::execute(State& state) const { pfman_tests::execute(body_, state, 0); }

int MaskedProgram::add(ir::Instruction instruction) {
  compiled_.code.code.push_back(std::move(instruction));
  return static_cast<int>(compiled_.code.code.size()) - 1;
}

int MaskedProgram::uniform(NodePtr tree) {
  compiled_.code.uniforms.push_back(std::move(tree));
  return static_cast<int>(compiled_.code.uniforms.size()) - 1;
}

void MaskedProgram::write(const std::vector<MaskedStatement>& block, int bits) {
  for (const MaskedStatement& s : block) {
    switch (s.kind) {
      case Kind::Add: {
        ir::Instruction i;
        i.code = pixelflow::Code::Add;
        i.d = i.a = pixel(s.to);
        i.b = pixel(s.from);
        add(i);
        i.b = {};
        i.b.kind = ir::Operand::Kind::Uniform;
        i.b.bytes = 1;
        i.b.uniform = uniform(literal(s.number));
        add(i);
        break;
      }
      case Kind::If: write_if(s, bits); break;
      case Kind::Loop: write_loop(s, bits); break;
      case Kind::Break:
      case Kind::Continue:
        add(marker(s.kind == Kind::Break ? IrKind::BreakMasked : IrKind::ContinueMasked, loops_.back().at));
        break;
      case Kind::BreakAll:
      case Kind::ContinueAll: write_uniform_jump(s); break;
    }
  }
}

void MaskedProgram::write_if(const MaskedStatement& s, int bits) {
  ir::Code& code = compiled_.code;
  const int used = bits + (s.has_else ? 2 : 1);
  code.mask_bits = std::max(code.mask_bits, used);
  ir::Instruction compare;
  compare.code = pixelflow::Code::Less;
  compare.a = pixel(s.from);
  compare.b.kind = ir::Operand::Kind::Uniform;
  compare.b.bytes = 1;
  compare.b.uniform = uniform(literal(s.number));
  if (s.by_byte) compare.d = pixel(kBytes);
  add(compare);
  ir::Instruction opening = marker(IrKind::IfMasked);
  opening.mask = bits;
  if (s.by_byte) opening.condition = pixel(kBytes);
  const int at = add(opening);
  write(s.first, used);
  int before = at;
  if (s.has_else) {
    before = add(marker(IrKind::ElseMasked));
    code.code[static_cast<std::size_t>(at)].match = before;
    write(s.second, used);
  }
  const int end = add(marker(IrKind::EndIfMasked, at));
  code.code[static_cast<std::size_t>(before)].match = end;
}

void MaskedProgram::write_loop(const MaskedStatement& s, int bits) {
  ir::Code& code = compiled_.code;
  auto owned = std::make_unique<Variable>();
  owned->type.scalar = Scalar::integer();
  Variable* const counter = owned.get();
  code.uniform_variables.push_back(std::move(owned));

  ir::Instruction evaluate = marker(IrKind::Uniform);
  evaluate.uniform = uniform(two(Op::Assign, counter->type.scalar, reference(counter), literal(0)));
  add(evaluate);
  ir::Instruction opening = marker(IrKind::Loop);
  opening.masked_breaks = jumps(s.first, Kind::Break);
  opening.masked_continues = jumps(s.first, Kind::Continue);
  const bool masked = opening.masked_breaks || opening.masked_continues;
  opening.mask = masked ? bits : -1;
  const int used = bits + (masked ? 1 + (opening.masked_breaks ? 1 : 0) + (opening.masked_continues ? 1 : 0) : 0);
  code.mask_bits = std::max(code.mask_bits, used);
  const int at = add(opening);
  ir::Instruction test = marker(IrKind::LoopTest, at);
  test.uniform = uniform(two(Op::Less, Scalar::boolean(), reference(counter), literal(s.number)));
  add(test);
  loops_.push_back({at, counter});
  write(s.first, used);
  loops_.pop_back();
  add(marker(IrKind::LoopNext, at));
  const Scalar type = counter->type.scalar;
  evaluate.uniform =
      uniform(two(Op::Assign, type, reference(counter), two(Op::Add, type, reference(counter), literal(1))));
  add(evaluate);
  code.code[static_cast<std::size_t>(at)].match = add(marker(IrKind::EndLoop, at));
}

void MaskedProgram::write_uniform_jump(const MaskedStatement& s) {
  ir::Code& code = compiled_.code;
  ir::Instruction opening = marker(IrKind::If);
  opening.uniform = uniform(two(Op::Equal, Scalar::boolean(), reference(loops_.back().counter), literal(s.number)));
  const int at = add(opening);
  add(marker(s.kind == Kind::BreakAll ? IrKind::Break : IrKind::Continue, loops_.back().at));
  code.code[static_cast<std::size_t>(at)].match = add(marker(IrKind::EndIf, at));
}

}  // namespace pfman_tests
