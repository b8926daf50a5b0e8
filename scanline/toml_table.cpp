#include "scanline/toml_table.h"

#include <cmath>
#include <sstream>

namespace scanline {
namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string quoted(std::string_view key) {
  std::string text(1, '\'');
  text.append(key).push_back('\'');
  return text;
}

}  // namespace

void TomlMistakes::add(const toml::source_region& where, std::string message) {
  list.push_back({file, static_cast<int>(where.begin.line), static_cast<int>(where.begin.column), std::move(message)});
}

const toml::source_region& TomlTable::where(std::string_view key) const {
  const toml::node* n = table_.get(key);
  return n ? n->source() : table_.source();
}

const toml::node* TomlTable::node(std::string_view key) {
  known_.emplace(key);
  return table_.get(key);
}

void TomlTable::wrong(const toml::node& node, std::string_view key, const std::string& expected) {
  mistakes_.add(node.source(), quoted(key) + " of " + what_ + " must be " + expected);
}

void TomlTable::missing(std::string_view key) {
  mistakes_.add(table_.source(), what_ + " needs the key " + quoted(key));
}

std::optional<double> TomlTable::checked(const toml::node& node, std::string_view key, const Range& range) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) {
    wrong(node, key, "a number");
  } else if (!std::isfinite(*value)) {
    wrong(node, key, "a finite number");
  } else if (*value > range.high) {
    wrong(node, key, "at most " + shown(range.high));
  } else if (range.low_open && *value <= range.low) {
    wrong(node, key, "greater than " + shown(range.low));
  } else if (*value < range.low) {
    wrong(node, key, "at least " + shown(range.low));
  } else {
    return value;
  }
  return std::nullopt;
}

double TomlTable::number(std::string_view key, double fallback, const Range& range) {
  const toml::node* n = node(key);
  return n ? checked(*n, key, range).value_or(fallback) : fallback;
}

int TomlTable::integer(std::string_view key, int fallback, int low, int high) {
  const toml::node* n = node(key);
  if (!n) return fallback;
  const std::optional<std::int64_t> value = n->is_integer() ? n->value<std::int64_t>() : std::nullopt;
  if (value && *value >= low && *value <= high) return static_cast<int>(*value);
  wrong(
      *n, key,
      low == high ? std::to_string(low) : "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return fallback;
}

bool TomlTable::boolean(std::string_view key, bool fallback) {
  const toml::node* n = node(key);
  if (!n) return fallback;
  if (n->is_boolean()) return *n->value<bool>();
  wrong(*n, key, "true or false");
  return fallback;
}

std::string TomlTable::text(std::string_view key, const std::string& fallback) {
  const toml::node* n = node(key);
  if (!n) return fallback;
  if (const auto value = n->value<std::string>(); n->is_string() && !value->empty()) return *value;
  wrong(*n, key, "a text");
  return fallback;
}

std::size_t TomlTable::choice(std::string_view key, const std::vector<std::string>& names, std::size_t fallback) {
  const toml::node* n = node(key);
  if (!n) return fallback;
  std::string known;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (n->is_string() && n->value<std::string>() == names[k]) return k;
    known += (k == 0 ? "" : ", ") + names[k];
  }
  const std::string given = n->is_string() ? ", not " + quoted(*n->value<std::string>()) : "";
  wrong(*n, key, "one of " + known + given);
  return fallback;
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t least, std::size_t most,
                                                      const Range& range) {
  const toml::node* n = node(key);
  if (!n) return std::nullopt;
  const toml::array* array = n->as_array();
  if (!array || array->size() < least || array->size() > most) {
    wrong(*n, key, least == most ? "an array of " + std::to_string(least) + " numbers" : "an array of numbers");
    return std::nullopt;
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    const auto value = checked(element, key, range);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

glm::dvec3 TomlTable::vector_or_number(std::string_view key, const glm::dvec3& fallback, const Range& range) {
  const toml::node* n = node(key);
  if (n && n->is_number()) return glm::dvec3(checked(*n, key, range).value_or(fallback.x));
  return vector<3>(key, fallback, range);
}

void TomlTable::tables(std::string_view key, const std::string& what, const std::function<void(TomlTable&)>& each) {
  const toml::node* n = node(key);
  if (!n) return;
  const toml::array* array = n->as_array();
  if (!array) return wrong(*n, key, "an array of tables");
  for (const toml::node& element : *array) {
    if (const toml::table* t = element.as_table()) {
      TomlTable table(*t, what, mistakes_);
      each(table);
      table.finish();
    } else {
      wrong(element, key, "an array of tables");
    }
  }
}

std::optional<TomlTable> TomlTable::table(std::string_view key, const std::string& what) {
  const toml::node* n = node(key);
  if (!n) return std::nullopt;
  if (const toml::table* t = n->as_table()) return TomlTable(*t, what, mistakes_);
  wrong(*n, key, "a table");
  return std::nullopt;
}

void TomlTable::ignore_unknown() {
  for (const auto& [key, value] : table_) known_.emplace(key.str());
}

void TomlTable::finish() {
  for (const auto& [key, value] : table_) {
    if (!known_.contains(key.str())) mistakes_.add(key.source(), "unknown key " + quoted(key.str()) + " in " + what_);
  }
}

}  // namespace scanline
