#include <gtest/gtest.h>

#include <string>

#include "tests/compile/language.h"

namespace {

std::string tree(const std::string& text) {
  const auto result = pfman_tests::parse(text);
  EXPECT_EQ(result.messages, "") << text;
  return result.text;
}

/// The tree of statements alone.
std::string statement(const std::string& text) {
  const std::string head = "function f\n  result void\n  block\n";
  const std::string whole = tree("void f() { " + text + " }");
  EXPECT_EQ(whole.substr(0, head.size()), head);
  return whole.substr(head.size());
}

/// An expression in one line: (operator operand operand).
std::string shape(const pfman::ast::Expression& node) {
  using Kind = pfman::ast::Expression::Kind;
  std::string text;
  switch (node.kind) {
    case Kind::Name: return node.name;
    case Kind::Integer: return std::to_string(node.integer);
    case Kind::Unary:
    case Kind::Binary: text = spelling(node.op); break;
    case Kind::Assign: text = std::string(spelling(node.op)) + "="; break;
    case Kind::Conditional: text = "?"; break;
    case Kind::PostIncrement: text = "post++"; break;
    case Kind::PostDecrement: text = "post--"; break;
    case Kind::Call: text = node.name; break;
    case Kind::Index: text = "[]"; break;
    case Kind::Array: text = "{}"; break;
    case Kind::Cast: text = node.saturate ? "sat" : "cast"; break;
    default: text = "literal";
  }
  for (const auto& operand : node.operands) text += " " + shape(*operand);
  return "(" + text + ")";
}

std::string expression(const std::string& text) {
  pfman::Diagnostics diagnostics;
  const auto unit = pfman::parse_text("void f() { " + text + "; }", "t", {}, diagnostics);
  EXPECT_EQ(diagnostics.text(), "") << text;
  if (diagnostics.has_errors()) return "";
  return shape(*unit.definitions.at(0).body->body.at(0)->expressions.at(0));
}

TEST(language_parser, precedence_is_that_of_c) {
  EXPECT_EQ(expression("a || b && c | d ^ e & f == g < h << i + j * k"),
            "(|| a (&& b (| c (^ d (& e (== f (< g (<< h (+ i (* j k))))))))))");
  EXPECT_EQ(expression("a * b + c << d < e == f & g ^ h | i && j || k"),
            "(|| (&& (| (^ (& (== (< (<< (+ (* a b) c) d) e) f) g) h) i) j) k)");
}

TEST(language_parser, binary_operators_group_to_the_left) {
  for (const char* op :
       {"||", "&&", "|", "^", "&", "==", "!=", "<", "<=", ">", ">=", "<<", ">>", "+", "-", "*", "/", "%"}) {
    const std::string o = op;
    EXPECT_EQ(expression("a " + o + " b " + o + " c"), "(" + o + " (" + o + " a b) c)");
  }
  EXPECT_EQ(expression("a - (b - c)"), "(- a (- b c))");
}

TEST(language_parser, assignment_and_conditional_group_to_the_right) {
  EXPECT_EQ(expression("a = b += c"), "(= a (+= b c))");
  EXPECT_EQ(expression("a ? b : c ? d : e"), "(? a b (? c d e))");
  EXPECT_EQ(expression("a ? b ? c : d : e"), "(? a (? b c d) e)");
  EXPECT_EQ(expression("a ? b = c : d"), "(? a (= b c) d)");
  for (const char* op : {"=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "|=", "^="}) {
    EXPECT_EQ(expression(std::string("a ") + op + " b"), std::string("(") + op + " a b)");
  }
}

TEST(language_parser, unary_binds_stronger_than_binary_weaker_than_postfix) {
  EXPECT_EQ(expression("-a[1] * !b"), "(* (- ([] a 1)) (! b))");
  EXPECT_EQ(expression("- - + ~a"), "(- (- (+ (~ a))))");
  EXPECT_EQ(expression("a[1][b]++"), "(post++ ([] ([] a 1) b))");
  EXPECT_EQ(expression("f(a, g(), {b, {c}})"), "(f a (g) ({} b ({} c)))");
  EXPECT_EQ(expression("a-- - b"), "(- (post-- a) b)");
}

TEST(language_parser, casts_begin_statements_too) {
  EXPECT_EQ(expression("fixed<8, 8>(a) + b"), "(+ (cast a) b)");
  EXPECT_EQ(expression("float(a) * b < c ? d : e"), "(? (< (* (cast a) b) c) d e)");
  EXPECT_EQ(expression("sat signed fixed<8, -4 + 2>(a)"), "(sat a)");
}

TEST(language_parser, a_cast_keeps_its_type) {
  EXPECT_EQ(statement("x = sat unsigned fixed<8, n - 1>(y);"),
            "    expression\n      assign =\n        name x\n        cast sat\n          to unsigned fixed\n"
            "            size\n              integer 8\n            exponent\n              binary -\n"
            "                name n\n                integer 1\n          name y\n");
}

TEST(language_parser, specifiers_stand_in_any_order) {
  const std::string expected =
      "surface s\n  parameter p: output varying unit transform_as_vector signed fixed\n    size\n      integer 16\n"
      "    exponent\n      integer 8\n    dimension\n      integer 3\n  block\n";
  EXPECT_EQ(tree("surface s(output varying unit transform_as_vector signed fixed<16, 8> p[3]) {}"), expected);
  EXPECT_EQ(tree("surface s(fixed<16, 8> transform_as_vector signed unit varying output p[3]) {}"), expected);
}

TEST(language_parser, dimensions_stand_behind_type_or_name) {
  EXPECT_EQ(statement("float[3] a, b[2];"),
            "    declaration\n      variable a: float\n        type dimension\n          integer 3\n"
            "      variable b: float\n        type dimension\n          integer 3\n        dimension\n"
            "          integer 2\n");
}

TEST(language_parser, formals_repeat_types_and_take_either_separator) {
  const std::string expected =
      "light l\n  parameter a: uniform float\n    initial\n      integer 1\n  parameter b: uniform float\n"
      "    dimension\n      integer 2\n  parameter c: int\n  block\n";
  EXPECT_EQ(tree("light l(uniform float a = 1, b[2]; int c) {}"), expected);
  EXPECT_EQ(tree("light l(uniform float a = 1; b[2], int c;) {}"), expected);
}

TEST(language_parser, definitions_of_all_kinds) {
  EXPECT_EQ(
      tree("#pragma pfman shared_phong\nextern \"name\" varying float f(float x, output int y);\nextern void g();\n"
           "const uniform int n = 2, m = n;\nfloat[3] h() { return {1, 2, 3}; }\n"),
      "pragma shared_phong\nextern \"name\" f\n  result varying float\n  parameter x: float\n"
      "  parameter y: output int\nextern g\n  result void\nconst\n  constant n: uniform int\n    initial\n"
      "      integer 2\n  constant m: uniform int\n    initial\n      name n\nfunction h\n  result float\n"
      "    type dimension\n      integer 3\n  block\n    return\n      array\n        integer 1\n"
      "        integer 2\n        integer 3\n");
}

TEST(language_parser, else_belongs_to_the_nearest_if) {
  EXPECT_EQ(statement("if (a) if (b) ; else break;"),
            "    if\n      name a\n      if\n        name b\n        empty\n        break\n");
}

TEST(language_parser, loops) {
  EXPECT_EQ(statement("while (a) continue;"), "    while\n      name a\n      continue\n");
  EXPECT_EQ(statement("do { } while (a);"), "    do\n      block\n      name a\n");
  EXPECT_EQ(
      statement("for (i = 0; ; i++) ;"),
      "    for\n      assign =\n        name i\n        integer 0\n      nothing\n      increment\n        name i\n"
      "      empty\n");
}

TEST(language_parser, a_cast_begins_a_for) {
  EXPECT_EQ(statement("for (float(a); ;) ;"),
            "    for\n      cast\n        to float\n        name a\n      nothing\n      nothing\n      empty\n");
}

TEST(language_parser, light_statements_take_their_arguments) {
  EXPECT_EQ(statement("illuminance () ; illuminance (a) ; illuminance (a, b, c) ;"),
            "    illuminance\n      empty\n    illuminance\n      name a\n      empty\n    illuminance\n      name a\n"
            "      name b\n      name c\n      empty\n");
  EXPECT_EQ(statement("illuminate (a) ; illuminate (a, b, c) ; solar () ; solar (a, b) ;"),
            "    illuminate\n      name a\n      empty\n    illuminate\n      name a\n      name b\n      name c\n"
            "      empty\n    solar\n      empty\n    solar\n      name a\n      name b\n      empty\n");
}

TEST(language_parser, declarations_and_constants_stand_anywhere) {
  EXPECT_EQ(statement("; const int n = 1; uniform int i; return i;"),
            "    empty\n    const\n      variable n: int\n        initial\n          integer 1\n    declaration\n"
            "      variable i: uniform int\n    return\n      name i\n");
}

TEST(language_parser, literals) {
  EXPECT_EQ(statement("x = {0, 9223372036854775807, 0xFFff, 1., .5, 2e-3, 1.5e+2f, 1e-999, 4.9e-324, true, false};"),
            "    expression\n      assign =\n        name x\n        array\n          integer 0\n"
            "          integer 9223372036854775807\n          integer 65535\n          real 1\n          real 0.5\n"
            "          real 0.002\n          real 150 f\n          real 0\n          real 5e-324\n          true\n"
            "          false\n");
}

TEST(language_parser, places_are_those_of_operators_and_first_tokens) {
  pfman::Diagnostics diagnostics;
  const auto unit = pfman::parse_text("void f()\n{\n  a = -b[1] + g(2);\n}", "t", {}, diagnostics);
  const auto& statement = *unit.definitions.at(0).body->body.at(0);
  const auto& assign = *statement.expressions.at(0);
  const auto& sum = *assign.operands.at(1);
  EXPECT_EQ(diagnostics.place(unit.definitions.at(0).where), "t:1:6");
  EXPECT_EQ(diagnostics.place(statement.where), "t:3:3");
  EXPECT_EQ(diagnostics.place(assign.where), "t:3:5");
  EXPECT_EQ(diagnostics.place(sum.where), "t:3:13");
  EXPECT_EQ(diagnostics.place(sum.operands.at(0)->where), "t:3:7");
  EXPECT_EQ(diagnostics.place(sum.operands.at(0)->operands.at(0)->where), "t:3:8");
  EXPECT_EQ(diagnostics.place(sum.operands.at(1)->where), "t:3:15");
}

TEST(language_parser, nesting_up_to_the_limit_is_read) {
  const auto nested = [](int depth) {
    return "void f() { x = " + std::string(depth, '(') + "1" + std::string(depth, ')') + "; }";
  };
  EXPECT_EQ(pfman_tests::parse(nested(254)).messages, "");
  EXPECT_NE(pfman_tests::parse(nested(255)).messages, "");
}

}  // namespace
