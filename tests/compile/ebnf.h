// A grammar as the manual writes it, and random sentences of it.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace pfman_tests {

class Grammar {
 public:
  /// `text`: rules `name = ... ;` of "terminals", names, concatenation by `,`, alternatives, [ ], { } and ( ). Throws
  /// std::runtime_error where it is none.
  explicit Grammar(const std::string& text);

  /// Names that no rule defines.
  std::vector<std::string> undefined() const;

  /// Tokens of a random sentence of the rule, names without a rule among them. Rules are nested to about `depth`, but
  /// as far as they have to be.
  std::vector<std::string> sentence(const std::string& rule, int depth, std::mt19937_64& random) const;

 private:
  struct Part {
    enum class Kind : std::uint8_t { Terminal, Name, Sequence, Choice, Option, Repetition };
    Kind kind = Kind::Sequence;
    std::string text;
    std::vector<Part> parts;
  };

  Part choice();
  Part sequence();
  Part primary();
  void skip_blanks();
  bool accept(char c);
  std::string word();

  int least_depth(const Part& part) const;
  void generate(const Part& part, int depth, std::mt19937_64& random, std::vector<std::string>& out) const;

  std::string text_;
  std::size_t at_ = 0;
  std::map<std::string, Part> rules_;
  std::map<std::string, int> depths_;  ///< of the shallowest sentence
};

}  // namespace pfman_tests
