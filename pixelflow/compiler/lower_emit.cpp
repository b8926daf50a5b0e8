// Instructions one by one, trees for the host, and control flow on the host.
#include "pixelflow/compiler/lower_emit.h"

#include "cmodel/pixelflow/macro.h"

namespace pfman {
namespace {

/// Far beyond what fits a stream; calls within calls, written in place, would otherwise grow without end. Lifetimes are
/// matrices of instructions and variables: for so many they take a second.
constexpr std::size_t kMostInstructions = 20000;

constexpr int kTooLong = 503;
constexpr int kTooWide = 210;

bool is_uniform_operand(const ir::Operand& operand) { return operand.kind == ir::Operand::Kind::Uniform; }

}  // namespace

int bytes_of(int bits) { return (bits + 7) / 8; }

void Emitter::error(const std::string& text) { diagnostics_.add(kTooWide, where_, text); }

void Emitter::too_long(const std::string& limit) {
  if (too_long_) return;
  too_long_ = true;
  diagnostics_.add(kTooLong, shader_.where, "'" + shader_.name + "' is longer than " + limit);
}

int Emitter::append(ir::Instruction instruction) {
  if (code_.code.size() >= kMostInstructions) {
    too_long(std::to_string(kMostInstructions) + " operations once its calls are written in place");
  }
  instruction.where = where_;
  code_.code.push_back(std::move(instruction));
  return static_cast<int>(code_.code.size()) - 1;
}

int Emitter::add_variable(const std::string& name, const Scalar& scalar, int count, bool temporary) {
  ir::Variable variable;
  variable.name = name.empty() ? "t" + std::to_string(++temporaries_) : name;
  variable.scalar = scalar;
  variable.count = count;
  variable.temporary = temporary;
  variable.where = where_;
  code_.variables.push_back(std::move(variable));
  return static_cast<int>(code_.variables.size()) - 1;
}

ir::Operand Emitter::whole(int variable, int element) const {
  const Scalar& scalar = code_.variables[static_cast<std::size_t>(variable)].scalar;
  ir::Operand operand;
  operand.kind = ir::Operand::Kind::Pixel;
  operand.is_signed = scalar.is_signed;
  operand.variable = variable;
  operand.bytes = scalar.bytes();
  operand.offset = element * operand.bytes;
  return operand;
}

ir::Operand Emitter::constant(std::uint64_t raw, const Scalar& type) {
  return uniform_value(make_literal(type, raw, where_)).at;
}

/// Operations without a number in pixel memory do not exist: where everything is the same in all pixels, one operand
/// is stored first.
ir::Operand Emitter::pixel(const ir::Operand& operand) {
  if (!is_uniform_operand(operand)) return operand;
  const ir::Operand stored = temporary(code_.uniforms[static_cast<std::size_t>(operand.uniform)]->type.scalar);
  operate_into(stored, Code::Copy, operand);
  return stored;
}

void Emitter::operate_into(const ir::Operand& d, Code code, ir::Operand a, ir::Operand b, int scale) {
  if (code != Code::Copy && is_uniform_operand(a) && (!b || is_uniform_operand(b))) a = pixel(a);
  ir::Instruction instruction;
  instruction.code = code;
  instruction.scale = scale;
  instruction.d = d;
  instruction.a = a;
  instruction.b = b;
  append(std::move(instruction));
}

ir::Operand Emitter::operate(Code code, const Scalar& type, ir::Operand a, ir::Operand b, int scale) {
  const ir::Operand d = temporary(type);
  operate_into(d, code, a, b, scale);
  return d;
}

ir::Operand Emitter::join(Kind kind, const Scalar& type, ir::Operand a, ir::Operand b) {
  if (is_uniform_operand(a) && is_uniform_operand(b)) a = operate(Code::Copy, type, a);  // in all bytes of the result
  ir::Instruction instruction;
  instruction.kind = kind;
  instruction.d = temporary(type);
  a.bytes = b.bytes = instruction.d.bytes;
  instruction.a = a;
  instruction.b = b;
  const ir::Operand d = instruction.d;
  append(std::move(instruction));
  return d;
}

ir::Operand Emitter::select(const ir::Operand& condition, const Scalar& type, const ir::Operand& a,
                            const ir::Operand& b) {
  ir::Instruction instruction;
  instruction.kind = Kind::Select;
  instruction.d = temporary(type);
  instruction.condition = condition;
  instruction.a = a;
  instruction.b = b;
  instruction.a.bytes = instruction.b.bytes = instruction.d.bytes;
  const ir::Operand d = instruction.d;
  append(std::move(instruction));
  return d;
}

int Emitter::begin_if(NodePtr condition) {
  ir::Instruction opening;
  opening.kind = Kind::If;
  opening.uniform = add_uniform(std::move(condition));
  return append(std::move(opening));
}

int Emitter::begin_else(int opening) {
  ir::Instruction middle;
  middle.kind = Kind::Else;
  return at(opening).match = append(std::move(middle));
}

void Emitter::end_if(int opening) {
  ir::Instruction closing;
  closing.kind = Kind::EndIf;
  closing.match = opening;
  const int end = append(std::move(closing));
  at(opening).match = end;
}

int Emitter::begin_loop() {
  ir::Instruction loop;
  loop.kind = Kind::Loop;
  return append(std::move(loop));
}

void Emitter::end_loop(int loop) {
  ir::Instruction closing;
  closing.kind = Kind::EndLoop;
  closing.match = loop;
  const int end = append(std::move(closing));
  at(loop).match = end;
}

int Emitter::add_uniform(NodePtr tree) {
  code_.uniforms.push_back(std::move(tree));
  return static_cast<int>(code_.uniforms.size()) - 1;
}

Term Emitter::uniform_value(NodePtr tree) {
  const Scalar type = tree->type.scalar;
  Term value;
  value.type = type;
  value.at.kind = ir::Operand::Kind::Uniform;
  value.at.is_signed = type.is_signed;
  value.at.bytes = type.bytes();
  value.at.uniform = add_uniform(std::move(tree));
  return value;
}

NodePtr Emitter::tree_of(const Term& value) const {
  return clone(*code_.uniforms[static_cast<std::size_t>(value.at.uniform)]);
}

Terms Emitter::elements_of(Variable* variable) {
  const NodePtr all = make_read(variable, where_);
  if (!variable->type.is_array()) return {uniform_value(clone(*all))};
  const int columns = variable->type.dimensions[1];
  Terms elements;
  for (int n = 0; n < variable->type.count(); ++n) {
    const bool rows = variable->type.rank == 2;
    elements.push_back(
        uniform_value(rows ? make_element(*make_element(*all, n / columns), n % columns) : make_element(*all, n)));
  }
  return elements;
}

Variable* Emitter::hidden(const Type& type) {
  auto variable = std::make_unique<Variable>();
  variable->name = "u" + std::to_string(code_.uniform_variables.size() + 1);
  variable->type = type;
  variable->type.varying = false;
  variable->role = Variable::Role::Hidden;
  variable->where = where_;
  code_.uniform_variables.push_back(std::move(variable));
  return code_.uniform_variables.back().get();
}

void Emitter::evaluate(NodePtr tree) {
  ir::Instruction instruction;
  instruction.kind = Kind::Uniform;
  instruction.uniform = add_uniform(std::move(tree));
  append(std::move(instruction));
}

void Emitter::assign(Variable* variable, NodePtr value) {
  const Location where = value->where;
  evaluate(make_assign(make_read(variable, where), std::move(value), where));
}

Variable* Emitter::hoist(NodePtr tree) {
  Variable* const variable = hidden(tree->type);
  assign(variable, std::move(tree));
  return variable;
}

NodePtr Emitter::once(NodePtr tree) {
  if (is_pure(*tree)) return tree;
  const Location where = tree->where;
  return make_read(hoist(std::move(tree)), where);
}

}  // namespace pfman
