// Noise: its last bits are the processors' own, so the functions themselves are the golden library's.
#include <algorithm>
#include <cmath>

#include "cmodel/pixelflow/native/noise.h"
#include "tests/reference/builtin_tables.h"

namespace reference {
namespace {

using Arguments = std::vector<Value>;

constexpr int kMostOctaves = 16;

/// Coordinates, of an array or of arguments one by one.
struct Coordinates {
  std::vector<std::vector<Raw>> axes;
  std::vector<Number> numbers;
  int lanes = 1;
};

Coordinates coordinates_of(const Node& node, const Arguments& arguments, std::size_t count) {
  Coordinates all;
  for (const Value& argument : arguments) all.lanes = std::max(all.lanes, argument.lanes);
  for (std::size_t n = 0; n < count; ++n) {
    for (int element = 0; element < arguments[n].elements(); ++element) {
      std::vector<Raw>& axis = all.axes.emplace_back();
      for (int lane = 0; lane < all.lanes; ++lane) axis.push_back(arguments[n].at(element, lane));
      all.numbers.push_back(node.operands[n]->number);
    }
  }
  if (all.axes.size() > 3) throw Error(132, "noise of more than three coordinates");
  return all;
}

template <typename Word>
std::vector<Raw> noise_of(const Coordinates& all, void (*function)(int, const Word* const*, Word*, std::size_t)) {
  std::vector<std::vector<Word>> axes;
  for (const auto& axis : all.axes) {
    auto& words = axes.emplace_back();
    for (const Raw raw : axis) words.push_back(static_cast<Word>(raw));
  }
  const Word* pointers[3] = {};
  for (std::size_t n = 0; n < axes.size(); ++n) pointers[n] = axes[n].data();
  std::vector<Word> result(static_cast<std::size_t>(all.lanes));
  function(static_cast<int>(axes.size()), pointers, result.data(), result.size());
  return {result.begin(), result.end()};
}

Value noise(const Node& node, const Arguments& arguments, bool is_signed) {
  Coordinates all = coordinates_of(node, arguments, arguments.size());
  Value value(all.lanes, 1);
  if (all.numbers[0].floating) {
    value.raw = noise_of<std::uint32_t>(all, pixelflow::native::noise_float);
    if (is_signed) {
      for (Raw& raw : value.raw) raw = float_bits(2 * as_float(raw) - 1);
    }
    return value;
  }
  value.raw = noise_of<std::uint16_t>(all, pixelflow::native::noise_fixed);
  for (Raw& raw : value.raw) {
    const Wide whole = is_signed ? 2 * Wide{raw} - 65536 : Wide{raw};
    raw = wrapped(static_cast<Magnitude>(whole), node.number);
  }
  return value;
}

Value cellnoise(const Node& node, const Arguments& arguments) {
  const Coordinates all = coordinates_of(node, arguments, arguments.size());
  Value value(all.lanes, 1);
  for (int lane = 0; lane < all.lanes; ++lane) {
    unsigned cell[3] = {};
    for (std::size_t n = 0; n < all.axes.size(); ++n) {
      const Raw raw = all.axes[n][static_cast<std::size_t>(lane)];
      const Number& from = all.numbers[n];
      const Raw whole = from.floating ? float_to_fixed(raw, signed_fixed(32, 0))
                                      : fixed_to_fixed(raw, from, signed_fixed(64, 0), false);
      cell[n] = static_cast<unsigned>(whole % 256);
    }
    value.to(0, lane) = wrapped(pixelflow::native::noise_hash(cell[0], cell[1], cell[2]), node.number);
  }
  return value;
}

Value turbulence(const Node& node, const Arguments& arguments) {
  const Coordinates all = coordinates_of(node, arguments, 1);
  const Wide octaves = integer(arguments[1].at(0, 0), node.operands[1]->number);
  if (octaves > kMostOctaves) throw Error(0, "turbulence of more than 16 octaves");
  Value sum(all.lanes, 1);
  for (int octave = 0; octave < octaves; ++octave) {
    Coordinates scaled = all;
    for (auto& axis : scaled.axes) {
      for (Raw& raw : axis) raw = float_bits(as_float(raw) * std::ldexp(1.0f, octave));
    }
    const std::vector<Raw> noises = noise_of<std::uint32_t>(scaled, pixelflow::native::noise_float);
    for (int lane = 0; lane < all.lanes; ++lane) {
      const float two_sided = 2 * as_float(noises[static_cast<std::size_t>(lane)]) - 1;
      const float part = std::fabs(two_sided) * std::ldexp(1.0f, -octave);
      sum.to(0, lane) = float_bits(octave == 0 ? part : as_float(sum.at(0, lane)) + part);
    }
  }
  return sum;
}

}  // namespace

void add_noise_functions(std::map<std::string, Builtin>& table) {
  table["noise"] = {"noise", Typing::Noise, false, 0,
                    [](const Node& node, const Arguments& a) { return noise(node, a, false); }};
  table["snoise"] = {"snoise", Typing::Noise, false, 0,
                     [](const Node& node, const Arguments& a) { return noise(node, a, true); }};
  table["cellnoise"] = {"cellnoise", Typing::Cellnoise, false, 0, cellnoise};
  table["turbulence"] = {"turbulence", Typing::Float, false, 0, turbulence};
}

}  // namespace reference
