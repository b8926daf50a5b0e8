// Reads TOML tables key by key, with ranges, and gathers every mistake with its place instead of stopping at the first.
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scanline/error.h"

namespace scanline {

/// Mistakes of one file.
struct TomlMistakes {
  std::string file;
  std::vector<Diagnostic> list;

  void add(const toml::source_region& where, std::string message);
};

struct Range {
  double low = -1e12, high = 1e12;
  bool low_open = false;  ///< the lower end itself is not allowed
};
constexpr Range kPositive{0, 1e12, true};
constexpr Range kNotNegative{0, 1e12, false};

class TomlTable {
 public:
  TomlTable(const toml::table& table, std::string what, TomlMistakes& mistakes)
      : table_(table), what_(std::move(what)), mistakes_(mistakes) {}

  bool has(std::string_view key) const { return table_.contains(key); }
  const toml::source_region& where() const { return table_.source(); }
  const toml::source_region& where(std::string_view key) const;
  TomlMistakes& mistakes() const { return mistakes_; }
  const std::string& what() const { return what_; }

  // Each returns the fallback when the key is missing or wrong; what is wrong has been noted then.
  double number(std::string_view key, double fallback, const Range& range = {});
  int integer(std::string_view key, int fallback, int low, int high);
  bool boolean(std::string_view key, bool fallback);
  std::string text(std::string_view key, const std::string& fallback);
  /// One of `names`; its index.
  std::size_t choice(std::string_view key, const std::vector<std::string>& names, std::size_t fallback);
  template <int N>
  glm::vec<N, double> vector(std::string_view key, const glm::vec<N, double>& fallback, const Range& range = {}) {
    const auto values = numbers(key, N, N, range);
    glm::vec<N, double> result = fallback;
    if (values) {
      for (int k = 0; k < N; ++k) result[k] = (*values)[k];
    }
    return result;
  }
  /// Like vector, but a single number stands for all components.
  glm::dvec3 vector_or_number(std::string_view key, const glm::dvec3& fallback, const Range& range = {});
  /// An array of `least` to `most` numbers; nothing when missing or wrong.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t least, std::size_t most,
                                             const Range& range = {});

  /// The node of a key, marked as known; nullptr when missing.
  const toml::node* node(std::string_view key);
  /// Calls `each` for every table of an array of tables.
  void tables(std::string_view key, const std::string& what, const std::function<void(TomlTable&)>& each);
  /// A sub-table, or nothing.
  std::optional<TomlTable> table(std::string_view key, const std::string& what);
  void missing(std::string_view key);
  /// Every key, of a table whose keys are not known beforehand.
  const toml::table& all() const { return table_; }
  /// Takes all keys as known: after a mistake that leaves open which ones belong here.
  void ignore_unknown();
  /// Notes every key that nobody asked for.
  void finish();

 private:
  void wrong(const toml::node& node, std::string_view key, const std::string& expected);
  std::optional<double> checked(const toml::node& node, std::string_view key, const Range& range);

  const toml::table& table_;
  std::string what_;
  TomlMistakes& mistakes_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace scanline
