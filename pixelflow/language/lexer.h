// Text to tokens. A backslash at the end of a line joins it with the next one; lines end with LF or CRLF; comments are
// white space. Columns count bytes.
#pragma once

#include <string_view>
#include <vector>

#include "pixelflow/language/token.h"

namespace pfman {

/// All tokens of a text, the last one End. A comment without an end is E101; Bad tokens are left to who uses them,
/// since they are no mistake in a part that #if leaves out.
std::vector<Token> lex(std::string_view text, std::uint32_t file, Diagnostics& diagnostics);

/// E101 of a Bad token.
void report_bad(const Token& token, Diagnostics& diagnostics);

}  // namespace pfman
