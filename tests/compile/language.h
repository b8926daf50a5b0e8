// What the language's tests share: texts in, tokens, trees and messages out.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "pixelflow/language/parser.h"
#include "pixelflow/language/preprocessor.h"

namespace pfman_tests {

struct Result {
  std::string text;      ///< tokens with blanks between, or a tree
  std::string messages;  ///< as Diagnostics::text()
};

inline Result preprocess(const std::string& text, const pfman::ParseOptions& options = {},
                         const std::string& name = "t") {
  pfman::Diagnostics diagnostics;
  diagnostics.add_file(name);
  Result result;
  for (const pfman::Token& token : pfman::preprocess(text, name, options, diagnostics).tokens) {
    if (token.kind == pfman::Token::Kind::End) break;
    if (!result.text.empty()) result.text += ' ';
    result.text += token.kind == pfman::Token::Kind::String ? "\"" + token.text + "\"" : token.text;
  }
  result.messages = diagnostics.text();
  return result;
}

/// Of a text that there is nothing to say about.
inline std::string tokens(const std::string& text) {
  const Result result = preprocess(text);
  EXPECT_EQ(result.messages, "") << text;
  return result.text;
}

inline std::string messages(const std::string& text) { return preprocess(text).messages; }

inline Result parse(const std::string& text) {
  pfman::Diagnostics diagnostics;
  Result result;
  result.text = pfman::dump(pfman::parse_text(text, "t", {}, diagnostics));
  result.messages = diagnostics.text();
  return result;
}

}  // namespace pfman_tests
