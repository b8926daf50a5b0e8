// Macros of the preprocessor and their expansion.
//
// As in C: arguments are expanded before they are put in, except beside # and ##; the result is scanned again together
// with what follows; a macro's name inside its own expansion stays as it is. A token from a macro's body is located at
// the macro's use, an argument where it stands.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/language/token.h"

namespace pfman {

struct Macro {
  std::string name;
  Location where;
  bool function = false;
  std::vector<std::string> parameters;
  std::vector<Token> body;
  bool active = false;  ///< its expansion is being scanned
};

/// The macros defined now, and how much work their expansions have been.
class MacroTable {
 public:
  explicit MacroTable(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// `line` is what stands behind #define. Mistakes are E100.
  void define(const std::vector<Token>& line, Location directive);
  void undefine(const std::string& name) { macros_.erase(name); }
  std::shared_ptr<Macro> find(const std::string& name) const;

  Diagnostics& diagnostics() { return diagnostics_; }

  /// Charges an expansion for a token. False, and E100 once, when a unit's expansions grow beyond bounds.
  bool charge(const Token& token);
  bool exhausted() const { return exhausted_; }
  void exhaust(Location where, const std::string& text);

 private:
  bool check_body(const Macro& macro);

  Diagnostics& diagnostics_;
  std::map<std::string, std::shared_ptr<Macro>> macros_;
  std::size_t work_ = 0;
  bool exhausted_ = false;
};

/// A stream of tokens with its macros expanded.
class Expansion {
 public:
  /// `read` gives the next token of the text, and End for ever once it is at an end.
  Expansion(MacroTable& table, std::function<Token()> read, int depth = 0)
      : table_(table), read_(std::move(read)), depth_(depth) {}
  ~Expansion();
  Expansion(const Expansion&) = delete;
  Expansion& operator=(const Expansion&) = delete;

  Token next();

 private:
  struct Context {
    std::vector<Token> tokens;
    std::size_t next = 0;
    std::shared_ptr<Macro> macro;  ///< or null: tokens put back
  };
  using Tokens = std::vector<Token>;

  Token fetch();
  void put_back(Token token);
  bool enter(const std::shared_ptr<Macro>& macro, const Token& use);
  std::optional<std::vector<Tokens>> arguments(const Macro& macro, const Token& use);
  std::optional<Tokens> substitute(const Macro& macro, const std::vector<Tokens>& arguments, const Token& use);
  void paste(Tokens& result, const Token& right, const Token& use);

  MacroTable& table_;
  std::function<Token()> read_;
  int depth_;
  std::vector<Context> contexts_;
};

/// The tokens of a list, expanded by themselves; without End.
std::vector<Token> expand(const std::vector<Token>& tokens, MacroTable& table, int depth = 0);

}  // namespace pfman
