// Two whole numbers with something between them, as --size and --frames take them.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace program {

/// "640x480" with separators "xX" gives {640, 480}. Nothing when the text is anything else; numbers have no sign and
/// at most six digits.
inline std::optional<std::pair<int, int>> parse_pair(std::string_view text, std::string_view separators) {
  const auto number = [](std::string_view digits) -> std::optional<int> {
    if (digits.empty() || digits.size() > 6 || digits.find_first_not_of("0123456789") != digits.npos) return {};
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  };
  const std::size_t at = text.find_first_of(separators);
  if (at == text.npos) return {};
  const auto first = number(text.substr(0, at)), second = number(text.substr(at + 1));
  if (!first || !second) return {};
  return std::pair{*first, *second};
}

}  // namespace program
