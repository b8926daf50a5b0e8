#include <array>

#include "pixelflow/language/parser_state.h"

namespace pfman {

using ast::Base;
using ast::Rate;
using ast::Sign;
using ast::Specifiers;
using ast::Transform;

bool Parser::at_type() const {
  constexpr std::array kWords = {"uniform",
                                 "varying",
                                 "signed",
                                 "unsigned",
                                 "output",
                                 "unit",
                                 "float",
                                 "int",
                                 "bool",
                                 "fixed",
                                 "transform_as_point",
                                 "transform_as_vector",
                                 "transform_as_normal",
                                 "transform_as_texture"};
  if (now().kind != Token::Kind::Keyword) return false;
  for (const char* word : kWords) {
    if (now().text == word) return true;
  }
  return false;
}

/// Also takes `void`, which the caller admits only for results.
ast::SpecifiersPtr Parser::specifiers() {
  auto specs = std::make_shared<Specifiers>();
  specs->where = now().where;
  if (accept("void")) return specs;
  bool based = false;
  while (at_type()) specifier(*specs, based);
  if (!based) unexpected("a type");
  if (at("[")) specs->dimensions = dimensions(0);
  return specs;
}

void Parser::specifier(Specifiers& specs, bool& based) {
  const Token token = now();
  const auto twice = [&](bool same) {
    report(102, token.where,
           same ? "'" + token.text + "' stands twice" : "'" + token.text + "' contradicts what stands before it");
  };
  const auto set = [&](auto& field, auto value, auto none) {
    if (field != none) twice(field == value);
    field = value;
    take();
  };
  if (token.text == "uniform") return set(specs.rate, Rate::Uniform, Rate::Unspecified);
  if (token.text == "varying") return set(specs.rate, Rate::Varying, Rate::Unspecified);
  if (token.text == "signed") return set(specs.sign, Sign::Signed, Sign::Unspecified);
  if (token.text == "unsigned") return set(specs.sign, Sign::Unsigned, Sign::Unspecified);
  if (token.text == "output") return set(specs.output, true, false);
  if (token.text == "unit") {
    if (specs.transform == Transform::None) specs.attribute = token.where;
    return set(specs.unit, true, false);
  }
  if (token.text.starts_with("transform_as_")) {
    const Transform transform = token.text == "transform_as_point"    ? Transform::Point
                                : token.text == "transform_as_vector" ? Transform::Vector
                                : token.text == "transform_as_normal" ? Transform::Normal
                                                                      : Transform::Texture;
    if (specs.transform != Transform::None) report(221, token.where, "two transform attributes");
    specs.transform = transform;
    specs.attribute = token.where;
    take();
    return;
  }
  if (based) {
    report(102, token.where, "'" + token.text + "' is a second type");
    throw Panic{};
  }
  based = true;
  base_type(specs);
}

void Parser::base_type(Specifiers& specs) {
  if (accept("float")) {
    specs.base = Base::Float;
  } else if (accept("int")) {
    specs.base = Base::Int;
  } else if (accept("bool")) {
    specs.base = Base::Bool;
  } else if (accept("fixed")) {
    constexpr int kAdditive = 9;  // neither > nor >> belongs to the numbers, except in parentheses
    specs.base = Base::Fixed;
    expect("<");
    specs.size = binary(kAdditive);
    expect(",");
    specs.exponent = binary(kAdditive);
    expect(">");
  } else {
    unexpected("a type");
  }
}

void Parser::check_specifiers(const Specifiers& specs, bool parameter) {
  if (specs.sign != Sign::Unspecified && specs.base != Base::Fixed) {
    report(102, specs.where, "'signed' and 'unsigned' belong to fixed<...> only");
  }
  if (specs.output && !parameter) report(102, specs.where, "'output' belongs to parameters only");
}

std::vector<ast::ExpressionPtr> Parser::dimensions(std::size_t already) {
  std::vector<ast::ExpressionPtr> result;
  while (at("[")) {
    const Location where = take().where;
    if (result.size() + already == 2) report(102, where, "an array has at most two dimensions");
    ast::ExpressionPtr size = conditional();
    expect("]");
    if (result.size() + already < 2) result.push_back(std::move(size));
  }
  return result;
}

ast::Declarator Parser::declarator(const ast::SpecifiersPtr& specs) {
  ast::Declarator result;
  result.where = now().where;
  result.name = expect_name();
  result.specifiers = specs;
  result.dimensions = dimensions(specs->dimensions.size());
  if (accept("=")) result.initial = conditional();
  return result;
}

}  // namespace pfman
