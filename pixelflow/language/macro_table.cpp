#include <algorithm>

#include "pixelflow/language/macros.h"

namespace pfman {
namespace {

constexpr std::size_t kMaximumWork = 1'000'000;

bool same(const Macro& a, const Macro& b) {
  const auto equal = [](const Token& x, const Token& y) {
    return x.kind == y.kind && x.text == y.text && x.space == y.space;
  };
  return a.function == b.function && a.parameters == b.parameters &&
         std::equal(a.body.begin(), a.body.end(), b.body.begin(), b.body.end(), equal);
}

}  // namespace

std::shared_ptr<Macro> MacroTable::find(const std::string& name) const {
  const auto found = macros_.find(name);
  return found == macros_.end() ? nullptr : found->second;
}

bool MacroTable::charge(const Token& token) {
  work_ += 1 + token.text.size() / 8;  // names that ## doubles again and again weigh too
  if (work_ > kMaximumWork) exhaust(token.where, "macro expansion grows beyond bounds");
  return !exhausted_;
}

void MacroTable::exhaust(Location where, const std::string& text) {
  if (!exhausted_) diagnostics_.add(100, where, text);
  exhausted_ = true;
}

void MacroTable::define(const std::vector<Token>& line, Location directive) {
  if (line.empty() || line[0].kind != Token::Kind::Identifier) {
    diagnostics_.add(100, line.empty() ? directive : line[0].where, "#define without the name of a macro");
    return;
  }
  Macro macro;
  macro.name = line[0].text;
  macro.where = line[0].where;
  if (macro.name == "defined" || macro.name == "__LINE__" || macro.name == "__FILE__") {
    diagnostics_.add(100, macro.where, "'" + macro.name + "' cannot be defined");
    return;
  }
  std::size_t i = 1;
  if (i < line.size() && line[i].is("(") && !line[i].space) {
    macro.function = true;
    ++i;
    bool closed = i < line.size() && line[i].is(")");
    while (!closed) {
      const bool named = i < line.size() && line[i].kind == Token::Kind::Identifier;
      const bool fresh =
          named && std::find(macro.parameters.begin(), macro.parameters.end(), line[i].text) == macro.parameters.end();
      if (!fresh || i + 1 >= line.size() || !(line[i + 1].is(",") || line[i + 1].is(")"))) {
        diagnostics_.add(100, i < line.size() ? line[i].where : macro.where,
                         named && !fresh ? "macro '" + macro.name + "' has two parameters '" + line[i].text + "'"
                                         : "macro '" + macro.name + "' has a malformed list of parameters");
        return;
      }
      macro.parameters.push_back(line[i].text);
      closed = line[i + 1].is(")");
      i += closed ? 1 : 2;
    }
    ++i;
  }
  macro.body.assign(line.begin() + static_cast<std::ptrdiff_t>(i), line.end());
  if (!macro.body.empty()) macro.body.front().space = false;
  if (!check_body(macro)) return;

  auto& slot = macros_[macro.name];
  if (slot && !same(*slot, macro)) {
    diagnostics_.add({100,
                      macro.where,
                      "macro '" + macro.name + "' is already defined differently",
                      {{slot->where, "the first definition"}}});
    return;
  }
  slot = std::make_shared<Macro>(std::move(macro));
}

bool MacroTable::check_body(const Macro& macro) {
  const auto is_parameter = [&](const Token& token) {
    return token.kind == Token::Kind::Identifier &&
           std::find(macro.parameters.begin(), macro.parameters.end(), token.text) != macro.parameters.end();
  };
  const std::vector<Token>& body = macro.body;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i].is("##") && (i == 0 || i + 1 == body.size())) {
      diagnostics_.add(100, body[i].where, "'##' at an end of macro '" + macro.name + "'");
      return false;
    }
    if (macro.function && body[i].is("#") && (i + 1 == body.size() || !is_parameter(body[i + 1]))) {
      diagnostics_.add(100, body[i].where, "'#' in macro '" + macro.name + "' stands before no parameter");
      return false;
    }
  }
  return true;
}

}  // namespace pfman
