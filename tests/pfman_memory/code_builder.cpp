#include "tests/pfman_memory/code_builder.h"

#include "pixelflow/compiler/memory_layout.h"

namespace pfman_tests {

using pfman::ir::Instruction;
using pfman::ir::Operand;

CodeBuilder::CodeBuilder(const std::string& name, pfman::Shader::Kind kind) : next_parameter_(pfman::kParametersAt) {
  code.name = name;
  code.kind = kind;
  code.where = {0, 1, 1};
}

int CodeBuilder::add_variable(const std::string& name, pfman::Scalar scalar, int count) {
  pfman::ir::Variable variable;
  variable.name = variable.source = name;
  variable.scalar = scalar;
  variable.count = count;
  variable.where = {0, ++line_, 3};
  code.variables.push_back(variable);
  return static_cast<int>(code.variables.size()) - 1;
}

int CodeBuilder::variable(const std::string& name, int bytes, int count) {
  return add_variable(name, pfman::Scalar::fixed(false, 8 * bytes, 0), count);
}

int CodeBuilder::float_variable(const std::string& name, int count) {
  return add_variable(name, pfman::Scalar::floating(), count);
}

int CodeBuilder::temporary(int bytes) {
  const int v = variable("t" + std::to_string(code.variables.size()), bytes);
  code.variables[v].temporary = true;
  code.variables[v].source.clear();
  return v;
}

int CodeBuilder::at_address(const std::string& name, int bytes, int address) {
  const int v = variable(name, bytes);
  code.variables[v].address = address;
  return v;
}

int CodeBuilder::parameter(const std::string& name, int bytes, int count) {
  const int v = variable(name, bytes, count);
  code.variables[v].address = next_parameter_;
  next_parameter_ += bytes * count;
  code.parameters.push_back({nullptr, {v}});
  return v;
}

Operand CodeBuilder::all(const pfman::ir::Code& code, int variable) {
  Operand operand;
  operand.kind = Operand::Kind::Pixel;
  operand.variable = variable;
  operand.bytes = code.variables[variable].scalar.bytes();
  operand.is_signed = code.variables[variable].scalar.is_signed;
  return operand;
}

Operand CodeBuilder::element(int variable, int index) const {
  Operand operand = use(variable);
  operand.index = index;
  operand.elements = code.variables[variable].count;
  return operand;
}

int CodeBuilder::uniform_literal(std::uint64_t value) {
  auto node = std::make_unique<pfman::Node>();
  node->op = pfman::Node::Op::Literal;
  node->type.scalar = pfman::Scalar::fixed(false, 64, 0);
  node->raw = value;
  code.uniforms.push_back(std::move(node));
  return static_cast<int>(code.uniforms.size()) - 1;
}

Operand CodeBuilder::literal(std::uint64_t value, int bytes) {
  Operand operand;
  operand.kind = Operand::Kind::Uniform;
  operand.bytes = bytes;
  operand.uniform = uniform_literal(value);
  return operand;
}

Instruction& CodeBuilder::add(Kind kind) {
  Instruction instruction;
  instruction.kind = kind;
  instruction.where = {0, ++line_, 5};
  code.code.push_back(std::move(instruction));
  return code.code.back();
}

Instruction& CodeBuilder::operate(pixelflow::Code operation, Operand d, Operand a, Operand b, int scale) {
  Instruction& instruction = add(Kind::Operate);
  instruction.code = operation;
  instruction.d = d;
  instruction.a = a;
  instruction.b = b;
  instruction.scale = scale;
  return instruction;
}

int CodeBuilder::copy(int d, int a) {
  operate(pixelflow::Code::Copy, use(d), use(a));
  return size() - 1;
}

int CodeBuilder::put(int d, std::uint64_t value) {
  operate(pixelflow::Code::Copy, use(d), literal(value, use(d).bytes));
  return size() - 1;
}

int CodeBuilder::begin_if(Kind kind, Operand condition, int uniform) {
  Instruction& instruction = add(kind);
  instruction.condition = condition;
  instruction.uniform = uniform;
  return size() - 1;
}

int CodeBuilder::begin_else(int of) {
  const bool masked = code.code[of].kind == Kind::IfMasked;
  add(masked ? Kind::ElseMasked : Kind::Else);
  code.code[of].match = size() - 1;
  return size() - 1;
}

void CodeBuilder::end_if(int of) {
  const Kind kind = code.code[of].kind;
  add(kind == Kind::IfMasked || kind == Kind::ElseMasked ? Kind::EndIfMasked : Kind::EndIf);
  code.code[of].match = size() - 1;
}

int CodeBuilder::begin_loop(bool masked_breaks, bool masked_continues) {
  Instruction& loop = add(Kind::Loop);
  loop.masked_breaks = masked_breaks;
  loop.masked_continues = masked_continues;
  if (masked_breaks || masked_continues) loop.mask = 0;
  return size() - 1;
}

void CodeBuilder::loop_test(int loop, int uniform) {
  Instruction& test = add(Kind::LoopTest);
  test.match = loop;
  test.uniform = uniform;
}

void CodeBuilder::jump(Kind kind, int loop) { add(kind).match = loop; }

void CodeBuilder::loop_next(int loop) { add(Kind::LoopNext).match = loop; }

void CodeBuilder::end_loop(int loop) {
  add(Kind::EndLoop).match = loop;
  code.code[loop].match = size() - 1;
}

void CodeBuilder::stage(int number) { add(Kind::Stage).stage = number; }

}  // namespace pfman_tests
