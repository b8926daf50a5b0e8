// Noise, cells, turbulence and lookups: operations on points whose coordinates lie one after another.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {
namespace {

constexpr std::uint64_t kHash[3] = {0x9E37, 0x79B9, 0x85EB};
constexpr std::uint64_t kMix[2] = {0x6A35, 0xB4D3};
constexpr int kMixShift[2] = {8, 7};
constexpr std::uint64_t kFloatOne = 0x3F800000, kFloatHalf = 0x3F000000;

}  // namespace

Term Lowering::lower_noise(const Node& node) {
  Terms point;
  for (const NodePtr& operand : node.operands) {
    const Terms part = lower_node(*operand);
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
Term Lowering::cell(const Term& coordinate) {
  const Scalar byte = Scalar::fixed(false, kBitsOfByte, 0), integer = Scalar::integer();
  if (coordinate.at.kind == ir::Operand::Kind::Uniform) {
    NodePtr tree =
        make_node(Op::Convert, coordinate.type.is_float ? integer : byte, nodes(tree_of(coordinate)), where_);
    if (coordinate.type.is_float) tree = make_node(Op::Convert, byte, nodes(std::move(tree)), where_);
    return uniform_value(std::move(tree));
  }
  return reduced(coordinate.type.is_float ? to_fixed(coordinate, integer) : aligned(coordinate, 0, kBitsOfByte), byte);
}

Term Lowering::lower_cell_noise(const Node& node) {
  Terms point;
  for (const NodePtr& operand : node.operands) {
    const Terms part = lower_node(*operand);
    point.insert(point.end(), part.begin(), part.end());
  }
  const Scalar word = Scalar::fixed(false, 16, 0), byte = Scalar::fixed(false, kBitsOfByte, kBitsOfByte);
  ir::Operand x;
  for (std::size_t n = 0; n < point.size(); ++n) {
    const Term index = wrapped(cell(point[n]));
    ir::Operand term;
    if (index.at.kind == ir::Operand::Kind::Uniform) {
      NodePtr factor = make_literal(word, kHash[n], where_);
      term = uniform_value(make_node(Op::Multiply, word, nodes(tree_of(index), std::move(factor)), where_)).at;
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
Term Lowering::lower_turbulence(const Node& node) {
  const Scalar type = Scalar::floating(), count_type = Scalar::fixed(true, 64, 0);
  const int point = gathered(lower_node(*node.operands[0]), type);
  Variable* const octaves = checked_octaves(*node.operands[1]);
  Variable* const i = hoist(make_literal(count_type, 1, where_));
  Variable* const weight = hoist(make_literal(type, kFloatHalf, where_));
  const Term one{constant(kFloatOne, type), type};
  const auto term = [&] {
    const Term noise{operate(Code::NoiseFloat, type, whole(point), {}, 3), type};
    return float_abs(float_binary(Code::FloatSub, float_binary(Code::FloatAdd, noise, noise), one));
  };
  const auto update = [&](Variable* variable, Op op, NodePtr value) {
    const Scalar& scalar = variable->type.scalar;
    assign(variable, make_node(op, scalar, nodes(make_read(variable, where_), std::move(value)), where_));
  };
  const auto less = [&](Variable* a, Variable* b) {
    return make_node(Op::Less, Scalar::boolean(), nodes(make_read(a, where_), make_read(b, where_)), where_);
  };

  const ir::Operand sum = temporary(type);
  Variable* const zero = hoist(make_literal(count_type, 0, where_));
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
  const Term weighted = float_binary(Code::FloatMultiply, term(), elements_of(weight).at(0));
  operate_into(sum, Code::FloatAdd, sum, weighted.at);
  ir::Instruction next;
  next.kind = Kind::LoopNext;
  next.match = loop;
  append(std::move(next));
  update(i, Op::Add, make_literal(count_type, 1, where_));
  update(weight, Op::Multiply, make_literal(type, kFloatHalf, where_));
  end_loop(loop);
  return {sum, type};
}

/// The host's own turbulence, of any point, refuses what is too much.
Variable* Lowering::checked_octaves(const Node& node) {
  Variable* const octaves = hoist(index_tree(node));
  Nodes origin;
  for (int n = 0; n < 3; ++n) origin.push_back(make_literal(Scalar::floating(), 0, node.where));
  NodePtr turbulence = make_node(Op::Turbulence, Scalar::floating(), {}, node.where);
  turbulence->operands = nodes(make_array(std::move(origin), node.where), make_read(octaves, node.where));
  hoist(std::move(turbulence));
  return octaves;
}

Terms Lowering::lower_lookup(const Node& node) {
  const Scalar byte = Scalar::fixed(false, kBitsOfByte, kBitsOfByte);
  Terms coordinates;
  for (std::size_t n = 1; n < node.operands.size(); ++n) {
    const Terms part = lower_node(*node.operands[n]);
    coordinates.insert(coordinates.end(), part.begin(), part.end());
  }
  ir::Instruction lookup;
  lookup.kind = Kind::Lookup;
  lookup.environment = node.op == Op::Environment;
  lookup.shared = node.shared;
  lookup.uniform = add_uniform(index_tree(*node.operands[0]));
  lookup.a = whole(gathered(coordinates, Scalar::floating()));
  const int texel = add_variable({}, byte, node.type.count(), true);
  lookup.d = whole(texel);
  append(std::move(lookup));
  Terms values;
  for (int n = 0; n < node.type.count(); ++n) values.push_back({whole(texel, n), byte});
  return values;
}

}  // namespace pfman
