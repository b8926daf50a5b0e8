// Calls: functions are written in place, with copies of their parameters where those are written; external ones get
// their arguments as whole variables.
#include <algorithm>
#include <set>
#include <stdexcept>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
namespace {

constexpr int kMostCalls = 20000;

bool has_outputs(const Function& function) {
  return std::any_of(function.parameters.begin(), function.parameters.end(),
                     [](const Variable* parameter) { return parameter->output; });
}

}  // namespace

bool Lowering::may_call() {
  if (!too_long_ && ++calls_ > kMostCalls) {
    too_long(std::to_string(kMostCalls) + " calls, one within the other, written in place");
  }
  return !too_long_;
}

std::vector<int> Lowering::variables_of(const Terms& places, const Variable& parameter) {
  const Scalar& scalar = parameter.type.scalar;
  const bool together = indexed_.contains(&parameter);
  std::vector<int> variables;
  for (std::size_t n = 0; n < places.size(); ++n) {
    const ir::Operand& place = places[n].at;
    const ir::Variable& variable = code_.variables[static_cast<std::size_t>(place.variable)];
    const int count = together ? parameter.type.count() : 1;
    if (variable.scalar != scalar || variable.count != count || place.index >= 0) return {};
    if (place.offset != (together ? static_cast<int>(n) * scalar.bytes() : 0)) return {};
    if (together && n > 0 && place.variable != variables[0]) return {};
    if (!together || n == 0) variables.push_back(place.variable);
  }
  return variables;
}

/// What a parameter that its function does not write stands for.
Term Lowering::argument_value(const Term& value, const Function& function, const Scalar& type) {
  Term ready = value;
  if (!type.is_float) ready = wrapped(reduced(aligned(value, type.exponent, type.size), type));
  // The function may change the caller's variables through its outputs.
  if (!has_outputs(function)) return ready;
  if (ready.at.kind == ir::Operand::Kind::Uniform) {
    return uniform_value(make_read(hoist(tree_of(ready)), where_));
  }
  if (code_.variables[static_cast<std::size_t>(ready.at.variable)].temporary) return ready;
  ready.at = operate(Code::Copy, contents_of(ready), ready.at);
  return ready;
}

Terms Lowering::lower_call(const Node& node) {
  const Function& function = *node.function;
  if (function.is_external) return external_call(node);
  if (!may_call()) {
    Terms dummies;
    for (int n = 0; n < function.result.count(); ++n) {
      dummies.push_back(function.result.varying ? Term{temporary(function.result.scalar), function.result.scalar}
                                                : Term{constant(0, function.result.scalar), function.result.scalar});
    }
    return dummies;
  }

  std::map<const Variable*, Binding> bound;
  std::vector<std::size_t> copied_back;
  std::set<int> taken;
  std::set<const Variable*> taken_uniforms;
  for (std::size_t n = 0; n < node.operands.size(); ++n) {
    const Variable& parameter = *function.parameters[n];
    const Node& argument = *node.operands[n];
    Binding& binding_of_parameter = bound[&parameter];
    if (!parameter.type.varying) {
      const bool itself =
          parameter.output && argument.op == Op::Variable && argument.variable->type.scalar == parameter.type.scalar;
      if (itself && taken_uniforms.insert(uniform_of(*argument.variable)).second) {
        binding_of_parameter.uniform = uniform_of(*argument.variable);
        continue;
      }
      Variable* const copy = hidden(parameter.type);
      copy->name = parameter.name;
      assign(copy, uniform_tree(argument));
      binding_of_parameter.uniform = copy;
      if (parameter.output) copied_back.push_back(n);
      continue;
    }
    const Terms values = parameter.output ? place_of(argument) : lower_node(argument);
    if (parameter.output) {
      std::vector<int> variables = variables_of(values, parameter);
      const bool free = std::none_of(variables.begin(), variables.end(), [&](int v) { return taken.contains(v); });
      if (!variables.empty() && free) {
        taken.insert(variables.begin(), variables.end());
        binding_of_parameter.variables = std::move(variables);
        continue;
      }
      copied_back.push_back(n);
    } else if (!written_.contains(&parameter) && !indexed_.contains(&parameter)) {
      for (int e = 0; e < parameter.type.count(); ++e) {
        const Term& value = values[values.size() > 1 ? static_cast<std::size_t>(e) : 0];
        binding_of_parameter.values.push_back(argument_value(value, function, parameter.type.scalar));
      }
      continue;
    }
    bindings_.erase(&parameter);
    binding_of_parameter = binding(parameter);
    for (int e = 0; e < parameter.type.count(); ++e) {
      const bool together = binding_of_parameter.variables.size() == 1;
      const ir::Operand d = together ? whole(binding_of_parameter.variables[0], e)
                                     : whole(binding_of_parameter.variables[static_cast<std::size_t>(e)]);
      store({d, parameter.type.scalar}, values[values.size() > 1 ? static_cast<std::size_t>(e) : 0]);
    }
  }
  // The function's own variables are this call's alone.
  const auto callers = bindings_;
  for (auto& [parameter, binding_of_parameter] : bound) bindings_[parameter] = binding_of_parameter;

  ++depth_;
  const Location where = where_;
  lower_body(function.body);
  Terms result;
  if (function.value) {
    if (is_uniform(*function.value)) {
      result = elements_of(hoist(uniform_tree(*function.value)));
    } else {
      result = lower_node(*function.value);
    }
  }
  where_ = where;
  --depth_;
  for (const std::size_t n : copied_back) {
    const Variable& parameter = *function.parameters[n];
    const Node& argument = *node.operands[n];
    if (!parameter.type.varying) {
      NodePtr value = make_read(bound[&parameter].uniform, argument.where);
      bindings_ = callers;
      evaluate(make_assign(uniform_tree(argument), std::move(value), argument.where));
      continue;
    }
    const NodePtr reference = make_read(function.parameters[n], argument.where);
    bindings_[&parameter] = bound[&parameter];
    const Terms values = place_of(*reference);
    bindings_ = callers;
    store(argument, values);
  }
  bindings_ = callers;
  return result;
}

