#include "pixelflow/compiler/host.h"

#include <algorithm>
#include <span>
#include <string>

#include "pixelflow/compiler/externals.h"
#include "pixelflow/compiler/host_numbers.h"

namespace pfman {
namespace {

using Op = Node::Op;

constexpr std::uint64_t kMostOperations = std::uint64_t{1} << 26;

/// What an assignment writes: part of a variable's value.
struct Place {
  Raw* value;
  std::size_t first;
  std::size_t count;
};

class Evaluator {
 public:
  explicit Evaluator(Environment& environment) : environment_(environment) {}

  Raw value(const Node& node) {
    environment_.count(static_cast<std::uint64_t>(node.type.count()), node.where);
    switch (node.op) {
      case Op::Literal: return {node.raw};
      case Op::Variable: return variable(node);
      case Op::Element: {
        const Place place = element(node);
        const auto first = place.value->begin() + static_cast<std::ptrdiff_t>(place.first);
        return conform(Raw(first, first + static_cast<std::ptrdiff_t>(place.count)), node.operands[0]->type, node);
      }
      case Op::Array: return array(node);
      case Op::And: return {scalar(*node.operands[0]) != 0 && scalar(*node.operands[1]) != 0 ? 1u : 0u};
      case Op::Or: return {scalar(*node.operands[0]) != 0 || scalar(*node.operands[1]) != 0 ? 1u : 0u};
      case Op::Select: {
        const Node& chosen = *node.operands[scalar(*node.operands[0]) != 0 ? 1 : 2];
        return conform(value(chosen), chosen.type, node);
      }
      case Op::Less:
      case Op::LessEqual:
      case Op::Equal:
      case Op::NotEqual: return {comparison(node) ? 1u : 0u};
      case Op::ShiftLeft:
      case Op::ShiftRight: return shifted(node);
      case Op::Convert:
      case Op::Saturate: return converted(node);
      case Op::Noise:
      case Op::CellNoise: return {lattice(node)};
      case Op::Turbulence: {
        const Raw point = value(*node.operands[0]);
        return {turbulence(point.data(), octaves(*node.operands[1]))};
      }
      case Op::Texture:
      case Op::Environment: throw UniformError(node.where, "a texture lookup happens at the pixels, not on the host");
      case Op::Assign: {
        Raw assigned = assign(*node.operands[0], value(*node.operands[1]), node.operands[1]->type);
        return conform(std::move(assigned), root(*node.operands[0]).type, node);
      }
      case Op::Sequence: {
        Raw last;
        for (const NodePtr& part : node.operands) last = value(*part);
        return conform(std::move(last), node.operands.back()->type, node);
      }
      case Op::Postfix: {
        Raw old = value(*node.operands[0]);
        assign(*node.operands[0], value(*node.operands[1]), node.operands[1]->type);
        return conform(std::move(old), node.operands[0]->type, node);
      }
      case Op::Call: return conform(call(node), node.function->result, node);
      default: return elementwise(node);
    }
  }

 private:
  std::uint64_t scalar(const Node& node) { return value(node).at(0); }
  std::int64_t integer(const Node& node) {
    const std::uint64_t raw = scalar(node);
    return static_cast<std::int64_t>(convert(raw, node.type.scalar, Scalar::fixed(true, 64, 0), /*saturate=*/true));
  }

  Raw& stored(const Variable* variable) {
    Raw& value = environment_[variable];
    value.resize(static_cast<std::size_t>(variable->type.count()));
    return value;
  }
  Raw variable(const Node& node) {
    const Raw& value = stored(node.variable);
    // A reference may read fewer bits than the variable has.
    return conform(value, node.variable->type, node);
  }

  /// Scalars of one type as those of the node.
  static Raw conform(Raw value, const Type& from, const Node& node) {
    if (from.scalar == node.type.scalar) return value;
    for (std::uint64_t& raw : value) raw = convert(raw, from.scalar, node.type.scalar);
    return value;
  }

  Place place(const Node& node) {
    if (node.op == Op::Element) return element(node);
    if (node.op != Op::Variable) throw std::logic_error("assignment to what is no variable");
    Raw& value = stored(node.variable);
    return {&value, 0, value.size()};
  }

  Place element(const Node& node) {
    const Node& array = *node.operands[0];
    if (array.op != Op::Variable && array.op != Op::Element) {
      temporary_.push_back(std::make_unique<Raw>(value(array)));
      return part(node, {temporary_.back().get(), 0, temporary_.back()->size()}, array.type);
    }
    return part(node, place(array), array.type);
  }

  Place part(const Node& node, Place whole, const Type& type) {
    const std::int64_t index = integer(*node.operands[1]);
    const int length = type.dimensions[0];
    if (index < 0 || index >= length) {
      throw UniformError(node.operands[1]->where, "index " + std::to_string(index) +
                                                      " is outside of the array's 0 to " + std::to_string(length - 1));
    }
    const std::size_t count = whole.count / static_cast<std::size_t>(length);
    return {whole.value, whole.first + static_cast<std::size_t>(index) * count, count};
  }

