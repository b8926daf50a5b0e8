// Noise, cells, turbulence and lookups: operations on points whose coordinates lie one after another.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
namespace {

constexpr int kBitsOfByte = 8;
constexpr std::uint64_t kHash[3] = {0x9E37, 0x79B9, 0x85EB};
constexpr std::uint64_t kMix[2] = {0x6A35, 0xB4D3};
constexpr int kMixShift[2] = {8, 7};
constexpr std::uint64_t kFloatOne = 0x3F800000, kFloatHalf = 0x3F000000;

}  // namespace

int Lowering::gathered(const Values& values, const Scalar& type, int count) {
  const int most = std::max(static_cast<int>(values.size()), count);
  const int variable = add_variable({}, type, most, true);
  for (int n = 0; n < most; ++n) {
    store({whole(variable, n), type}, values[values.size() > 1 ? static_cast<std::size_t>(n) : 0]);
  }
  return variable;
}

Value Lowering::lower_noise(const Node& node) {
  Values point;
  for (const NodePtr& operand : node.operands) {
    const Values part = lower_node(*operand);
    point.insert(point.end(), part.begin(), part.end());
  }
  const bool is_float = point.at(0).type.is_float;
  const Scalar coordinate = is_float ? Scalar::floating() : Scalar::fixed(true, 16, 8);
  const Scalar type = is_float ? Scalar::floating() : Scalar::fixed(false, 16, 16);
  const int variable = gathered(point, coordinate);
  const Code code = is_float ? Code::NoiseFloat : Code::NoiseFixed;
  return {operate(code, type, whole(variable), {}, static_cast<int>(point.size())), type};
}

/// A coordinate's integer part, modulo 256.
Value Lowering::cell(const Value& coordinate) {
  const Scalar byte = Scalar::fixed(false, kBitsOfByte, 0), integer = Scalar::integer();
  if (coordinate.at.kind == ir::Operand::Kind::Uniform) {
    NodePtr tree = make_unary(Op::Convert, coordinate.type.is_float ? integer : byte, tree_of(coordinate));
    if (coordinate.type.is_float) tree = make_unary(Op::Convert, byte, std::move(tree));
    return uniform_value(std::move(tree));
  }
  return reduced(coordinate.type.is_float ? to_fixed(coordinate, integer) : aligned(coordinate, 0, kBitsOfByte), byte);
}

Value Lowering::lower_cell_noise(const Node& node) {
  Values point;
  for (const NodePtr& operand : node.operands) {
    const Values part = lower_node(*operand);
    point.insert(point.end(), part.begin(), part.end());
  }
  const Scalar word = Scalar::fixed(false, 16, 0), byte = Scalar::fixed(false, kBitsOfByte, kBitsOfByte);
  ir::Operand x;
  for (std::size_t n = 0; n < point.size(); ++n) {
    const Value index = wrapped(cell(point[n]));
    ir::Operand term;
    if (index.at.kind == ir::Operand::Kind::Uniform) {
      NodePtr factor = make_literal(kHash[n], word, where_);
      term = uniform_value(make_binary(Op::Multiply, word, tree_of(index), std::move(factor))).at;
    } else {
      term = operate(Code::Multiply, word, index.at, constant(kHash[n], word));
    }
    x = n == 0 ? term : operate(Code::Add, word, x, term);
  }
  for (int n = 0; n < 2; ++n) {
    const ir::Operand upper = operate(Code::ShiftRight, word, x, {}, kMixShift[n]);
    x = operate(Code::Multiply, word, join(Kind::Xor, word, x, upper), constant(kMix[n], word));
  }
  x.offset += 1;
  x.bytes = 1;
  return {x, byte};
}

