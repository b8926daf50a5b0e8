// Functions of the language called from C++ (Olano and Lastra 1998, section 3.3): compiled like a surface of which the
// results are the colour, in memory that is then moved to where the caller has some.
#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/build.h"
#include "pixelflow/compiler/externals.h"
#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/lower.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/compiler/stage_walker.h"

namespace pfman {
namespace {

[[noreturn]] void refuse(const Function& function, const std::string& what) {
  throw std::invalid_argument("function '" + function.name + "': " + what);
}

NodePtr read(Variable& variable) { return make_read(&variable, variable.where); }

NodePtr assignment(Variable& target, NodePtr value) {
  return make_assign(read(target), std::move(value), target.where);
}

/// A shader around one call: its parameters are the function's, its output is what the function leaves.
class CallShader {
 public:
  explicit CallShader(const Function& function) : function_(function) {
    shader_.name = function.name;
    shader_.where = function.where;
    auto call = std::make_unique<Node>();
    call->op = Node::Op::Call;
    call->type = function.result;
    call->exact = function.result.scalar;
    call->where = function.where;
    call->function = &function;
    std::vector<Variable*> outputs;
    for (const Variable* parameter : function.parameters) {
      Variable* const variable = add(*parameter, Variable::Role::Parameter);
      shader_.parameters.push_back({variable, nullptr, true});
      if (!parameter->output) {
        call->operands.push_back(read(*variable));
        continue;
      }
      // What comes in and what goes out are two variables: the first has its place given.
      outputs.push_back(add(*parameter, Variable::Role::Parameter));
      outputs.back()->output = true;
      shader_.body.push_back(make_evaluate(assignment(*outputs.back(), read(*variable))));
      call->operands.push_back(read(*outputs.back()));
    }
    if (function.result.is_void) {
      shader_.body.push_back(make_evaluate(std::move(call)));
    } else {
      Variable result;
      result.name = "result";
      result.where = function.where;
      result.type = function.result;
      outputs.push_back(add(result, Variable::Role::Parameter));
      outputs.back()->type.varying = true;
      outputs.back()->output = true;
      shader_.body.push_back(make_evaluate(assignment(*outputs.back(), std::move(call))));
    }
    for (Variable* output : outputs) shader_.parameters.push_back({output, nullptr, true});
  }

  const Shader& shader() const { return shader_; }
  Variable& parameter(std::size_t number) const { return *shader_.parameters[number].variable; }

 private:
  Variable* add(const Variable& model, Variable::Role role) {
    auto& variable = variables_.emplace_back(std::make_unique<Variable>(model));
    variable->role = role;
    variable->output = false;
    variable->id = -static_cast<int>(variables_.size());
    return variable.get();
  }

  const Function& function_;
  Shader shader_;
  std::vector<std::unique_ptr<Variable>> variables_;
};

CompiledShader compile_call(const Tree& tree, const CallShader& call, const Function& function, int free_mask_bit) {
  Diagnostics diagnostics;
  CompiledShader compiled;
  compiled.shader = &call.shader();
  compiled.tree = &tree;
  compiled.code = lower(tree, call.shader(), {}, diagnostics);
  if (!diagnostics.has_errors()) {
    // Mask bits begin where the caller's end.
    if (compiled.code.mask_bits > 0) ir::add_mask_bytes(compiled.code, free_mask_bit + compiled.code.mask_bits);
    run_passes(compiled, {}, diagnostics);
  }
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.is_error()) refuse(function, diagnostic.text);
  }
  for (const ir::Instruction& instruction : compiled.code.code) {
    if (instruction.kind == ir::Instruction::Kind::Lookup) refuse(function, "textures are looked up by shaders only");
  }
  return compiled;
}

