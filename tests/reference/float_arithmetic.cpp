// Float arithmetic on the host, rounded to nearest even, and what is made of it; functions of the float library.
#include <algorithm>
#include <cmath>
#include <map>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/reference/builtin.h"

namespace reference {

using pfman::ast::Operator;

namespace {

Value together(const Value& a, const Value& b, Operator op) {
  Value value(std::max(a.lanes, b.lanes), std::max(a.elements(), b.elements()));
  for (int element = 0; element < value.elements(); ++element) {
    for (int lane = 0; lane < value.lanes; ++lane) {
      value.to(element, lane) = float_operation(op, a.at(element, lane), b.at(element, lane));
    }
  }
  return value;
}

}  // namespace

float float_floor(float x) {
  if (std::isnan(x) || std::fabs(x) >= 0x1p23f) return x;
  return std::floor(x) + 0.0f;  // a negative zero becomes a positive one
}

Raw float_operation(Operator op, Raw a, Raw b) {
  const float x = as_float(a), y = as_float(b);
  switch (op) {
    case Operator::Add: return float_bits(x + y);
    case Operator::Subtract: return float_bits(x - y);
    case Operator::Multiply: return float_bits(x * y);
    case Operator::Divide: return float_bits(x / y);
    case Operator::Remainder: return float_bits(x - y * float_floor(x / y));
    default: throw Error(202, "bits of a float");
  }
}

Value float_difference(const Value& a, const Value& b) { return together(a, b, Operator::Subtract); }
Value float_product(const Value& a, const Value& b) { return together(a, b, Operator::Multiply); }

Value float_value(float value) {
  Value made(1, 1);
  made.raw[0] = float_bits(value);
  return made;
}

Value float_negated(const Value& a) {
  Value value = a;
  for (Raw& raw : value.raw) raw = float_bits(-as_float(raw));
  return value;
}

Value float_square_root(const Value& a) {
  Value value = a;
  for (Raw& raw : value.raw) raw = float_bits(std::sqrt(as_float(raw)));
  return value;
}

Value float_dot(const Value& a, const Value& b) {
  const Value products = float_product(a, b);
  Value sum(products.lanes, 1);
  for (int lane = 0; lane < sum.lanes; ++lane) {
    Raw total = products.at(0, lane);
    for (int n = 1; n < products.elements(); ++n) total = float_operation(Operator::Add, total, products.at(n, lane));
    sum.to(0, lane) = total;
  }
  return sum;
}

Value normalized(const Value& a) {
  const Value length = float_square_root(float_dot(a, a));
  Value value = a;
  for (int element = 0; element < a.elements(); ++element) {
    for (int lane = 0; lane < a.lanes; ++lane) {
      const Raw by = length.at(0, lane);
      value.to(element, lane) = as_float(by) == 0 ? 0 : float_operation(Operator::Divide, a.at(element, lane), by);
    }
  }
  return value;
}

Value library_function(const std::string& name, const std::vector<const Value*>& arguments) {
  using namespace pixelflow::native;
  int lanes = 1;
  for (const Value* argument : arguments) lanes = std::max(lanes, argument->lanes);
  const int elements = arguments[0]->elements();
  const auto count = static_cast<std::size_t>(lanes * elements);
  std::vector<std::uint32_t> columns[2];
  for (std::size_t n = 0; n < arguments.size(); ++n) {
    for (int element = 0; element < elements; ++element) {
      for (int lane = 0; lane < lanes; ++lane) {
        columns[n].push_back(static_cast<std::uint32_t>(arguments[n]->at(element, lane)));
      }
    }
  }
  std::vector<std::uint32_t> results(count);
  for (const UnaryFunction& function : unary_functions()) {
    if (function.name == name && arguments.size() == 1) function.batch(columns[0].data(), results.data(), count);
  }
  for (const BinaryFunction& function : binary_functions()) {
    if (function.name == name && arguments.size() == 2) {
      function.batch(columns[0].data(), columns[1].data(), results.data(), count);
    }
  }
  Value value(lanes, elements);
  std::copy(results.begin(), results.end(), value.raw.begin());
  return value;
}

}  // namespace reference
