// What the manual says and what the program does are the same: the grammar, the keywords, the examples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

#include "tests/compile/ebnf.h"
#include "tests/compile/language.h"
#include "tests/pixelflow_model/seed.h"

namespace {

using pfman_tests::Grammar;

std::string manual() {
  std::ifstream stream(PFMAN_MANUAL, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << PFMAN_MANUAL;
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The text between the fences of the blocks that `opening` begins.
std::vector<std::string> blocks(const std::string& opening) {
  const std::string text = manual();
  std::vector<std::string> found;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    found.push_back(text.substr(at, text.find("\n```", at) - at + 1));
  }
  return found;
}

/// A sentence as text; what the grammar leaves to the words of the manual is made up here.
std::string spelled(const std::vector<std::string>& tokens, std::mt19937_64& random) {
  const auto pick = [&](std::initializer_list<const char*> words) {
    return std::string(words.begin()[random() % words.size()]);
  };
  std::string text;
  for (const std::string& token : tokens) {
    if (token == "name") {
      text += pick({"a", "b_2", "px_shader_color", "lightness", "_x"});
    } else if (token == "number") {
      text += pick({"0", "17", "0xFf", "1.", ".5", "2e-3", "1.5f", "3E+2f"});
    } else if (token == "string") {
      text += "\"c_name\"";
    } else {
      text += token;
    }
    text += random() % 5 == 0 ? "\n" : " ";
  }
  return text;
}

/// The manual's grammar. A statement cannot begin with an array literal, which the manual says in words: expressions
/// that are statements get a narrower rule here.
Grammar manual_grammar() {
  std::string text = blocks("```ebnf\n").at(0);
  const std::string general = "| expression , \";\"\n";
  const std::size_t at = text.find(general);
  if (at == std::string::npos) throw std::runtime_error("no expression statement in the manual's grammar");
  text.replace(at, general.size(), "| effect , \";\"\n");
  text += R"ebnf(
effect = variable , assignment , expression | variable , ( "++" | "--" ) | cast , { "+" , product }
       | ( "-" | "+" | "!" | "~" ) , unary | name , "(" , [ conditional ] , ")"
       | "(" , expression , ")" , [ "?" , expression , ":" , conditional ] ;
)ebnf";
  return Grammar(text);
}

TEST(language_manual, sentences_of_the_grammar_are_read) {
  const Grammar grammar = manual_grammar();
  EXPECT_THAT(grammar.undefined(), testing::ElementsAre("name", "number", "string"));
  const std::uint64_t seed = pixelflow_tests::seed_or(1);
  std::mt19937_64 random(seed);
  int tokens = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto sentence = grammar.sentence(n % 2 == 0 ? "definition" : "unit", 25 + n % 20, random);
    tokens += static_cast<int>(sentence.size());
    const std::string text = spelled(sentence, random);
    // Contradicting specifiers, three dimensions and the like are not the grammar's; the parser says so in other words.
    ASSERT_THAT(pfman_tests::parse(text).messages, testing::Not(testing::HasSubstr("unexpected")))
        << text << "\n"
        << pixelflow_tests::replay(seed);
  }
  EXPECT_GT(tokens, 100'000);
}

TEST(language_manual, sentences_with_a_token_too_many_are_refused) {
  const Grammar grammar = manual_grammar();
  const std::uint64_t seed = pixelflow_tests::seed_or(2);
  std::mt19937_64 random(seed);
  for (int n = 0; n < 1000; ++n) {
    auto sentence = grammar.sentence("definition", 25, random);
    // No place takes one of these.
    const char* const strange[] = {"surface", "]", "? ;", ": :", "= =", "( ]", "extern extern"};
    const std::size_t at = random() % sentence.size();
    sentence.insert(sentence.begin() + static_cast<std::ptrdiff_t>(at), strange[random() % std::size(strange)]);
    const std::string text = spelled(sentence, random);
    ASSERT_NE(pfman_tests::parse(text).messages, "") << text << "\n" << pixelflow_tests::replay(seed);
  }
}

TEST(language_manual, keywords_and_reserved_words_are_those_listed) {
  const std::string text = manual();
  const auto words = [&](const std::string& behind) {
    const std::size_t begin = text.find('`', text.find(behind)) + 1;
    std::istringstream stream(text.substr(begin, text.find('`', begin) - begin));
    return std::vector<std::string>(std::istream_iterator<std::string>(stream), {});
  };
  const auto keywords = words("Keywords: ");
  ASSERT_EQ(keywords.size(), 33u);
  for (const std::string& word : keywords) {
    EXPECT_EQ(pfman_tests::parse("surface " + word + "() {}").messages,
              "t:1:9: error: unexpected '" + word + "', expected a name [E102]\n");
  }
  const auto reserved = words("with a clear message:");
  ASSERT_EQ(reserved.size(), 14u);
  for (const std::string& word : reserved) {
    EXPECT_THAT(pfman_tests::parse("surface " + word + "() {}").messages, testing::HasSubstr("[E103]")) << word;
  }
}

TEST(language_manual, examples_are_read) {
  const auto examples = blocks("```pfman\n");
  ASSERT_FALSE(examples.empty());
  for (const std::string& example : examples) EXPECT_EQ(pfman_tests::parse(example).messages, "") << example;
}

}  // namespace
