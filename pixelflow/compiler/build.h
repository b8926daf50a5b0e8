// Pieces of typed trees: nodes with their types, rates and bottom-up sizes set.
#pragma once

#include <vector>

#include "pixelflow/compiler/tree.h"

namespace pfman {

using Nodes = std::vector<NodePtr>;

template <typename... Each>
Nodes nodes(Each... each) {
  Nodes list;
  (list.push_back(std::move(each)), ...);
  return list;
}

NodePtr make_literal(const Scalar& scalar, std::uint64_t raw, Location where);
NodePtr make_float(double value, Location where);
NodePtr make_integer(std::int64_t value, Location where);  ///< the smallest fixed-point type that holds it
NodePtr make_read(Variable* variable, Location where);
/// An operation of the given scalar type; shape and rate are those of its operands together.
NodePtr make_node(Node::Op op, const Scalar& scalar, Nodes operands, Location where);
/// Arithmetic and comparisons of operands that are both float or both fixed; Negate to SquareRoot of one operand.
NodePtr make_operation(Node::Op op, Nodes operands, Location where);
NodePtr make_math(pixelflow::Code code, Nodes operands, Location where);
/// Elements of one shape and one kind: float, or fixed of any type.
NodePtr make_array(Nodes elements, Location where);
NodePtr make_select(NodePtr condition, NodePtr first, NodePtr second, Location where);
NodePtr make_assign(NodePtr target, NodePtr value, Location where);
/// `before`, in order, then `value`; just the value if nothing is before it.
NodePtr make_sequence(Nodes before, NodePtr value, Location where);
/// The node in another scalar type; itself where it has that type and nothing is left to size.
NodePtr make_convert(NodePtr node, const Scalar& to);
NodePtr to_float(NodePtr node);

StatementPtr make_statement(Statement::Kind kind, Location where);
StatementPtr make_evaluate(NodePtr expression);

/// Whether the elements of an expression without effects are expressions of its operands' elements. One that is_pure()
/// may be asked for several elements, others assign hidden variables each time.
bool has_elements(const Node& array, const Node& index);
/// Element of an array that has_elements(): of an operation, the operation on the operands' elements.
NodePtr make_element(const Node& array, const Node& index);
NodePtr make_element(const Node& array, int index);

/// Cheap to write down twice: a literal, a variable, an element of one by a constant index, an array of such.
bool is_plain(const Node& node);
/// Holds no assignment and no call.
bool is_pure(const Node& node);

}  // namespace pfman
