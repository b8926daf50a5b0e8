#include "pixelflow/language/preprocessor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "tests/compile/language.h"

namespace {

using pfman_tests::messages;
using pfman_tests::preprocess;
using pfman_tests::tokens;
using testing::HasSubstr;

/// A folder of files that lives as long as the test.
class Folder {
 public:
  Folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count();
    path_ =
        std::filesystem::temp_directory_path() / (std::string("pfman_") + test->name() + "_" + std::to_string(stamp));
    std::filesystem::create_directories(path_ / "inner");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string name(const std::string& file) const { return (path_ / file).generic_string(); }

 private:
  std::filesystem::path path_;
};

TEST(language_lexer, splices_join_lines_anywhere) {
  EXPECT_EQ(tokens("fl\\\noat \\\r\n x <\\\n<\\\n= 1\\\n2;"), "float x <<= 12 ;");
  EXPECT_EQ(tokens("// comment \\\n still one\nx"), "x");
}

TEST(language_lexer, line_ends_and_comments_are_white_space) {
  EXPECT_EQ(tokens("a/* b */c\r\n/**/d//e\r\nf/*/g*/h"), "a c d f h");
}

TEST(language_lexer, numbers_take_signs_behind_exponents_only) {
  EXPECT_EQ(tokens("1e+5 0xe+5 1.5e-3f .5 1+2"), "1e+5 0xe + 5 1.5e-3f .5 1 + 2");
}

TEST(language_lexer, longest_operator_wins) { EXPECT_EQ(tokens("a+++b>>=c<<d<=-e"), "a ++ + b >>= c << d <= - e"); }

TEST(language_lexer, strings_keep_escaped_quotes) { EXPECT_EQ(tokens(R"("a\"b" "\\" c)"), R"("a\"b" "\\" c)"); }

TEST(language_lexer, comment_without_end_is_reported_at_its_beginning) {
  EXPECT_EQ(messages("a\n  /* b\nc"), "t:2:3: error: comment without an end [E101]\n");
}

TEST(language_preprocessor, conditions_choose_one_part) {
  const std::string text = "#if A == 1\none\n#elif A == 2\ntwo\n#elif A == 2 || 1 / 0\nnever\n#else\nother\n#endif\n";
  EXPECT_EQ(tokens("#define A 1\n" + text), "one");
  EXPECT_EQ(tokens("#define A 2\n" + text), "two");
  EXPECT_THAT(messages("#define A 3\n" + text), HasSubstr("t:6:21: error: division by zero in a condition [E100]"));
}

TEST(language_preprocessor, parts_left_out_are_hardly_read) {
  EXPECT_EQ(tokens("#if 0\n@ \"open\n#nonsense\n#if junk junk\n#else more\n#endif rest\n#error no\n#endif\nx"), "x");
}

TEST(language_preprocessor, ifdef_and_defined) {
  EXPECT_EQ(tokens("#define A\n#ifdef A\n1\n#endif\n#ifndef A\n2\n#endif\n#if defined A && !defined(B)\n3\n#endif"),
            "1 3");
  EXPECT_EQ(tokens("#define A\n#undef A\n#undef B\n#ifdef A\n1\n#else\n2\n#endif"), "2");
}

TEST(language_preprocessor, condition_arithmetic_is_c_of_64_bits) {
  for (const char* truth : {"1 + 2 * 3 == 7",
                            "(1 + 2) * 3 == 9",
                            "-7 / 2 == -3",
                            "-7 % 2 == -1",
                            "1 << 62 >> 61 == 2",
                            "-1 >> 1 == -1",
                            "0x10 == 16",
                            "~0 == -1",
                            "!0 && !!5",
                            "5 & 3 ^ 2 | 8",
                            "1 ? 2 : 1 / 0",
                            "0 && 1 / 0 || 1",
                            "1 || 1 / 0",
                            "name == 0",
                            "true && !false",
                            "2 > 1 == 1 <= 1",
                            "1 != 2 && 3 >= 3 && 1 < 2",
                            "9223372036854775807 + 1 < 0",
                            "(-9223372036854775807 - 1) / -1 < 0",
                            "(-9223372036854775807 - 1) % -1 == 0",
                            "0 ? 0 : 0 ? 0 : 1",
                            "+3 - -3 == 6"}) {
    EXPECT_EQ(tokens(std::string("#if ") + truth + "\nyes\n#endif"), "yes") << truth;
    EXPECT_EQ(tokens(std::string("#if !(") + truth + ")\nyes\n#endif"), "") << truth;
  }
}

TEST(language_preprocessor, bad_conditions_are_reported_and_false) {
  const auto message = [](const std::string& condition) {
    const auto result = preprocess("#if " + condition + "\nx\n#endif");
    EXPECT_EQ(result.text, "") << condition;
    return result.messages;
  };
  EXPECT_EQ(message(""), "t:1:2: error: a condition lacks an operand [E100]\n");
  EXPECT_EQ(message("1 +"), "t:1:7: error: a condition lacks an operand [E100]\n");
  EXPECT_EQ(message("(1"), "t:1:6: error: expected ')' in a condition [E100]\n");
  EXPECT_EQ(message("1 2"), "t:1:7: error: unexpected '2' in a condition [E100]\n");
  EXPECT_EQ(message("1.5"), "t:1:5: error: '1.5' is no integer of a condition [E100]\n");
  EXPECT_EQ(message("1 << 64"), "t:1:10: error: shift by 64 in a condition [E100]\n");
  EXPECT_EQ(message("defined 3"), "t:1:5: error: 'defined' without a name [E100]\n");
  EXPECT_EQ(message("9223372036854775808"),
            "t:1:5: error: '9223372036854775808' is no integer of a condition [E100]\n");
}

TEST(language_preprocessor, unbalanced_conditions_are_reported) {
  EXPECT_EQ(messages("#endif"), "t:1:2: error: #endif without #if [E100]\n");
  EXPECT_EQ(messages("x\n#if 1\n#else\n#elif 1\n#endif"),
            "t:4:2: error: #elif behind #else [E100]\nt:2:2: note: the #if is here\n");
  EXPECT_EQ(messages("#if 1\n#ifdef X"),
            "t:1:2: error: condition without #endif [E100]\nt:2:2: error: condition without #endif [E100]\n");
  EXPECT_EQ(messages("#if 1\n#endif X"), "t:2:8: error: unexpected 'X' behind #endif [E100]\n");
}

TEST(language_preprocessor, directives_that_are_wrong) {
  EXPECT_EQ(messages(" # foo"), "t:1:2: error: unknown directive '#foo' [E100]\n");
  EXPECT_EQ(messages("#error don't  use \"this\""), "t:1:1: error: #error don't use \"this\" [E100]\n");
  EXPECT_EQ(messages("#error"), "t:1:1: error: #error [E100]\n");
  EXPECT_EQ(messages("#include foo"), "t:1:10: error: #include without a file name in quotes [E100]\n");
  EXPECT_EQ(messages("#include \"none.h\""), "t:1:10: error: cannot find \"none.h\" [E100]\n");
  EXPECT_EQ(messages("#line x"), "t:1:7: error: #line without a line number [E100]\n");
  EXPECT_EQ(messages("#line 0"), "t:1:7: error: #line without a line number [E100]\n");
  EXPECT_EQ(messages("#undef"), "t:1:2: error: #undef without the name of a macro [E100]\n");
  EXPECT_EQ(messages("#\n#pragma anything goes\n"), "");
}

TEST(language_preprocessor, line_moves_places_and_names) {
  EXPECT_EQ(messages("#line 70 \"other\"\n\n#error a\n#line 5\n#error b"),
            "other:5:1: error: #error b [E100]\nother:71:1: error: #error a [E100]\n");
  EXPECT_EQ(tokens("__LINE__\n#line 41\n__LINE__ __FILE__\n__LINE__"), "1 41 \"t\" 42");
}

TEST(language_preprocessor, pragmas_of_the_language_are_handed_on) {
  pfman::Diagnostics diagnostics;
  const auto result = pfman::preprocess("#pragma pfman  shared_phong \n#pragma once\n#if 0\n#pragma pfman no\n#endif\n",
                                        "t", {}, diagnostics);
  ASSERT_EQ(result.pragmas.size(), 1u);
  EXPECT_EQ(result.pragmas[0].text, "shared_phong");
  EXPECT_EQ(diagnostics.place(result.pragmas[0].where), "t:1:9");
}

TEST(language_preprocessor, macros_from_outside) {
  pfman::ParseOptions options;
  options.macros = {{"A", "b + 1"}, {"B", ""}};
  EXPECT_EQ(preprocess("A B __PFMAN__", options).text, "b + 1 1");
  options.macros = {{"no name", "1"}};
  EXPECT_EQ(preprocess("x", options).messages, "command line: error: 'no name' cannot name a macro [E100]\n");
}

TEST(language_preprocessor, includes_are_found_beside_the_file_then_in_folders) {
  const Folder folder;
  folder.write("inner/a.h", "in_inner");
  folder.write("a.h", "in_folder");
  folder.write("inner/b.h", "#include \"a.h\"\n");
  pfman::ParseOptions options;
  const std::string text = "#define NAME \"a.h\"\n#include NAME\n#include \"b.h\"\n";
  EXPECT_EQ(preprocess(text, {}, folder.name("main")).text, "in_folder");
  options.include_folders = {folder.name("inner")};
  EXPECT_EQ(preprocess(text, options, folder.name("main")).text, "in_folder in_inner");
  EXPECT_EQ(preprocess(text, options, "main").text, "in_inner in_inner");
}

TEST(language_preprocessor, messages_name_the_included_file) {
  const Folder folder;
  folder.write("a.h", "\n#error here\n#if 1\n");
  EXPECT_EQ(preprocess("#include \"a.h\"\n#else\n", {}, folder.name("main")).messages,
            folder.name("main") + ":2:2: error: #else without #if [E100]\n" + folder.name("a.h") +
                ":2:1: error: #error here [E100]\n" + folder.name("a.h") +
                ":3:2: error: condition without #endif [E100]\n");
}

TEST(language_preprocessor, a_file_that_includes_itself_ends) {
  const Folder folder;
  folder.write("a.h", "x\n#include \"a.h\"\n");
  EXPECT_THAT(preprocess("#include \"a.h\"", {}, folder.name("main")).messages,
              HasSubstr("a.h:2:10: error: files included deeper than 64, does one include itself? [E100]"));
  folder.write("guard.h", "#ifndef G\n#define G\n#include \"guard.h\"\nonce\n#endif\n");
  const auto guarded = preprocess("#include \"guard.h\"\n#include \"guard.h\"", {}, folder.name("main"));
  EXPECT_EQ(guarded.text + guarded.messages, "once");
}

TEST(language_preprocessor, files_that_double_end) {
  const Folder folder;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "#include \"" + std::to_string(i + 1) + "\"\n";
    folder.write(std::to_string(i), next + next);
  }
  folder.write("40", "");
  EXPECT_THAT(preprocess("#include \"0\"", {}, folder.name("main")).messages, HasSubstr("bytes of text [E100]"));
}

TEST(language_preprocessor, only_regular_files_are_read) {
  const Folder folder;
  EXPECT_THAT(preprocess("#include \"inner\"", {}, folder.name("main")).messages, HasSubstr("cannot find \"inner\""));
  pfman::Diagnostics diagnostics;
  pfman::parse_file(folder.name("none"), {}, diagnostics);
  EXPECT_EQ(diagnostics.text(), folder.name("none") + ": error: cannot read \"" + folder.name("none") + "\" [E100]\n");
}

TEST(language_preprocessor, many_mistakes_end_the_text) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "#foo\n";
  EXPECT_THAT(messages(text), HasSubstr("t:51:1: error: more than 50 mistakes; the rest is not read [E100]"));
  EXPECT_THAT(messages(text), testing::Not(HasSubstr("t:60:")));
}

}  // namespace
