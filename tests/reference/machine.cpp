// Statements: masks, loops, lights.
#include "tests/reference/machine.h"

#include <algorithm>

#include "tests/reference/builtin.h"
#include "tests/reference/resolver.h"

namespace reference {
namespace {

constexpr int kMostIterations = 65536;

}  // namespace

void Machine::run(const Step& step) { flow(step); }

void Machine::run_where(const Step& step, const std::vector<bool>& enabled) {
  const std::vector<bool> saved = active_;
  active_ = enabled;
  flow(step);
  active_ = saved;
}

void Machine::assign_everywhere(Variable& variable, const Value& value) const {
  variable.value = Value(variable.uniform ? 1 : lanes_, variable.shape.count());
  for (int element = 0; element < variable.shape.count(); ++element) {
    for (int lane = 0; lane < variable.value.lanes; ++lane) {
      variable.value.to(element, lane) = value.at(element, lane);
    }
  }
}

Machine::Flow Machine::flow(const Step& step) {
  switch (step.kind) {
    case Step::Kind::Evaluate: evaluate(*step.nodes[0]); return Flow::Next;
    case Step::Kind::Declare: {
      Variable& variable = *step.variable;
      Value initial = step.nodes[0] ? evaluate(*step.nodes[0]) : Value(1, variable.shape.count());
      assign_everywhere(variable, initial);
      return Flow::Next;
    }
    case Step::Kind::Block:
      for (const StepPtr& inner : step.body) {
        const Flow next = flow(*inner);
        if (next != Flow::Next) return next;
      }
      return Flow::Next;
    case Step::Kind::If: return flow_if(step);
    case Step::Kind::Loop: return flow_loop(step);
    case Step::Kind::Break:
      if (!step.masked) return Flow::Break;
      leave(loops_.back().broken);
      return Flow::Next;
    case Step::Kind::Continue:
      if (!step.masked) return Flow::Continue;
      leave(loops_.back().skipped);
      return Flow::Next;
    case Step::Kind::Return:
      if (step.variable != nullptr) assign_everywhere(*step.variable, evaluate(*step.nodes[0]));
      return Flow::Next;
    case Step::Kind::Illuminance:
      run_where(*step.body[0], step.nodes.empty() ? active_ : inside_cone(step));
      return Flow::Next;
    case Step::Kind::Illuminate: illuminate(step); return Flow::Next;
    case Step::Kind::Solar: solar(step); return Flow::Next;
  }
  return Flow::Next;
}

/// The active lanes out of the loop or its iteration.
void Machine::leave(std::vector<bool>& out) {
  for (std::size_t lane = 0; lane < active_.size(); ++lane) {
    if (active_[lane]) out[lane] = true;
    active_[lane] = false;
  }
}

/// The lanes of before a construct, but for those that have left the loop around it.
void Machine::restrict_to_staying(const std::vector<bool>& saved) {
  active_ = saved;
  if (loops_.empty()) return;
  for (std::size_t lane = 0; lane < active_.size(); ++lane) {
    if (loops_.back().broken[lane] || loops_.back().skipped[lane]) active_[lane] = false;
  }
}

Machine::Flow Machine::flow_if(const Step& step) {
  if (!step.varying) {
    if (truth(*step.nodes[0])) return flow(*step.body[0]);
    return step.body.size() > 1 ? flow(*step.body[1]) : Flow::Next;
  }
  const Value chosen = evaluate(*step.nodes[0]);
  const std::vector<bool> saved = active_;
  for (int branch = 0; branch < static_cast<int>(step.body.size()); ++branch) {
    restrict_to_staying(saved);
    for (int lane = 0; lane < lanes_; ++lane) {
      if ((chosen.at(0, lane) != 0) == (branch == 1)) active_[static_cast<std::size_t>(lane)] = false;
    }
    flow(*step.body[static_cast<std::size_t>(branch)]);
  }
  restrict_to_staying(saved);
  return Flow::Next;
}

Machine::Flow Machine::flow_loop(const Step& step) {
  const std::vector<bool> saved = active_;
  const std::vector<bool> none(active_.size(), false);
  loops_.push_back({none, none});
  bool first = step.body_first;
  for (int iteration = 0;; ++iteration) {
    if (!first && step.nodes[0] && !truth(*step.nodes[0])) break;
    first = false;
    if (iteration == kMostIterations) fail(0, step.where, "loop of more than 65536 iterations");
    const Flow next = flow(*step.body[0]);
    loops_.back().skipped = none;
    restrict_to_staying(saved);
    if (next == Flow::Break) break;
    if (step.nodes[1]) {
      // The clauses of a for are outside the mask of what has left its body.
      const std::vector<bool> staying = active_;
      evaluate(*step.nodes[1]);
      active_ = staying;
    }
  }
  loops_.pop_back();
  active_ = saved;
  return Flow::Next;
}

/// Active lanes from which the light is within an angle around an illuminance's axis.
std::vector<bool> Machine::inside_cone(const Step& step) {
  const Value axis = normalized(evaluate(*step.nodes[0]));
  const Value angle = evaluate(*step.nodes[1]);
  const Value least = library_function("cos", {&angle});
  Value direction = light_.direction->value;
  for (Raw& raw : direction.raw) raw = fixed_to_float(raw, light_.direction->number);
  const Value cosine = float_dot(axis, direction);
  std::vector<bool> inside = active_;
  for (int lane = 0; lane < lanes_; ++lane) {
    if (!(as_float(cosine.at(0, lane)) >= as_float(least.at(0, lane)))) inside[static_cast<std::size_t>(lane)] = false;
  }
  return inside;
}

/// Black where the ray is outside of an illuminate's cone.
void Machine::blacken_outside(const Value& axis, const Value& angle) {
  const Value along = float_dot(light_.ray->value, axis);
  const Value length = float_product(light_.distance->value, float_square_root(float_dot(axis, axis)));
  const Value least = library_function("cos", {&angle});
  for (int lane = 0; lane < lanes_; ++lane) {
    const Raw cosine = float_operation(pfman::ast::Operator::Divide, along.at(0, lane), length.at(0, lane));
    const bool outside = as_float(cosine) < as_float(least.at(0, lane));
    if (!outside || !active_[static_cast<std::size_t>(lane)]) continue;
    for (Variable* color : light_.colors) {
      for (int element = 0; element < 3; ++element) color->value.to(element, lane) = 0;
    }
  }
}

void Machine::illuminate(const Step& step) {
  Value position = light_.position->value;
  for (Raw& raw : position.raw) raw = converted(raw, light_.position->number, kFloat, false);
  const Value ray = float_difference(position, evaluate(*step.nodes[0]));
  const Value distance = float_square_root(float_dot(ray, ray));
  assign_everywhere(*light_.ray, ray);
  assign_everywhere(*light_.distance, distance);
  Value direction = float_negated(ray);
  for (int element = 0; element < 3; ++element) {
    for (int lane = 0; lane < direction.lanes; ++lane) {
      const Raw part = float_operation(pfman::ast::Operator::Divide, direction.at(element, lane), distance.at(0, lane));
      direction.to(element, lane) = float_to_fixed(part, light_.direction->number);
    }
  }
  assign_everywhere(*light_.direction, direction);
  const bool cone = step.nodes.size() > 1;
  const Value axis = cone ? evaluate(*step.nodes[1]) : Value(), angle = cone ? evaluate(*step.nodes[2]) : Value();
  flow(*step.body[0]);
  if (cone) blacken_outside(axis, angle);
}

void Machine::solar(const Step& step) {
  const Value ray = normalized(evaluate(*step.nodes[0]));
  assign_everywhere(*light_.ray, ray);
  Value direction = float_negated(ray);
  for (Raw& raw : direction.raw) raw = float_to_fixed(raw, light_.direction->number);
  assign_everywhere(*light_.direction, direction);
  flow(*step.body[0]);
}

}  // namespace reference