/// From the shader's own part of the memory to the caller's.
void move_memory(CompiledShader& compiled, const PixelWorkspace& workspace, const Function& function) {
  const int bytes = compiled.map.first_free - kParametersAt;
  if (workspace.bytes < bytes || workspace.first < 0 || workspace.first + bytes > pixelflow::kMemoryBytes) {
    refuse(function, "needs " + std::to_string(bytes) + " bytes of workspace");
  }
  const int distance = workspace.first - kParametersAt;
  for (int& address : compiled.map.address) {
    if (address >= 0) address += distance;
  }
  for (ir::Instruction& instruction : compiled.code.code) instruction.work += distance;
}

void check_variable(const Function& function, const std::string& name, const PixelVariable& place, const Type& type) {
  const Scalar& scalar = type.scalar;
  if (place.bytes != scalar.bytes() || place.kind != pixel_kind(scalar) || place.count != type.count() ||
      (!scalar.is_float && place.exponent != scalar.exponent)) {
    refuse(function, "'" + name + "' is " + spelling(type));
  }
  if (place.address + type.bytes() > pixelflow::kMemoryBytes) refuse(function, "'" + name + "' leaves the memory");
}

void check_argument(const Function& function, const Variable& parameter, const ExternalArgument& argument) {
  if (argument.pixel) {
    if (!parameter.type.varying) refuse(function, "'" + parameter.name + "' is uniform");
    check_variable(function, parameter.name, *argument.pixel, parameter.type);
    return;
  }
  if (parameter.output) refuse(function, "'" + parameter.name + "' is an output and lies in pixel memory");
  if (argument.uniform.size() != static_cast<std::size_t>(parameter.type.count())) {
    refuse(function, "'" + parameter.name + "' has " + std::to_string(parameter.type.count()) + " numbers");
  }
}

}  // namespace

void append_call(pixelflow::Program& stream, const CompiledUnit& unit, const std::string& name,
                 const std::vector<ExternalArgument>& arguments, const PixelWorkspace& workspace) {
  const auto found = std::find_if(unit.tree.functions.begin(), unit.tree.functions.end(),
                                  [&](const std::unique_ptr<Function>& function) { return function->name == name; });
  if (found == unit.tree.functions.end() || (*found)->is_external) {
    throw std::invalid_argument("there is no function '" + name + "'");
  }
  const Function& function = **found;
  const std::size_t parameters = function.parameters.size(), result = function.result.is_void ? 0 : 1;
  if (arguments.size() != parameters + result) {
    refuse(function, "takes " + std::to_string(parameters + result) + " arguments, its result among them");
  }
  std::vector<PixelVariable> results;
  for (std::size_t n = 0; n < parameters; ++n) {
    check_argument(function, *function.parameters[n], arguments[n]);
    if (function.parameters[n]->output) results.push_back(*arguments[n].pixel);
  }
  if (result > 0) {
    if (!arguments.back().pixel) refuse(function, "the result lies in pixel memory");
    check_variable(function, "result", *arguments.back().pixel, function.result);
    results.push_back(*arguments.back().pixel);
  }

  const CallShader call(function);
  CompiledShader compiled = compile_call(unit.tree, call, function, workspace.free_mask_bit);
  move_memory(compiled, workspace, function);
  Environment environment;
  for (const NodePtr& constant : unit.tree.constants) evaluate(*constant, environment);
  for (std::size_t n = 0; n < parameters; ++n) {
    if (!call.parameter(n).type.varying) environment[&call.parameter(n)] = arguments[n].uniform;
  }
  Stream made;
  const std::vector<ExternalArgument> given(arguments.begin(),
                                            arguments.begin() + static_cast<std::ptrdiff_t>(parameters));
  StageWalker(compiled, environment, {}, made).walk_call(given, results, workspace);
  const pixelflow::Program& program = made.parts.at(0).program;
  const auto first = static_cast<std::uint32_t>(stream.instructions.size());
  stream.instructions.insert(stream.instructions.end(), program.instructions.begin(), program.instructions.end());
  for (pixelflow::Step step : program.steps) {
    step.first += first;
    stream.steps.push_back(step);
  }
}

}  // namespace pfman
