// The places that variables of the tree and their elements have in pixel memory.
#include <stdexcept>

#include "pixelflow/compiler/lowering.h"

namespace pfman {

NodePtr Lowering::index_tree(const Node& node) {
  return make_node(Op::Saturate, Scalar::fixed(true, 64, 0), nodes(once(uniform_tree(node))), node.where);
}

/// Elements by an index that is known when the stream is made: they must lie one after another.
Term Lowering::first_of(const Terms& all, const Scalar& scalar) {
  bool together = true;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const ir::Operand& operand = all[n].at;
    together = together && operand.kind == ir::Operand::Kind::Pixel && operand.index < 0 &&
               operand.variable == all[0].at.variable &&
               operand.offset == all[0].at.offset + static_cast<int>(n) * scalar.bytes();
  }
  return together ? all.at(0) : Term{whole(gathered(all, scalar)), scalar};
}

/// An index for each dimension becomes one for the whole: looked up in an array of the elements' numbers, so that each
/// is held to its own dimension.
NodePtr Lowering::table_lookup(const Node& element, int rows, int columns) {
  const Scalar number = Scalar::fixed(false, 32, 0);
  Nodes table;
  for (int r = 0; r < rows; ++r) {
    Nodes row;
    for (int c = 0; c < columns; ++c) {
      row.push_back(make_literal(number, static_cast<std::uint64_t>(r * columns + c), element.where));
    }
    table.push_back(make_array(std::move(row), element.where));
  }
  const NodePtr whole_table = make_read(hoist(make_array(std::move(table), element.where)), element.where);
  const NodePtr row = make_element(*whole_table, *index_tree(*element.operands[0]->operands[1]));
  return make_element(*row, *index_tree(*element.operands[1]));
}

/// The scalars of an element, or of a row of a two-dimensional array.
Terms Lowering::element_of(const Node& node) {
  const Node& array = *node.operands[0];
  const bool in_row = array.op == Op::Element;
  const Node& base = in_row ? *array.operands[0] : array;
  const Node& first = in_row ? *array.operands[1] : *node.operands[1];
  const Node* const second = in_row ? node.operands[1].get() : nullptr;
  const int rows = base.type.dimensions[0], columns = base.type.rank == 2 ? base.type.dimensions[1] : 1;
  const int count = base.type.rank == 2 && !second ? columns : 1;

  const auto known = [](const Node& index) {
    const int exponent = index.type.scalar.exponent;
    return static_cast<int>(exponent >= 0 ? index.raw >> exponent : index.raw << -exponent);
  };
  const bool row_known = first.op == Op::Literal, column_known = !second || second->op == Op::Literal;
  const Terms all = place_of(base);
  const int before = (row_known ? known(first) * columns : 0) + (second && column_known ? known(*second) : 0);
  if (row_known && column_known) {
    if (before < 0 || before + count > static_cast<int>(all.size())) {
      throw std::logic_error("a constant index out of range");
    }
    return Terms(all.begin() + before, all.begin() + before + count);
  }

  Term element = first_of(all, base.type.scalar);
  const int bytes = base.type.scalar.bytes();
  element.at.offset += before * bytes;
  NodePtr index;
  if (!row_known && !column_known) {
    index = table_lookup(node, rows, columns);
    element.at.elements = rows * columns;
  } else if (row_known) {
    index = index_tree(*second);
    element.at.elements = columns;
  } else {
    index = index_tree(first);
    element.at.elements = (rows - 1) * columns + 1;
    if (columns > 1) {
      const Scalar wide = index->type.scalar;
      NodePtr factor = make_literal(wide, static_cast<std::uint64_t>(columns), where_);
      index = make_node(Op::Multiply, wide, nodes(std::move(index), std::move(factor)), first.where);
    }
  }
  element.at.index = add_uniform(std::move(index));
  Terms result;
  for (int n = 0; n < count; ++n) {
    result.push_back(element);
    element.at.offset += bytes;
  }
  return result;
}

/// The scalars that a variable or an element consists of, as they are declared.
Terms Lowering::place_of(const Node& node) {
  if (node.op == Op::Element) return element_of(node);
  if (node.op != Op::Variable) return lower_node(node);
  const Binding& bound = binding(*node.variable);
  if (!bound.values.empty()) return bound.values;
  const Scalar& scalar = node.variable->type.scalar;
  Terms values;
  for (int n = 0; n < node.variable->type.count(); ++n) {
    const bool together = bound.variables.size() == 1;
    values.push_back(
        {together ? whole(bound.variables[0], n) : whole(bound.variables[static_cast<std::size_t>(n)]), scalar});
  }
  return values;
}

}  // namespace pfman
