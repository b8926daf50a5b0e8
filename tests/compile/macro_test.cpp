#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pixelflow/language/preprocessor.h"
#include "tests/compile/language.h"

namespace {

using pfman_tests::messages;
using pfman_tests::preprocess;
using pfman_tests::tokens;
using testing::HasSubstr;

TEST(language_macros, object_like) {
  EXPECT_EQ(tokens("#define N 3\n#define M N + N\nM N;"), "3 + 3 3 ;");
  EXPECT_EQ(tokens("#define P (x)\nP"), "( x )");
  EXPECT_EQ(tokens("#define float int\nfloat"), "int");
}

TEST(language_macros, function_like) {
  EXPECT_EQ(tokens("#define sq(x) ((x)*(x))\nsq(a+1) sq (2)"), "( ( a + 1 ) * ( a + 1 ) ) ( ( 2 ) * ( 2 ) )");
  EXPECT_EQ(tokens("#define f(a, b) b a\nf((1,2), g(3,4)) f(,) f(5,)"), "g ( 3 , 4 ) ( 1 , 2 ) 5");
  EXPECT_EQ(tokens("#define f() x\nf() f( ) f"), "x x f");
}

TEST(language_macros, calls_span_lines) {
  EXPECT_EQ(tokens("#define f(a, b) a-b\nf\n(\n1\n,\n2)"), "1 - 2");
  EXPECT_EQ(tokens("#define f(a) <a>\nf(1\n#define g 2\ng)"), "< 1 2 >");
}

TEST(language_macros, name_without_call_stays) {
  EXPECT_EQ(tokens("#define f(a) <a>\nf + f (1) f"), "f + < 1 > f");
  EXPECT_EQ(tokens("#define f(a) <a>\n#define g f\ng(1) g"), "< 1 > f");
}

TEST(language_macros, no_macro_expands_within_itself) {
  EXPECT_EQ(tokens("#define a a + b\n#define b a\na b"), "a + a a + b");
  EXPECT_EQ(tokens("#define f(x) x f\nf(1)(2)(3)"), "1 f ( 2 ) ( 3 )");
  EXPECT_EQ(tokens("#define f(x) x + f(x)\nf(f(1))"), "1 + f ( 1 ) + f ( 1 + f ( 1 ) )");
  EXPECT_EQ(tokens("#define g f(g)\n#define f(x) [x]\ng"), "[ g ]");
}

TEST(language_macros, result_is_scanned_with_what_follows) {
  EXPECT_EQ(tokens("#define f(x) [x]\n#define start f(\nstart 1)"), "[ 1 ]");
  EXPECT_EQ(tokens("#define pick(n) take##n\n#define take1(x) one x\npick(1)(2)"), "one 2");
}

TEST(language_macros, arguments_expand_first_but_not_beside_hashes) {
  const std::string text =
      "#define N 7\n#define s(x) #x\n#define t(x) s(x)\n#define j(a, b) a##b\n#define k(a, b) j(a, b)\n";
  EXPECT_EQ(tokens(text + "s(N) t(N) j(N, N) k(N, N)"), "\"N\" \"7\" NN 77");
}

TEST(language_macros, strings_of_arguments) {
  EXPECT_EQ(tokens("#define s(x) #x\ns( a  +\n b ) s() s(\"q\\\\\")"), R"("a + b" "" "\"q\\\\\"")");
}

TEST(language_macros, pasting) {
  EXPECT_EQ(tokens("#define j(a, b) <a##b>\nj(x, 1) j(, y) j(x,) j(,) j(<, <=) j(p q, r s)"),
            "< x1 > < y > < x > < > < <<= > < p qr s >");
  EXPECT_EQ(tokens("#define j3(a, b, c) a##b##c\nj3(x,,z) j3(,,z) j3(1,e,5)"), "xz z 1e5");
  EXPECT_EQ(tokens("#define o left ## right\no"), "leftright");
  EXPECT_EQ(tokens("#define hash # x\nhash"), "# x");
  EXPECT_EQ(messages("#define j(a, b) a##b\nj(x, +)"), "t:2:1: error: '##' makes no token of 'x' and '+' [E100]\n");
  EXPECT_EQ(messages("#define j(a, b) a##b\nj(/, /) j(/, *)"),
            "t:2:1: error: '##' makes no token of '/' and '/' [E100]\n"
            "t:2:9: error: '##' makes no token of '/' and '*' [E100]\n");
}

TEST(language_macros, wrong_definitions) {
  EXPECT_EQ(messages("#define"), "t:1:2: error: #define without the name of a macro [E100]\n");
  EXPECT_EQ(messages("#define 1"), "t:1:9: error: #define without the name of a macro [E100]\n");
  EXPECT_EQ(messages("#define f(a"), "t:1:11: error: macro 'f' has a malformed list of parameters [E100]\n");
  EXPECT_EQ(messages("#define f(a,) a"), "t:1:13: error: macro 'f' has a malformed list of parameters [E100]\n");
  EXPECT_EQ(messages("#define f(a, a) a"), "t:1:14: error: macro 'f' has two parameters 'a' [E100]\n");
  EXPECT_EQ(messages("#define f(a) #b"), "t:1:14: error: '#' in macro 'f' stands before no parameter [E100]\n");
  EXPECT_EQ(messages("#define a ## b"), "t:1:11: error: '##' at an end of macro 'a' [E100]\n");
  EXPECT_EQ(messages("#define defined 1"), "t:1:9: error: 'defined' cannot be defined [E100]\n");
}

TEST(language_macros, same_definition_twice_is_none_else_an_error) {
  EXPECT_EQ(messages("#define a 1 +  2\n#define a 1  + 2 // same\n"), "");
  EXPECT_EQ(messages("#define a 1\n#define a 2\n"),
            "t:2:9: error: macro 'a' is already defined differently [E100]\nt:1:9: note: the first definition\n");
  EXPECT_EQ(tokens("#define a 1\n#undef a\n#define a 2\na"), "2");
}

TEST(language_macros, wrong_calls) {
  EXPECT_EQ(messages("#define f(a, b) a\nf(1)"), "t:2:1: error: macro 'f' takes 2 arguments, not 1 [E100]\n");
  EXPECT_EQ(messages("#define f() a\nf(1)"), "t:2:1: error: macro 'f' takes 0 arguments, not 1 [E100]\n");
  EXPECT_EQ(messages("#define f(a) a\nf(1"), "t:2:1: error: macro 'f' is used without a closing ')' [E100]\n");
}

TEST(language_macros, growth_is_bounded) {
  std::string doubling = "#define a0 x x\n";
  std::string names = "#define j(a, b) a##b\n#define k(a, b) j(a, b)\n#define b0 long_enough_a_name\n";
  std::string calls = "#define f0(x) x x\n";
  for (int i = 1; i < 60; ++i) {
    const std::string now = std::to_string(i);
    const std::string before = std::to_string(i - 1);
    doubling += "#define a" + now + " a" + before + " a" + before + "\n";
    names += "#define b" + now + " k(b" + before + ", b" + before + ")\n";
    calls += "#define f" + now + "(x) f" + before + "(f" + before + "(x))\n";
  }
  EXPECT_THAT(messages(doubling + "a59"), HasSubstr("macro expansion grows beyond bounds [E100]"));
  EXPECT_THAT(messages(names + "b59"), HasSubstr("[E100]"));
  EXPECT_THAT(messages(calls + "f59(1)"), HasSubstr("macro expansion grows beyond bounds [E100]"));
  EXPECT_THAT(messages(doubling + "#if a59\n#endif\nend"), HasSubstr("macro expansion grows beyond bounds [E100]"));
}

TEST(language_macros, nested_calls_are_bounded) {
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "f(";
  deep += "1" + std::string(1000, ')');
  EXPECT_THAT(messages("#define f(x) x\n" + deep), HasSubstr("macro calls nested deeper than 200 [E100]"));
}

TEST(language_macros, tokens_stand_where_the_macro_is_used_arguments_where_they_stand) {
  pfman::Diagnostics diagnostics;
  const auto result = pfman::preprocess("#define in(x) (x 1)\n#define f(x) in(x) +\n  f(\n a)", "t", {}, diagnostics);
  std::string places;
  for (const auto& token : result.tokens) places += token.text + "@" + diagnostics.place(token.where) + " ";
  EXPECT_EQ(places, "(@t:3:3 a@t:4:2 1@t:3:3 )@t:3:3 +@t:3:3 @t:4:4 ");
}

}  // namespace
