// The directives of C's preprocessor: #include "file", #define with parameters, # and ##, #undef, #if #ifdef #ifndef
// #elif #else #endif, #line, #error, #pragma. Runs on tokens, so the parser reads what this hands on.
//
// No text makes it hang or fill memory: the depth of includes, all text read, the work of macro expansion and the
// number of mistakes reported are bounded; beyond a bound comes an E100 and the end of the text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "pixelflow/language/parser.h"
#include "pixelflow/language/token.h"

namespace pfman {

struct Preprocessed {
  std::vector<Token> tokens;         ///< the last one End
  std::vector<ast::Pragma> pragmas;  ///< those of this language
};

/// Reading stops with an error beyond this many mistakes.
constexpr int kMaximumMistakes = 50;

/// The text of a regular file; nothing and E100 at `where` when there is none.
std::optional<std::string> read_text(const std::filesystem::path& file, Location where, Diagnostics& diagnostics);

Preprocessed preprocess(const std::string& text, const std::string& name, const ParseOptions& options,
                        Diagnostics& diagnostics);

}  // namespace pfman