/// The sum of abs(2 noise(2^i p) - 1) / 2^i, in this order.
Value Lowering::lower_turbulence(const Node& node) {
  const Scalar type = Scalar::floating(), count_type = Scalar::fixed(true, 64, 0);
  const int point = gathered(lower_node(*node.operands[0]), type);
  Variable* const octaves = checked_octaves(*node.operands[1]);
  Variable* const i = hoist(make_literal(1, count_type, where_));
  Variable* const weight = hoist(make_literal(kFloatHalf, type, where_));
  const Value one{constant(kFloatOne, type), type};
  const auto term = [&] {
    const Value noise{operate(Code::NoiseFloat, type, whole(point), {}, 3), type};
    return float_abs(float_binary(Code::FloatSub, float_binary(Code::FloatAdd, noise, noise), one));
  };
  const auto add_to = [&](Variable* variable, Op op, NodePtr value, const Scalar& scalar) {
    NodePtr assign = make_node(Op::Assign, variable->type, where_);
    assign->operands.push_back(make_reference(*variable, where_));
    assign->operands.push_back(make_binary(op, scalar, make_reference(*variable, where_), std::move(value)));
    evaluate(std::move(assign));
  };
  const auto less = [&](Variable* a, Variable* b) {
    return make_binary(Op::Less, Scalar::boolean(), make_reference(*a, where_), make_reference(*b, where_));
  };

  const ir::Operand sum = temporary(type);
  Variable* const zero = hoist(make_literal(0, count_type, where_));
  const int opening = begin_if(less(zero, octaves));
  operate_into(sum, Code::Copy, term().at);
  const int middle = begin_else(opening);
  operate_into(sum, Code::Copy, constant(0, type));
  end_if(middle);
  const int loop = begin_loop();
  ir::Instruction test;
  test.kind = Kind::LoopTest;
  test.uniform = add_uniform(less(i, octaves));
  test.match = loop;
  append(std::move(test));
  for (int n = 0; n < 3; ++n) operate_into(whole(point, n), Code::FloatAdd, whole(point, n), whole(point, n));
  const Value weighted = float_binary(Code::FloatMultiply, term(), elements_of(*weight).at(0));
  operate_into(sum, Code::FloatAdd, sum, weighted.at);
  ir::Instruction next;
  next.kind = Kind::LoopNext;
  next.match = loop;
  append(std::move(next));
  add_to(i, Op::Add, make_literal(1, count_type, where_), count_type);
  add_to(weight, Op::Multiply, make_literal(kFloatHalf, type, where_), type);
  end_loop(loop);
  return {sum, type};
}

/// The host's own turbulence, of any point, refuses what is too much.
Variable* Lowering::checked_octaves(const Node& node) {
  Variable* const octaves = hoist(index_tree(node));
  Type point_type;
  point_type.scalar = Scalar::floating();
  point_type.rank = 1;
  point_type.dimensions = {3, 1};
  NodePtr point = make_node(Op::Array, point_type, node.where);
  for (int n = 0; n < 3; ++n) point->operands.push_back(make_literal(0, Scalar::floating(), node.where));
  hoist(make_binary(Op::Turbulence, Scalar::floating(), std::move(point), make_reference(*octaves, node.where)));
  return octaves;
}

Values Lowering::lower_lookup(const Node& node) {
  const Scalar byte = Scalar::fixed(false, kBitsOfByte, kBitsOfByte);
  Values coordinates;
  for (std::size_t n = 1; n < node.operands.size(); ++n) {
    const Values part = lower_node(*node.operands[n]);
    coordinates.insert(coordinates.end(), part.begin(), part.end());
  }
  ir::Instruction lookup;
  lookup.kind = Kind::Lookup;
  lookup.environment = node.op == Op::Environment;
  lookup.uniform = add_uniform(index_tree(*node.operands[0]));
  lookup.a = whole(gathered(coordinates, Scalar::floating()));
  const int texel = add_variable({}, byte, node.type.count(), true);
  lookup.d = whole(texel);
  append(std::move(lookup));
  Values values;
  for (int n = 0; n < node.type.count(); ++n) values.push_back({whole(texel, n), byte});
  return values;
}

}  // namespace pfman
