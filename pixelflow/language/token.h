// A token of the text, as the lexer makes it, the preprocessor hands it on and the parser reads it.
#pragma once

#include <string>

#include "pixelflow/language/diagnostics.h"

namespace pfman {

struct Token {
  enum class Kind : std::uint8_t {
    Identifier,
    Keyword,   ///< of the language; the lexer calls them Identifier, since a macro may bear such a name
    Reserved,  ///< a word of RenderMan's language that this one has not
    Number,    ///< as C's preprocessing number: anything that begins like one
    String,    ///< text without the quotes
    Punctuator,
    Bad,  ///< a character of no token, or a string that its line does not close; an error once it reaches the parser
    End,
  };

  Kind kind = Kind::End;
  bool line_start = false;  ///< the first of its line
  bool space = false;       ///< white space or a comment stands before it
  bool painted = false;     ///< the name of a macro met inside its own expansion: never expanded again
  std::string text;
  Location where;

  bool is(const char* spelling) const {
    return (kind == Kind::Punctuator || kind == Kind::Keyword) && text == spelling;
  }
  bool is_identifier(const char* name) const { return kind == Kind::Identifier && text == name; }
};

}  // namespace pfman