/// An argument is a variable of its own, as it is declared, in one piece.
Terms Lowering::external_call(const Node& node) {
  const Function& function = *node.function;
  const bool all_uniform = std::none_of(function.parameters.begin(), function.parameters.end(),
                                        [](const Variable* parameter) { return parameter->type.varying; });
  if (all_uniform && (function.result.is_void || !function.result.varying)) {
    evaluate(uniform_tree(node));
    return {};
  }
  ir::Instruction call;
  call.kind = Kind::External;
  call.external = &function;
  std::vector<std::pair<const Node*, int>> copied_back;
  for (std::size_t n = 0; n < node.operands.size(); ++n) {
    const Variable& parameter = *function.parameters[n];
    const Node& argument = *node.operands[n];
    if (!parameter.type.varying) {
      ir::Operand operand;
      operand.kind = ir::Operand::Kind::Uniform;
      operand.is_signed = parameter.type.scalar.is_signed;
      operand.bytes = parameter.type.scalar.bytes();
      operand.uniform = add_uniform(once(uniform_tree(argument)));
      call.arguments.push_back(operand);
      continue;
    }
    const Terms values = parameter.output ? place_of(argument) : lower_node(argument);
    const ir::Operand& first = values.at(0).at;
    if (first.kind == ir::Operand::Kind::Pixel && values.size() == static_cast<std::size_t>(parameter.type.count())) {
      const ir::Variable& variable = code_.variables[static_cast<std::size_t>(first.variable)];
      const bool together = variable.count == parameter.type.count() && variable.scalar == parameter.type.scalar;
      if (together && first.offset == 0 && first.index < 0 && first.bytes == parameter.type.scalar.bytes()) {
        call.arguments.push_back(first);
        continue;
      }
    }
    const int copy = gathered(values, parameter.type.scalar, parameter.type.count());
    if (parameter.output) copied_back.push_back({&argument, copy});
    call.arguments.push_back(whole(copy));
  }
  Terms result;
  if (!function.result.is_void) {
    const int variable = add_variable({}, function.result.scalar, function.result.count(), true);
    call.d = whole(variable);
    for (int n = 0; n < function.result.count(); ++n) result.push_back({whole(variable, n), function.result.scalar});
  }
  append(std::move(call));
  for (const auto& [argument, copy] : copied_back) {
    Terms values;
    const ir::Variable& variable = code_.variables[static_cast<std::size_t>(copy)];
    for (int n = 0; n < variable.count; ++n) values.push_back({whole(copy, n), variable.scalar});
    store(*argument, values);
  }
  return result;
}

}  // namespace pfman
