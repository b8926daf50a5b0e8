// Expressions.
#include <algorithm>

#include "tests/reference/builtin.h"
#include "tests/reference/machine.h"
#include "tests/reference/resolver.h"

namespace reference {

using pfman::ast::Operator;

namespace {

Value room(const Node& node, const Value& a, const Value& b) {
  return Value(std::max(a.lanes, b.lanes), node.shape.count());
}

/// A value that its node holds in fewer bits than it has.
Value reduced(Value value, const Node& node, const Number& from) {
  if (!node.number.floating && node.number.size < from.size) {
    for (Raw& raw : value.raw) raw = wrapped(raw, node.number);
  }
  return value;
}

bool holds(Operator op, bool less, bool equal, bool ordered) {
  switch (op) {
    case Operator::Less: return ordered && less;
    case Operator::LessEqual: return ordered && (less || equal);
    case Operator::Greater: return ordered && !less && !equal;
    case Operator::GreaterEqual: return ordered && !less;
    case Operator::Equal: return ordered && equal;
    default: return !ordered || !equal;
  }
}

Magnitude absolute(Wide v) { return v < 0 ? Magnitude{0} - static_cast<Magnitude>(v) : static_cast<Magnitude>(v); }

/// floor(+-magnitude 2^-shift), modulo 2^128.
Magnitude floored(bool negative, Magnitude magnitude, int shift) {
  if (shift >= 128) return negative && magnitude != 0 ? ~Magnitude{0} : 0;
  const Magnitude kept = magnitude >> shift;
  if (!negative) return kept;
  const bool exact = shift == 0 || (magnitude & ((Magnitude{1} << shift) - 1)) == 0;
  return Magnitude{0} - kept - (exact ? 0 : 1);
}

/// One fixed-point operation, from the operands' types to the node's.
Raw fixed_operation(const Node& node, Raw x, const Number& a, Raw y, const Number& b) {
  const Number& to = node.number;
  const Wide p = integer(x, a), q = integer(y, b);
  switch (node.op) {
    case Operator::Add:
    case Operator::Subtract: {
      const Magnitude first = shifted_left(static_cast<Magnitude>(p), to.exponent - a.exponent);
      const Magnitude second = shifted_left(static_cast<Magnitude>(q), to.exponent - b.exponent);
      return wrapped(node.op == Operator::Add ? first + second : first - second, to);
    }
    case Operator::Multiply:
      return wrapped(floored((p < 0) != (q < 0), absolute(p) * absolute(q), a.exponent + b.exponent - to.exponent), to);
    case Operator::Divide: {
      if (q == 0) return 0;
      // The full quotient has exponent a.exponent + b.integer_bits().
      const bool negative = (p < 0) != (q < 0);
      const Magnitude dividend = absolute(p) << (b.size - b.sign_bits());
      const Magnitude divisor = absolute(q);
      const Magnitude whole = dividend / divisor + (negative && dividend % divisor != 0 ? 1 : 0);
      return wrapped(floored(negative, whole, a.exponent + b.integer_bits() - to.exponent), to);
    }
    case Operator::Remainder: {
      if (q == 0) return 0;
      const int exponent = std::max(a.exponent, b.exponent);
      const Wide dividend = p * (Wide{1} << (exponent - a.exponent)),
                 divisor = q * (Wide{1} << (exponent - b.exponent));
      Wide rest = dividend % divisor;
      if (rest != 0 && (rest < 0) != (divisor < 0)) rest += divisor;
      return wrapped(static_cast<Magnitude>(rest), to);
    }
    case Operator::BitAnd: return wrapped(static_cast<Magnitude>(p & q), to);
    case Operator::BitOr: return wrapped(static_cast<Magnitude>(p | q), to);
    default: return wrapped(static_cast<Magnitude>(p ^ q), to);
  }
}

}  // namespace

Value Machine::evaluate(const Node& node) {
  switch (node.kind) {
    case Node::Kind::Literal: {
      Value value(1, 1);
      value.raw[0] = node.number.floating ? node.raw : wrapped(node.raw, node.number);
      return value;
    }
    case Node::Kind::Read: return reduced(node.variable->value, node, node.variable->number);
    case Node::Kind::Index: return evaluate_index(node);
    case Node::Kind::Array: return evaluate_array(node);
    case Node::Kind::Unary: return evaluate_unary(node);
    case Node::Kind::Binary: return evaluate_binary(node);
    case Node::Kind::Compare: return evaluate_compare(node);
    case Node::Kind::Logic: return evaluate_logic(node);
    case Node::Kind::Shift: return evaluate_shift(node);
    case Node::Kind::Scale: return evaluate(*node.operands[0]);
    case Node::Kind::Conditional: return evaluate_conditional(node);
    case Node::Kind::Convert: return evaluate_convert(node);
    case Node::Kind::Assign:
    case Node::Kind::Increment: return evaluate_assignment(node);
    case Node::Kind::Call: return evaluate_call(node);
    case Node::Kind::Builtin: return evaluate_builtin(node);
  }
  return {};
}

Wide Machine::integer_of(const Node& node) {
  if (node.number.floating || !node.uniform) fail(202, node.where, "not a uniform integer");
  const Wide value = integer(evaluate(node).at(0, 0), node.number);
  if (node.number.exponent > 0) return shifted_right(value, node.number.exponent);
  return value * (Wide{1} << std::min(-node.number.exponent, 60));
}

bool Machine::truth(const Node& node) { return evaluate(node).at(0, 0) != 0; }

Value Machine::evaluate_unary(const Node& node) {
  const Number from = node.operands[0]->number;
  Value value = evaluate(*node.operands[0]);
  for (Raw& raw : value.raw) {
    if (node.op == Operator::Complement) {
      raw = wrapped(~static_cast<Magnitude>(integer(raw, from)), node.number);
    } else if (node.number.floating) {
      raw = float_bits(-as_float(raw));
    } else {
      raw = wrapped(Magnitude{0} - static_cast<Magnitude>(integer(raw, from)), node.number);
    }
  }
  return value;
}

Value Machine::evaluate_binary(const Node& node) {
  const Node &first = *node.operands[0], &second = *node.operands[1];
  const Value a = evaluate(first), b = evaluate(second);
  Value value = room(node, a, b);
  for (int element = 0; element < value.elements(); ++element) {
    for (int lane = 0; lane < value.lanes; ++lane) {
      const Raw x = a.at(element, lane), y = b.at(element, lane);
      value.to(element, lane) = node.number.floating ? float_operation(node.op, x, y)
                                                     : fixed_operation(node, x, first.number, y, second.number);
    }
  }
  return value;
}

Value Machine::evaluate_compare(const Node& node) {
  const Node &first = *node.operands[0], &second = *node.operands[1];
  const Value a = evaluate(first), b = evaluate(second);
  Value value = room(node, a, b);
  const int exponent = std::max(first.number.exponent, second.number.exponent);
  const int elements = std::max(first.shape.count(), second.shape.count());
  const bool any = node.op == Operator::NotEqual;  // of arrays: any different, or all equal
  for (int lane = 0; lane < value.lanes; ++lane) {
    bool result = !any;
    for (int element = 0; element < elements; ++element) {
      const Raw x = a.at(element, lane), y = b.at(element, lane);
      bool here;
      if (first.number.floating) {
        const float p = as_float(x), q = as_float(y);
        here = holds(node.op, p < q, p == q, p == p && q == q);
      } else {
        const Wide p = integer(x, first.number) * (Wide{1} << (exponent - first.number.exponent));
        const Wide q = integer(y, second.number) * (Wide{1} << (exponent - second.number.exponent));
        here = holds(node.op, p < q, p == q, true);
      }
      result = any ? result || here : result && here;
    }
    value.to(0, lane) = result ? 1 : 0;
  }
  return value;
}

Value Machine::evaluate_logic(const Node& node) {
  Value value = evaluate(*node.operands[0]);
  for (Raw& raw : value.raw) raw = raw != 0 ? 1 : 0;
  if (node.op == Operator::Not) {
    for (Raw& raw : value.raw) raw = 1 - raw;
    return value;
  }
  const bool both = node.op == Operator::And;
  if (node.uniform && (value.raw[0] != 0) != both) return value;  // known without the second operand
  const Value second = evaluate(*node.operands[1]);
  Value result = room(node, value, second);
  for (int lane = 0; lane < result.lanes; ++lane) {
    const bool x = value.at(0, lane) != 0, y = second.at(0, lane) != 0;
    result.to(0, lane) = (both ? x && y : x || y) ? 1 : 0;
  }
  return result;
}

Value Machine::evaluate_shift(const Node& node) {
  Value value = evaluate(*node.operands[0]);
  const Wide count = integer_of(*node.operands[1]);
  if (count < 0 || count > 64) fail(0, node.where, "shift count out of range");
  const Number from = node.operands[0]->number;
  const int shift = static_cast<int>(count);
  for (Raw& raw : value.raw) {
    const Wide whole = integer(raw, from);
    raw = wrapped(node.op == Operator::ShiftLeft ? shifted_left(static_cast<Magnitude>(whole), shift)
                                                 : static_cast<Magnitude>(shifted_right(whole, shift)),
                  node.number);
  }
  return value;
}

Value Machine::evaluate_array(const Node& node) {
  std::vector<Value> parts;
  int lanes = 1;
  for (const NodePtr& operand : node.operands) {
    parts.push_back(evaluate(*operand));
    lanes = std::max(lanes, parts.back().lanes);
  }
  Value value(lanes, node.shape.count());
  int element = 0;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    for (int part = 0; part < node.operands[n]->shape.count(); ++part, ++element) {
      for (int lane = 0; lane < lanes; ++lane) {
        const Raw raw = parts[n].at(part, lane);
        const Number from = node.operands[n]->number;
        value.to(element, lane) = from == node.number ? raw : fixed_to_fixed(raw, from, node.number, false);
      }
    }
  }
  return value;
}

