#include "pixelflow/language/preprocessor.h"

#include <charconv>
#include <fstream>
#include <iterator>

#include "pixelflow/language/condition.h"
#include "pixelflow/language/lexer.h"
#include "pixelflow/language/macros.h"

namespace pfman {
namespace {

constexpr std::size_t kMaximumIncludeDepth = 64;
constexpr std::size_t kMaximumText = std::size_t{16} << 20;  // bytes, of all files of a unit

/// One #if to #endif.
struct Conditional {
  Location where;
  bool outer = true;    // the text around it is live
  bool live = false;    // so is the present part
  bool taken = false;   // a part before or the present one was
  bool closed = false;  // #else stood
};

struct Source {
  std::vector<Token> tokens;
  std::size_t next = 0;
  std::filesystem::path folder;
  std::int64_t line_shift = 0;         // by #line
  std::optional<std::uint32_t> alias;  // the file's name by #line
  std::vector<Conditional> conditionals;

  bool live() const { return conditionals.empty() || conditionals.back().live; }
};

class Preprocessor {
 public:
  Preprocessor(const ParseOptions& options, Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics), macros_(diagnostics), errors_before_(diagnostics.errors()) {}

  Preprocessed run(const std::string& text, const std::string& name) {
    predefine();
    open(text, name, {diagnostics_.add_file(name), 0, 0});
    Expansion expansion(macros_, [this] { return read(); });
    Preprocessed result;
    do {
      result.tokens.push_back(expansion.next());
    } while (result.tokens.back().kind != Token::Kind::End);
    result.pragmas = std::move(pragmas_);
    return result;
  }

 private:
  using Line = std::vector<Token>;

  void predefine() {
    define_text("__PFMAN__", "1");
    for (const auto& [name, body] : options_.macros) define_text(name, body);
  }

  void define_text(const std::string& name, const std::string& body) {
    const std::uint32_t file = diagnostics_.add_file("command line");
    Line line = lex(name, file, diagnostics_);
    if (line.size() != 2 || line[0].kind != Token::Kind::Identifier) {
      diagnostics_.add(100, {file, 0, 0}, "'" + name + "' cannot name a macro");
      return;
    }
    line.pop_back();
    for (Token& token : lex(body, file, diagnostics_)) {
      if (token.kind != Token::Kind::End) line.push_back(std::move(token));
    }
    macros_.define(line, {file, 1, 1});
  }

  void open(const std::string& text, const std::string& name, Location where) {
    text_read_ += text.size();
    if (text_read_ > kMaximumText) {
      macros_.exhaust(where, "more than " + std::to_string(kMaximumText) + " bytes of text");
      return;
    }
    Source source;
    source.tokens = lex(text, diagnostics_.add_file(name), diagnostics_);
    source.folder = std::filesystem::path(name).parent_path();
    sources_.push_back(std::move(source));
  }

  Token located(const Source& source, Token token) const {
    if (source.alias) token.where.file = *source.alias;
    token.where.line = static_cast<std::uint32_t>(token.where.line + source.line_shift);
    return token;
  }

  /// The next token of the text, directives obeyed.
  Token read() {
    while (!macros_.exhausted() && !sources_.empty()) {
      Source& source = sources_.back();
      const Token& token = source.tokens[source.next];
      if (token.kind == Token::Kind::End) {
        const Token end = located(source, token);
        for (const Conditional& open : source.conditionals) {
          diagnostics_.add(100, open.where, "condition without #endif");
        }
        source.conditionals.clear();
        last_ = end.where;
        if (sources_.size() == 1) return end;
        sources_.pop_back();
        continue;
      }
      if (token.line_start && token.is("#")) {
        directive(source);
        stop_after_many_mistakes();
        continue;
      }
      ++source.next;
      if (!source.live()) continue;
      Token result = located(source, token);
      last_ = result.where;
      return result;
    }
    Token end;
    end.where = last_;
    return end;
  }

  void stop_after_many_mistakes() {
    if (diagnostics_.errors() - errors_before_ <= kMaximumMistakes) return;
    macros_.exhaust(last_, "more than " + std::to_string(kMaximumMistakes) + " mistakes; the rest is not read");
  }

  void directive(Source& source) {
    const Token hash = located(source, source.tokens[source.next++]);
    Line line;
    while (source.tokens[source.next].kind != Token::Kind::End && !source.tokens[source.next].line_start) {
      line.push_back(located(source, source.tokens[source.next++]));
    }
    last_ = hash.where;
    if (line.empty()) return;
    const Token name = line[0];
    line.erase(line.begin());
    if (conditional(source, name, line)) return;
    if (!source.live()) return;
    if (name.text == "include") {
      include(source, name, line);
    } else if (name.text == "define") {
      macros_.define(line, name.where);
    } else if (name.text == "undef") {
      if (const auto macro = only_name(name, line)) macros_.undefine(*macro);
    } else if (name.text == "line") {
      set_line(source, name, line);
    } else if (name.text == "error") {
      diagnostics_.add(100, hash.where, "#error" + (line.empty() ? "" : " " + spelled(line)));
    } else if (name.text == "pragma") {
      if (line.empty() || !line[0].is_identifier("pfman")) return;
      const Location where = line[0].where;
      line.erase(line.begin());
      pragmas_.push_back({where, spelled(line)});
    } else {
      diagnostics_.add(100, hash.where, "unknown directive '#" + name.text + "'");
    }
  }

  static std::string spelled(const Line& line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0 && line[i].space) text += ' ';
      const bool string = line[i].kind == Token::Kind::String;
      text += string ? "\"" + line[i].text + "\"" : line[i].text;
    }
    return text;
  }

