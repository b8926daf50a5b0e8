#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/compile/language.h"

namespace {

using testing::HasSubstr;

std::string messages(const std::string& text) { return pfman_tests::parse(text).messages; }

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(language_errors, reading_goes_on_at_the_next_statement) {
  EXPECT_EQ(messages("void f() {\n  a = ;\n  b = 1;\n  c + ;\n}\nvoid g() {\n  ) ;\n}\n"),
            "t:2:7: error: unexpected ';', expected an expression [E102]\n"
            "t:4:7: error: unexpected ';', expected an expression [E102]\n"
            "t:7:3: error: unexpected ')', expected an expression [E102]\n");
}

TEST(language_errors, a_missing_semicolon_costs_no_statement) {
  EXPECT_EQ(messages("void f() {\n  float x = 1\n  float y = ;\n  a = b\n  if (c ;\n}\n"),
            "t:3:3: error: unexpected 'float', expected ';' [E102]\n"
            "t:3:13: error: unexpected ';', expected an expression [E102]\n"
            "t:5:3: error: unexpected 'if', expected ';' [E102]\n"
            "t:5:9: error: unexpected ';', expected ')' [E102]\n");
}

TEST(language_errors, an_array_with_a_mistake_ends_at_its_brace) {
  EXPECT_EQ(messages("void f() {\n  float m[2][2] = { { 1, 2 3 }, { 4 } };\n  x = ;\n}\n"),
            "t:2:28: error: unexpected '3', expected '}' [E102]\n"
            "t:3:7: error: unexpected ';', expected an expression [E102]\n");
}

TEST(language_errors, a_body_is_read_behind_wrong_parameters) {
  EXPECT_EQ(messages("surface s(uniform x, float a[3] = {1, 2) {\n  y = ;\n}\n"),
            "t:1:19: error: unexpected 'x', expected a type [E102]\n"
            "t:2:7: error: unexpected ';', expected an expression [E102]\n");
}

TEST(language_errors, a_missing_brace_is_shown_where_it_opened) {
  EXPECT_EQ(messages("void f() {\n  if (a) {\n"),
            "t:3:1: error: unexpected end of the text, expected '}' [E102]\nt:2:10: note: the '{' is here\n");
  EXPECT_EQ(messages("void f() {\n  { a = 1;\nsurface s() { b = ; }\n"),
            "t:3:1: error: unexpected 'surface', expected '}' [E102]\n"
            "t:3:19: error: unexpected ';', expected an expression [E102]\n");
}

TEST(language_errors, a_stray_brace_costs_no_definition) {
  EXPECT_EQ(messages("void f() { } }\nvoid g() { a = ; }\n"),
            "t:1:14: error: unexpected '}', expected a surface, light, function or constant [E102]\n"
            "t:2:16: error: unexpected ';', expected an expression [E102]\n");
}

TEST(language_errors, words_of_rendermans_language) {
  EXPECT_EQ(messages("displacement d() { x = 1; }\nvoid f() { color c = 1; a = normal; }\n"),
            "t:1:1: error: 'displacement' is a word of RenderMan's language that pfman reserves [E103]\n"
            "t:2:12: error: 'color' is a word of RenderMan's language that pfman reserves [E103]\n"
            "t:2:29: error: 'normal' is a word of RenderMan's language that pfman reserves [E103]\n");
}

TEST(language_errors, specifiers_that_contradict) {
  EXPECT_EQ(messages("void f() {\n  uniform uniform int a;\n  varying uniform float b;\n  signed int c;\n"
                     "  float int d;\n  output float e;\n  uniform g;\n}\noutput float h() { }\n"),
            "t:2:11: error: 'uniform' stands twice [E102]\n"
            "t:3:11: error: 'uniform' contradicts what stands before it [E102]\n"
            "t:4:3: error: 'signed' and 'unsigned' belong to fixed<...> only [E102]\n"
            "t:5:9: error: 'int' is a second type [E102]\n"
            "t:6:3: error: 'output' belongs to parameters only [E102]\n"
            "t:7:11: error: unexpected 'g', expected a type [E102]\n"
            "t:9:1: error: 'output' belongs to parameters only [E102]\n");
  EXPECT_EQ(messages("surface s(transform_as_point transform_as_texture float p[3]) { }"),
            "t:1:30: error: two transform attributes [E221]\n");
}

TEST(language_errors, only_variables_are_assigned) {
  EXPECT_EQ(messages("void f() { a + b = c; 1++; g(x)[1] = 2; (a)[1] = 3; float(a) = 1; }"),
            "t:1:18: error: only a variable or an element of one can be assigned [E102]\n"
            "t:1:24: error: only a variable or an element of one can be assigned [E102]\n"
            "t:1:36: error: only a variable or an element of one can be assigned [E102]\n"
            "t:1:62: error: only a variable or an element of one can be assigned [E102]\n");
}

TEST(language_errors, constants_need_values) {
  EXPECT_EQ(messages("const int n;"), "t:1:12: error: unexpected ';', expected '=' [E102]\n");
}

TEST(language_errors, three_dimensions) {
  EXPECT_EQ(messages("void f() { float a[1][2][3]; float[2] b[1][2]; }"),
            "t:1:25: error: an array has at most two dimensions [E102]\n"
            "t:1:43: error: an array has at most two dimensions [E102]\n");
}

TEST(language_errors, numbers) {
  EXPECT_EQ(messages("void f() {\n  a = 010;\n  a = 9223372036854775808;\n  a = 0x8000000000000000;\n  a = 0x;\n"
                     "  a = 1e400;\n  a = 1.2.3;\n  a = 12f;\n  a = 0xfg;\n  a = 1e;\n}\n"),
            "t:2:7: error: number '010' begins with 0, but there are no octal numbers [E101]\n"
            "t:3:7: error: number '9223372036854775808' is too large, the largest is 9223372036854775807 [E101]\n"
            "t:4:7: error: number '0x8000000000000000' is too large, the largest is 9223372036854775807 [E101]\n"
            "t:5:7: error: number '0x' is malformed [E101]\n"
            "t:6:7: error: number '1e400' is too large [E101]\n"
            "t:7:7: error: number '1.2.3' is malformed [E101]\n"
            "t:8:7: error: number '12f' is malformed [E101]\n"
            "t:9:7: error: number '0xfg' is malformed [E101]\n"
            "t:10:7: error: number '1e' is malformed [E101]\n");
}

TEST(language_errors, characters_of_no_token) {
  EXPECT_EQ(messages("void f() {\n  a = @ \xC3\xA9 1;\n  b = 'c';\n  d = \x01 2;\n  \"open\n}\n"),
            "t:2:7: error: bad character '@' [E101]\nt:2:9: error: bad character '\xC3\xA9' [E101]\n"
            "t:3:7: error: bad character ''' [E101]\nt:3:9: error: bad character ''' [E101]\n"
            "t:4:7: error: bad character 0x01 [E101]\nt:5:3: error: string without a closing '\"' [E101]\n");
}

TEST(language_errors, nesting_is_bounded) {
  const char* const kDeep = "nested deeper than 256 levels [E102]";
  const char* const kHigh = "expression of more than 256 levels [E102]";
  for (const char* opening : {"(", "f(", "{", "- ", "a[", "float(", "fixed<8, (", "1 ? ", "a = ", "1 ? 2 : "}) {
    EXPECT_THAT(messages("void f() { x = " + repeated(opening, 100000)), HasSubstr(kDeep)) << opening;
  }
  for (const char* chain : {"+ 1", "* 1", "[1]", "< 1 + 2", "&& a"}) {
    EXPECT_THAT(messages("void f() { x = a " + repeated(chain, 100000) + ";}"), HasSubstr(kHigh)) << chain;
  }
  for (const char* opening : {"{", "if (a) ", "while (a) ", "do ", "for (;;) ", "if (a) ; else ", "solar () "}) {
    EXPECT_THAT(messages("void f() { " + repeated(opening, 100000)), HasSubstr(kDeep)) << opening;
  }
}

TEST(language_errors, many_mistakes_end_the_text) {
  const std::string all = messages("void f() {\n" + repeated("a = ;\n", 1000) + "}");
  EXPECT_THAT(all, HasSubstr("t:52:5: error: more than 50 mistakes; the rest is not read [E102]"));
  EXPECT_THAT(all, testing::Not(HasSubstr("t:60:")));
}

TEST(language_errors, every_text_cut_short_is_refused) {
  const std::string text =
      "surface s(output varying fixed<8,8> px_shader_color[3], uniform float w = 0.25)\n"
      "{\n  float c[3] = { w, 1 - w, sat fixed<8,8>(w) };\n  uniform int i;\n"
      "  for (i = 0; i < 3; i++) { if (c[i] > 0.5) c[i] *= w ? 2 : 3; else break; }\n"
      "  do i--; while (i > 0);\n  illuminance () c += px_light_color;\n  px_shader_color = c;\n}";
  EXPECT_EQ(messages(text), "");
  for (std::size_t length = 1; length < text.size(); ++length) {
    EXPECT_THAT(messages(text.substr(0, length)), HasSubstr("[E10")) << length;
  }
}

}  // namespace