Value Machine::evaluate_index(const Node& node) {
  const Node& array = *node.operands[0];
  const Value whole = evaluate(array);
  const Wide index = integer_of(*node.operands[1]);
  if (index < 0 || index >= array.shape.rows) fail(204, node.where, "index out of range");
  const int count = node.shape.count();
  Value value(whole.lanes, count);
  for (int element = 0; element < count; ++element) {
    for (int lane = 0; lane < whole.lanes; ++lane) {
      value.to(element, lane) = whole.at(static_cast<int>(index) * count + element, lane);
    }
  }
  return reduced(std::move(value), node, array.number);
}

Value Machine::evaluate_conditional(const Node& node) {
  const Value chosen = evaluate(*node.operands[0]);
  const auto branch = [&](int n) {
    Value value = evaluate(*node.operands[static_cast<std::size_t>(n)]);
    const Number from = node.operands[static_cast<std::size_t>(n)]->number;
    if (from != node.number) {
      for (Raw& raw : value.raw) raw = fixed_to_fixed(raw, from, node.number, false);
    }
    return value;
  };
  if (node.operands[0]->uniform) return branch(chosen.raw[0] != 0 ? 1 : 2);
  const Value first = branch(1), second = branch(2);
  // A varying condition of uniform branches may have come out as one value for all lanes.
  Value value(std::max({chosen.lanes, first.lanes, second.lanes}), node.shape.count());
  for (int element = 0; element < value.elements(); ++element) {
    for (int lane = 0; lane < value.lanes; ++lane) {
      value.to(element, lane) = chosen.at(0, lane) != 0 ? first.at(element, lane) : second.at(element, lane);
    }
  }
  return value;
}