  std::optional<std::string> only_name(const Token& directive, const Line& line) {
    if (line.empty() || line[0].kind != Token::Kind::Identifier) {
      diagnostics_.add(100, line.empty() ? directive.where : line[0].where,
                       "#" + directive.text + " without the name of a macro");
      return std::nullopt;
    }
    nothing_behind(directive, line, 1);
    return line[0].text;
  }

  void nothing_behind(const Token& directive, const Line& line, std::size_t count) {
    if (line.size() > count) {
      diagnostics_.add(100, line[count].where, "unexpected '" + line[count].text + "' behind #" + directive.text);
    }
  }

  /// #if and its kin; false for any other directive. They count in parts left out too.
  bool conditional(Source& source, const Token& name, const Line& line) {
    auto& open = source.conditionals;
    if (name.text == "if" || name.text == "ifdef" || name.text == "ifndef") {
      Conditional now;
      now.where = name.where;
      now.outer = source.live();
      if (now.outer && name.text == "if") now.live = evaluate_condition(line, name.where, macros_);
      if (now.outer && name.text != "if") {
        const auto macro = only_name(name, line);
        now.live = macro && (macros_.find(*macro) != nullptr) == (name.text == "ifdef");
      }
      now.taken = now.live;
      open.push_back(now);
      return true;
    }
    if (name.text != "elif" && name.text != "else" && name.text != "endif") return false;
    if (open.empty()) {
      diagnostics_.add(100, name.where, "#" + name.text + " without #if");
      return true;
    }
    if (name.text == "endif") {
      if (open.back().outer) nothing_behind(name, line, 0);
      open.pop_back();
      return true;
    }
    Conditional& now = open.back();
    if (now.closed) {
      diagnostics_.add({100, name.where, "#" + name.text + " behind #else", {{now.where, "the #if is here"}}});
      return true;
    }
    now.closed = name.text == "else";
    if (now.outer && now.closed) nothing_behind(name, line, 0);
    now.live = now.outer && !now.taken && (now.closed || evaluate_condition(line, name.where, macros_));
    now.taken |= now.live;
    return true;
  }

  void include(Source& source, const Token& name, Line line) {
    if (!line.empty() && line[0].kind == Token::Kind::Identifier) line = expand(line, macros_);
    if (macros_.exhausted()) return;
    if (line.empty() || line[0].kind != Token::Kind::String) {
      diagnostics_.add(100, line.empty() ? name.where : line[0].where, "#include without a file name in quotes");
      return;
    }
    nothing_behind(name, line, 1);
    if (sources_.size() >= kMaximumIncludeDepth) {
      macros_.exhaust(line[0].where, "files included deeper than " + std::to_string(kMaximumIncludeDepth) +
                                         ", does one include itself?");
      return;
    }
    std::vector<std::filesystem::path> candidates = {source.folder / line[0].text};
    for (const auto& folder : options_.include_folders) candidates.push_back(folder / line[0].text);
    for (const auto& candidate : candidates) {
      std::error_code error;
      if (!std::filesystem::is_regular_file(candidate, error)) continue;
      // Even an empty file counts, or doubling includes would never end.
      text_read_ += 256;
      if (const auto text = read_text(candidate, line[0].where, diagnostics_)) {
        open(*text, candidate.generic_string(), line[0].where);
      }
      return;
    }
    diagnostics_.add(100, line[0].where, "cannot find \"" + line[0].text + "\"");
  }

  void set_line(Source& source, const Token& name, Line line) {
    line = expand(line, macros_);
    if (macros_.exhausted()) return;
    std::int64_t number = 0;
    bool valid = !line.empty() && line[0].kind == Token::Kind::Number;
    if (valid) {
      const std::string& text = line[0].text;
      const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      valid = error == std::errc{} && rest == text.data() + text.size() && number > 0 && number <= 0x7FFF'FFFF;
    }
    if (!valid) {
      diagnostics_.add(100, line.empty() ? name.where : line[0].where, "#line without a line number");
      return;
    }
    if (line.size() > 1 && line[1].kind != Token::Kind::String) {
      nothing_behind(name, line, 1);
      return;
    }
    nothing_behind(name, line, 2);
    if (line.size() > 1) source.alias = diagnostics_.add_file(line[1].text);
    // The line behind the directive: its tokens know their own line, and splices may have made the directive long.
    const Token& following = source.tokens[source.next];
    const Token& last = source.tokens[source.next - 1];
    const std::int64_t next_line = following.kind == Token::Kind::End && following.where.line == last.where.line
                                       ? following.where.line
                                       : std::int64_t{last.where.line} + 1;
    source.line_shift = number - next_line;
  }

  const ParseOptions& options_;
  Diagnostics& diagnostics_;
  MacroTable macros_;
  int errors_before_;
  std::vector<Source> sources_;
  std::vector<ast::Pragma> pragmas_;
  std::size_t text_read_ = 0;
  Location last_;
};

}  // namespace

std::optional<std::string> read_text(const std::filesystem::path& file, Location where, Diagnostics& diagnostics) {
  std::error_code error;
  // Only regular files: a pipe might never end.
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, error)) stream.open(file, std::ios::binary);
  if (!stream.is_open()) {
    diagnostics.add(100, where, "cannot read \"" + file.generic_string() + "\"");
    return std::nullopt;
  }
  if (std::filesystem::file_size(file, error) > kMaximumText) {
    diagnostics.add(100, where,
                    "\"" + file.generic_string() + "\" is larger than " + std::to_string(kMaximumText) + " bytes");
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

Preprocessed preprocess(const std::string& text, const std::string& name, const ParseOptions& options,
                        Diagnostics& diagnostics) {
  return Preprocessor(options, diagnostics).run(text, name);
}

}  // namespace pfman
