#include "tests/compile/ebnf.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <stdexcept>

namespace pfman_tests {
namespace {

constexpr int kEndless = 1000;
constexpr std::size_t kLongest = 150;  // tokens; what is open then ends as soon as it can

std::size_t below(std::size_t count, std::mt19937_64& random) { return static_cast<std::size_t>(random() % count); }

}  // namespace

Grammar::Grammar(const std::string& text) : text_(text) {
  for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
    const std::string name = word();
    if (name.empty() || !accept('=')) throw std::runtime_error("no rule at " + text_.substr(at_, 30));
    rules_[name] = choice();
    if (!accept(';')) throw std::runtime_error("rule " + name + " does not end");
    depths_[name] = kEndless;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [name, part] : rules_) {
      const int depth = 1 + least_depth(part);
      changed |= depth < depths_[name];
      depths_[name] = std::min(depth, depths_[name]);
    }
  }
}

void Grammar::skip_blanks() {
  for (; at_ < text_.size(); ++at_) {
    if (text_.compare(at_, 2, "(*") == 0) {
      at_ = text_.find("*)", at_);
      if (at_ == std::string::npos) throw std::runtime_error("comment without an end");
      ++at_;
    } else if (std::isspace(static_cast<unsigned char>(text_[at_])) == 0) {
      return;
    }
  }
}

bool Grammar::accept(char c) {
  skip_blanks();
  if (at_ >= text_.size() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string Grammar::word() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) ++at_;
  return text_.substr(begin, at_ - begin);
}

Grammar::Part Grammar::choice() {
  Part result{Part::Kind::Choice, "", {}};
  do {
    result.parts.push_back(sequence());
  } while (accept('|'));
  return result;
}

Grammar::Part Grammar::sequence() {
  Part result;
  do {
    result.parts.push_back(primary());
  } while (accept(','));
  return result;
}

Grammar::Part Grammar::primary() {
  skip_blanks();
  const auto bracketed = [&](Part::Kind kind, char closing) {
    Part result{kind, "", {choice()}};
    if (!accept(closing)) throw std::runtime_error(std::string("no ") + closing + " at " + text_.substr(at_, 30));
    return result;
  };
  if (accept('[')) return bracketed(Part::Kind::Option, ']');
  if (accept('{')) return bracketed(Part::Kind::Repetition, '}');
  if (accept('(')) return bracketed(Part::Kind::Sequence, ')');
  if (accept('"')) {
    const std::size_t end = text_.find('"', at_);
    if (end == std::string::npos) throw std::runtime_error("terminal without an end");
    Part result{Part::Kind::Terminal, text_.substr(at_, end - at_), {}};
    at_ = end + 1;
    return result;
  }
  Part result{Part::Kind::Name, word(), {}};
  if (result.text.empty()) throw std::runtime_error("unexpected " + text_.substr(at_, 30));
  return result;
}

std::vector<std::string> Grammar::undefined() const {
  std::set<std::string> names;
  const std::function<void(const Part&)> visit = [&](const Part& part) {
    if (part.kind == Part::Kind::Name && !rules_.contains(part.text)) names.insert(part.text);
    for (const Part& inner : part.parts) visit(inner);
  };
  for (const auto& [name, part] : rules_) visit(part);
  return {names.begin(), names.end()};
}

int Grammar::least_depth(const Part& part) const {
  switch (part.kind) {
    case Part::Kind::Terminal:
    case Part::Kind::Option:
    case Part::Kind::Repetition: return 0;
    case Part::Kind::Name: {
      const auto found = depths_.find(part.text);
      return found == depths_.end() ? 0 : found->second;
    }
    case Part::Kind::Sequence: {
      int depth = 0;
      for (const Part& inner : part.parts) depth = std::max(depth, least_depth(inner));
      return depth;
    }
    case Part::Kind::Choice: {
      int depth = kEndless;
      for (const Part& inner : part.parts) depth = std::min(depth, least_depth(inner));
      return depth;
    }
  }
  return 0;
}

std::vector<std::string> Grammar::sentence(const std::string& rule, int depth, std::mt19937_64& random) const {
  std::vector<std::string> tokens;
  generate(rules_.at(rule), depth, random, tokens);
  return tokens;
}

void Grammar::generate(const Part& part, int depth, std::mt19937_64& random, std::vector<std::string>& out) const {
  if (out.size() > kLongest) depth = 0;
  switch (part.kind) {
    case Part::Kind::Terminal: out.push_back(part.text); return;
    case Part::Kind::Name: {
      const auto rule = rules_.find(part.text);
      if (rule == rules_.end()) {
        out.push_back(part.text);
      } else {
        generate(rule->second, depth - 1, random, out);
      }
      return;
    }
    case Part::Kind::Sequence:
      for (const Part& inner : part.parts) generate(inner, depth, random, out);
      return;
    case Part::Kind::Choice: {
      std::vector<const Part*> possible;
      for (const Part& inner : part.parts) {
        if (least_depth(inner) <= std::max(depth, least_depth(part))) possible.push_back(&inner);
      }
      generate(*possible[below(possible.size(), random)], depth, random, out);
      return;
    }
    case Part::Kind::Option:
    case Part::Kind::Repetition: {
      const bool repeats = part.kind == Part::Kind::Repetition;
      const std::size_t count =
          least_depth(part.parts[0]) > depth ? 0 : below(repeats ? 4 : 2, random) / (repeats ? 2 : 1);
      for (std::size_t n = 0; n < count; ++n) generate(part.parts[0], depth, random, out);
      return;
    }
  }
}

}  // namespace pfman_tests