Value Machine::evaluate_convert(const Node& node) {
  Value value = evaluate(*node.operands[0]);
  for (Raw& raw : value.raw) raw = converted(raw, node.operands[0]->number, node.target, node.saturate);
  return reduced(std::move(value), node, node.target);
}

Value Machine::evaluate_builtin(const Node& node) {
  std::vector<Value> arguments;
  for (const NodePtr& operand : node.operands) arguments.push_back(evaluate(*operand));
  if (node.builtin->typing == Typing::Texture) return look_up(node, arguments);
  return node.builtin->evaluate(node, arguments);
}

Value Machine::look_up(const Node& node, const std::vector<Value>& arguments) const {
  if (textures_ == nullptr) fail(0, node.where, "no textures");
  const auto number = static_cast<std::int64_t>(integer(arguments[0].at(0, 0), node.operands[0]->number));
  const bool sphere = node.builtin->name == "environment";
  Value value = room_for(node, arguments);
  for (int lane = 0; lane < value.lanes; ++lane) {
    const auto component = [&](int n) { return as_float(arguments[1].at(n, lane)); };
    const auto texel = sphere ? textures_->environment(number, {component(0), component(1), component(2)})
                              : textures_->look_up(number, component(0), as_float(arguments[2].at(0, lane)));
    for (int element = 0; element < value.elements(); ++element) {
      value.to(element, lane) = texel[static_cast<std::size_t>(element)];
    }
  }
  return value;
}