  Raw array(const Node& node) {
    Raw result;
    for (const NodePtr& part : node.operands) {
      const Raw row = conform(value(*part), part->type, node);
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  }

  Raw elementwise(const Node& node) {
    const Raw x = value(*node.operands[0]);
    const Scalar& a = node.operands[0]->type.scalar;
    const Scalar& d = node.type.scalar;
    Raw y;
    Scalar b = a;
    if (node.operands.size() > 1) {
      y = value(*node.operands[1]);
      b = node.operands[1]->type.scalar;
    }
    Raw result(std::max(x.size(), y.size()));
    for (std::size_t n = 0; n < result.size(); ++n) {
      const std::uint64_t p = x[x.size() > 1 ? n : 0];
      const std::uint64_t q = y.empty() ? 0 : y[y.size() > 1 ? n : 0];
      switch (node.op) {
        case Op::Not: result[n] = p == 0; break;
        case Op::Abs:
        case Op::Floor:
        case Op::Ceil:
        case Op::Round:
        case Op::SquareRoot: result[n] = unary(node.op, p, a, d); break;
        case Op::Math: result[n] = math(node.math, p, q); break;
        default: result[n] = arithmetic(node.op, p, a, q, b, d);
      }
    }
    return result;
  }

  bool comparison(const Node& node) {
    const Raw x = value(*node.operands[0]), y = value(*node.operands[1]);
    const Scalar &a = node.operands[0]->type.scalar, &b = node.operands[1]->type.scalar;
    if (x.size() == 1 && y.size() == 1) return compare(node.op, x[0], a, y[0], b);
    bool all = true;
    for (std::size_t n = 0; n < std::max(x.size(), y.size()); ++n) {
      all = all && compare(Op::Equal, x[x.size() > 1 ? n : 0], a, y[y.size() > 1 ? n : 0], b);
    }
    return node.op == Op::Equal ? all : !all;
  }

  /// By a constant, the exponent moves; by another count, the bits.
  Raw shifted(const Node& node) {
    Raw result = value(*node.operands[0]);
    Scalar from = node.operands[0]->type.scalar;
    const std::int64_t count = integer(*node.operands[1]);
    const bool left = node.op == Op::ShiftLeft;
    if (node.operands[1]->op == Op::Literal) {
      from.exponent += left ? -static_cast<int>(count) : static_cast<int>(count);
      for (std::uint64_t& raw : result) raw = convert(raw, from, node.type.scalar);
      return result;
    }
    if (count < 0 || count > 64) {
      throw UniformError(node.operands[1]->where,
                         "a shift by " + std::to_string(count) + " places; 0 to 64 are possible");
    }
    for (std::uint64_t& raw : result) {
      Scalar moved = from;
      moved.exponent += left ? -static_cast<int>(count) : static_cast<int>(count);
      raw = convert(wrap(convert(raw, moved, from), from), from, node.type.scalar);
    }
    return result;
  }

  Raw converted(const Node& node) {
    Raw result = value(*node.operands[0]);
    const Scalar& from = node.operands[0]->type.scalar;
    const Scalar& to = node.type.scalar;
    const bool saturate = node.op == Op::Saturate;
    for (std::uint64_t& raw : result) {
      if (!saturate && node.exact == Scalar::boolean() && !from.is_float) {
        raw = raw != 0;
      } else {
        raw = convert(raw, from, to, saturate);
      }
    }
    return result;
  }

  std::uint64_t lattice(const Node& node) {
    std::vector<std::uint64_t> coordinates;
    std::vector<Scalar> types;
    for (const NodePtr& operand : node.operands) {
      for (const std::uint64_t raw : value(*operand)) {
        coordinates.push_back(raw);
        types.push_back(operand->type.scalar);
      }
    }
    const int dimensions = static_cast<int>(coordinates.size());
    if (node.op == Op::CellNoise) return cell_noise(coordinates.data(), types.data(), dimensions);
    return noise(coordinates.data(), dimensions, types[0].is_float);
  }

  std::int64_t octaves(const Node& node) {
    const std::int64_t count = integer(node);
    if (count > kMostOctaves) {
      throw UniformError(node.where, "turbulence of " + std::to_string(count) + " octaves; " +
                                         std::to_string(kMostOctaves) + " at most");
    }
    return count;
  }

  Raw assign(const Node& target, const Raw& value, const Type& type) {
    const Place to = place(target);
    const Scalar declared = root(target).type.scalar;
    Raw result(to.count);
    for (std::size_t n = 0; n < to.count; ++n) {
      result[n] = convert(value[value.size() > 1 ? n : 0], type.scalar, declared);
      (*to.value)[to.first + n] = result[n];
    }
    return result;
  }
  static const Variable& root(const Node& target) {
    return target.op == Op::Element ? root(*target.operands[0]) : *target.variable;
  }

  Raw call(const Node& node) {
    const Function& function = *node.function;
    const UniformFunction external = uniform_external(function.linkage);
    if (!external) {
      throw UniformError(node.where,
                         "external function '" + function.name + "' is not registered as '" + function.linkage + "'");
    }
    std::vector<Raw> arguments;
    for (const NodePtr& operand : node.operands) arguments.push_back(value(*operand));
    Raw result = external(arguments);
    if (result.size() != static_cast<std::size_t>(function.result.is_void ? 0 : function.result.count())) {
      throw UniformError(node.where, "external function '" + function.name + "' returned " +
                                         std::to_string(result.size()) + " values");
    }
    for (std::size_t n = 0; n < node.operands.size(); ++n) {
      if (function.parameters[n]->output) assign(*node.operands[n], arguments[n], function.parameters[n]->type);
    }
    for (std::uint64_t& raw : result) raw = legal(raw, function.result.scalar);
    return result;
  }
  /// What comes from outside is brought to the type's own form.
  static std::uint64_t legal(std::uint64_t raw, const Scalar& type) {
    return type.is_float ? from_float(as_float(raw)) : wrap(raw, type);
  }

  Environment& environment_;
  std::vector<std::unique_ptr<Raw>> temporary_;
};

}  // namespace

void Environment::count(std::uint64_t operations, Location where) {
  operations_ += operations;
  if (operations_ > kMostOperations) {
    throw UniformError(where, "uniform code has not ended after " + std::to_string(kMostOperations) + " operations");
  }
}

Raw evaluate(const Node& node, Environment& environment) { return Evaluator(environment).value(node); }

}  // namespace pfman
