// The library's functions of vectors, and noise and lookups, written out.
#include <algorithm>

#include "pixelflow/compiler/checker.h"

namespace pfman {
namespace {

using Op = Node::Op;

bool is_vector(const Type& type, int least, int most) {
  return type.rank == 1 && type.dimensions[0] >= least && type.dimensions[0] <= most;
}

NodePtr root_of(NodePtr node, Location where) { return make_operation(Op::SquareRoot, nodes(std::move(node)), where); }

/// a[j] b[k] - a[k] b[j]
NodePtr minor(const Node& a, const Node& b, int j, int k, Location where) {
  NodePtr first = make_operation(Op::Multiply, nodes(make_element(a, j), make_element(b, k)), where);
  NodePtr second = make_operation(Op::Multiply, nodes(make_element(a, k), make_element(b, j)), where);
  return make_operation(Op::Subtract, nodes(std::move(first), std::move(second)), where);
}

}  // namespace

Value Checker::vectors(const std::string& name, Values arguments, Location where) {
  const int least = name == "cross" || name == "bump" ? 3 : 2, most = least == 3 ? 3 : 4;
  const std::size_t count = name == "bump" ? 3 : arguments.size();
  for (std::size_t n = 0; n < arguments.size(); ++n) {
    const Type& type = arguments[n].type();
    const bool fits =
        n < count ? is_vector(type, least, most) && type.same_shape(arguments[0].type()) : !type.is_array();
    if (!fits) {
      return mistake(
          132, arguments[n].where,
          "argument " + std::to_string(n + 1) + " of '" + name + "' cannot be '" + arguments[n].spelled() + "'");
    }
  }
  Nodes given;
  settle_together(std::move(arguments), given);
  if (std::any_of(given.begin(), given.end(), [](const NodePtr& node) { return !node; })) return {};
  const bool float_only = name == "normalize" || name == "faceforward" || name == "reflect" || name == "bump";
  Nodes before;
  for (NodePtr& node : given) {
    if (float_only) node = to_float(std::move(node));
    const bool once = name == "dot" || name == "distance";
    node = once ? write_.by_elements(std::move(node), before) : write_.reuse(std::move(node), before);
  }
  NodePtr result;
  if (name == "dot") {
    result = make_dot(*given[0], *given[1], where);
  } else if (name == "cross") {
    result = make_array(nodes(minor(*given[0], *given[1], 1, 2, where), minor(*given[0], *given[1], 2, 0, where),
                              minor(*given[0], *given[1], 0, 1, where)),
                        where);
  } else if (name == "length") {
    result = root_of(make_dot(*given[0], *given[0], where), where);
  } else if (name == "distance") {
    NodePtr apart =
        write_.keep(make_operation(Op::Subtract, nodes(std::move(given[0]), std::move(given[1])), where), before);
    result = root_of(make_dot(*apart, *apart, where), where);
  } else if (name == "normalize") {
    result = write_.normalized(std::move(given[0]), before);
  } else if (name == "faceforward") {
    NodePtr behind =
        make_operation(Op::Less, nodes(make_dot(*given[1], *given[0], where), make_float(0, where)), where);
    NodePtr turned = make_operation(Op::Negate, nodes(clone(*given[0])), where);
    result = make_select(std::move(behind), std::move(given[0]), std::move(turned), where);
  } else if (name == "reflect") {
    NodePtr twice =
        make_operation(Op::Multiply, nodes(make_float(2, where), make_dot(*given[0], *given[1], where)), where);
    NodePtr along =
        make_operation(Op::Multiply, nodes(write_.keep(std::move(twice), before), std::move(given[1])), where);
    result = make_operation(Op::Subtract, nodes(std::move(given[0]), std::move(along)), where);
  } else {
    NodePtr s = make_operation(Op::Multiply, nodes(std::move(given[3]), std::move(given[1])), where);
    NodePtr t = make_operation(Op::Multiply, nodes(std::move(given[4]), std::move(given[2])), where);
    NodePtr once = make_operation(Op::Subtract, nodes(std::move(given[0]), std::move(s)), where);
    result = write_.normalized(make_operation(Op::Subtract, nodes(std::move(once), std::move(t)), where), before);
  }
  result->precise = true;
  return Value::typed(make_sequence(std::move(before), std::move(result), where));
}

/// transform_point and transform_vector.
Value Checker::transformed(const std::string& name, Values arguments, Location where) {
  const Type &matrix = arguments[0].type(), &vector = arguments[1].type();
  if (matrix.rank != 2 || matrix.dimensions != std::array{4, 4} || !is_vector(vector, 3, 3)) {
    return mistake(132, where, "'" + name + "' takes a matrix float[4][4] and a vector float[3]");
  }
  if (matrix.varying) return mistake(301, arguments[0].where, "the matrix of '" + name + "' has to be uniform");
  Nodes before;
  NodePtr m = convert_to(std::move(arguments[0]), Scalar::floating());
  NodePtr p = convert_to(std::move(arguments[1]), Scalar::floating());
  if (!m || !p) return {};
  m = write_.reuse(std::move(m), before);
  p = write_.reuse(std::move(p), before);
  Nodes rows;
  for (int i = 0; i < 3; ++i) {
    const NodePtr row = make_element(*m, i);
    NodePtr sum;
    for (int j = 0; j < 3; ++j) {
      NodePtr product = make_operation(Op::Multiply, nodes(make_element(*row, j), make_element(*p, j)), where);
      sum = sum ? make_operation(Op::Add, nodes(std::move(sum), std::move(product)), where) : std::move(product);
    }
    if (name == "transform_point") sum = make_operation(Op::Add, nodes(std::move(sum), make_element(*row, 3)), where);
    rows.push_back(std::move(sum));
  }
  return Value::typed(make_sequence(std::move(before), make_array(std::move(rows), where), where));
}

}  // namespace pfman