Machine::Place Machine::place(const Node& node) {
  if (node.kind == Node::Kind::Read) return {node.variable, 0, node.shape.count()};
  if (node.kind != Node::Kind::Index) fail(102, node.where, "nothing to assign to");
  const Place whole = place(*node.operands[0]);
  const Wide index = integer_of(*node.operands[1]);
  if (index < 0 || index >= node.operands[0]->shape.rows) fail(204, node.where, "index out of range");
  const int count = node.shape.count();
  return {whole.variable, whole.first + static_cast<int>(index) * count, count};
}

void Machine::store(const Place& place, const Value& value) {
  Variable& variable = *place.variable;
  for (int element = 0; element < place.count; ++element) {
    for (int lane = 0; lane < variable.value.lanes; ++lane) {
      if (variable.uniform || active_[static_cast<std::size_t>(lane)]) {
        variable.value.to(place.first + element, lane) = value.at(element, lane);
      }
    }
  }
}

Value Machine::evaluate_assignment(const Node& node) {
  const Place target = place(*node.operands[0]);
  const Number number = target.variable->number;
  Value old = node.kind == Node::Kind::Increment ? evaluate(*node.operands[0]) : Value();
  Value value = evaluate(*node.operands[1]);
  store(target, value);
  return reduced(node.kind == Node::Kind::Increment ? std::move(old) : std::move(value), node, number);
}

Value Machine::evaluate_call(const Node& node) {
  Function& function = *node.function;
  std::vector<Value> arguments;
  for (const NodePtr& operand : node.operands) arguments.push_back(evaluate(*operand));
  for (std::size_t n = 0; n < arguments.size(); ++n) assign_everywhere(*function.parameters[n], arguments[n]);
  if (function.result != nullptr) assign_everywhere(*function.result, Value(1, function.result->shape.count()));
  // Loops around the call are not the function's.
  std::vector<Loop> outer;
  outer.swap(loops_);
  const std::vector<bool> saved = active_;
  flow(*function.body);
  active_ = saved;
  outer.swap(loops_);
  for (std::size_t n = 0; n < node.results.size(); ++n) {
    if (!node.results[n]) continue;
    const Variable& parameter = *function.parameters[n];
    const Place target = place(*node.results[n]);
    Value value = parameter.value;
    for (Raw& raw : value.raw) raw = converted(raw, parameter.number, target.variable->number, false);
    store(target, value);
  }
  if (function.result == nullptr) return {};
  return reduced(function.result->value, node, function.result->number);
}

}  // namespace reference
