#include "tests/accuracy/comparison.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace accuracy {
namespace {

double number(uint32_t bits) { return static_cast<double>(std::bit_cast<float>(bits)); }

// Bit patterns in the order of their numbers; the two zeros are neighbours.
int64_t order(uint32_t bits) {
  const int64_t magnitude = bits & 0x7FFFFFFFu;
  return (bits >> 31) != 0 ? -magnitude - 1 : magnitude;
}

// 2^23 / 2^e of a number in [2^e, 2^(e+1)): one over its last place, which is 2^-149 for subnormal numbers.
double per_ulp(double value) {
  const int64_t field = std::max<int64_t>((std::bit_cast<int64_t>(value) >> 52) & 0x7FF, 1023 - 126);
  return std::bit_cast<double>((1023 + 23 + 1023 - field) << 52);
}

// Errors of a block, without branches: most blocks need nothing else.
struct Errors {
  double ulp = 0;
  double absolute = 0;
  double relative = 0;
};

Errors errors_of(const uint32_t* result, const double* value, std::size_t count) {
  Errors errors;
  for (std::size_t i = 0; i < count; ++i) {
    const double truth = std::fabs(value[i]);
    const double got = number(result[i]);
    const bool judged = (truth <= 0x1.fffffep127) & (truth > 0) & (std::fabs(got) <= 0x1.fffffep127);
    const double error = judged ? std::fabs(got - value[i]) : 0.0;
    const double relative = truth >= 0x1p-126 ? error / truth : 0.0;
    const double ulp = error * per_ulp(value[i]);
    errors.absolute = error > errors.absolute ? error : errors.absolute;
    errors.relative = relative > errors.relative ? relative : errors.relative;
    errors.ulp = ulp > errors.ulp ? ulp : errors.ulp;
  }
  return errors;
}

}  // namespace

Tally compare(const uint32_t* x, const uint32_t* y, const uint32_t* result, const double* value,
              const uint32_t* rounded, std::size_t count, bool neighbours) {
  Tally tally;
  tally.inputs = count;
  const Errors errors = errors_of(result, value, count);
  tally.max_ulp = errors.ulp;
  tally.max_absolute = errors.absolute;
  tally.max_relative = errors.relative;
  for (std::size_t i = 0; i < count; ++i) {
    const double error = std::fabs(number(result[i]) - value[i]);
    if (error * per_ulp(value[i]) != errors.ulp || value[i] == 0) continue;
    tally.worst_x = x[i];
    tally.worst_y = y != nullptr ? y[i] : 0u;
    break;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (result[i] == rounded[i]) {
      ++tally.equal;
      continue;
    }
    const bool plain = std::isfinite(value[i]) && value[i] != 0 && std::isfinite(number(result[i])) &&
                       std::isfinite(number(rounded[i]));
    if (!plain) ++tally.special;
    const bool next = plain && std::abs(order(result[i]) - order(rounded[i])) == 1;
    ++(next ? tally.one_off : tally.further);
  }
  if (!neighbours) return tally;
  for (std::size_t i = 1; i < count; ++i) {
    const double step = number(result[i]) - number(result[i - 1]);
    const double true_step = value[i] - value[i - 1];
    // Two arguments on either side of an extreme may have the same value but for the double's last places.
    const bool clear = std::fabs(true_step) > std::fabs(value[i]) * 0x1p-48;
    if (((step > 0 && true_step < 0) || (step < 0 && true_step > 0)) && clear) {
      ++tally.disorder;
      tally.disorder_x = x[i];
    }
  }
  return tally;
}

void Tally::add(const Tally& other) {
  inputs += other.inputs;
  equal += other.equal;
  one_off += other.one_off;
  further += other.further;
  special += other.special;
  disorder += other.disorder;
  if (other.disorder != 0) disorder_x = other.disorder_x;
  if (other.max_ulp > max_ulp) {
    max_ulp = other.max_ulp;
    worst_x = other.worst_x;
    worst_y = other.worst_y;
  }
  max_absolute = std::max(max_absolute, other.max_absolute);
  max_relative = std::max(max_relative, other.max_relative);
}

nlohmann::json to_json(const Tally& tally) {
  return {{"inputs", tally.inputs},
          {"equal", tally.equal},
          {"one_off", tally.one_off},
          {"further", tally.further},
          {"special", tally.special},
          {"disorder", tally.disorder},
          {"max_ulp", tally.max_ulp},
          {"max_absolute", tally.max_absolute},
          {"worst_x", tally.worst_x},
          {"worst_y", tally.worst_y},
          {"max_relative", tally.max_relative},
          {"disorder_x", tally.disorder_x}};
}

Tally tally_from(const nlohmann::json& json) {
  Tally tally;
  json.at("inputs").get_to(tally.inputs);
  json.at("equal").get_to(tally.equal);
  json.at("one_off").get_to(tally.one_off);
  json.at("further").get_to(tally.further);
  json.at("special").get_to(tally.special);
  json.at("disorder").get_to(tally.disorder);
  json.at("max_ulp").get_to(tally.max_ulp);
  json.at("max_absolute").get_to(tally.max_absolute);
  json.at("max_relative").get_to(tally.max_relative);
  json.at("worst_x").get_to(tally.worst_x);
  json.at("worst_y").get_to(tally.worst_y);
  json.at("disorder_x").get_to(tally.disorder_x);
  return tally;
}

}  // namespace accuracy
