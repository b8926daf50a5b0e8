// Text to syntax tree: C preprocessor, lexer, parser.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pixelflow/language/ast.h"
#include "pixelflow/language/diagnostics.h"

namespace pfman {

struct ParseOptions {
  std::vector<std::filesystem::path> include_folders;  ///< searched for #include after the including file's own folder
  std::map<std::string, std::string> macros;           ///< defined before the first line
};

/// Reads a file and what it includes. A file that cannot be read is a diagnostic (E100), as is all that is wrong with
/// the text; the parser goes on after a syntax error at the next statement or definition, so the tree may have gaps
/// when diagnostics.has_errors().
ast::Unit parse_file(const std::filesystem::path& file, const ParseOptions& options, Diagnostics& diagnostics);
/// The same of a text in memory, called `name` in diagnostics; includes are searched relative to name's folder.
ast::Unit parse_text(const std::string& text, const std::string& name, const ParseOptions& options,
                     Diagnostics& diagnostics);

/// The tree as indented text, for --dump=ast: one node a line, kind first, then what it holds.
std::string dump(const ast::Unit& unit);

}  // namespace pfman
