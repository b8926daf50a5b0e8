// Results of one function beside the correctly rounded ones, counted.
#ifndef VSG_TESTS_ACCURACY_COMPARISON_H_
#define VSG_TESTS_ACCURACY_COMPARISON_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace accuracy {

struct Tally {
  uint64_t inputs = 0;
  uint64_t equal = 0;    // the correctly rounded bits
  uint64_t one_off = 0;  // a neighbour of them
  uint64_t further = 0;  // anything else
  // Wrong where the true value, the rounded one or the result is NaN or infinite, or the true value zero: sign and bits
  // must be right there.
  uint64_t special = 0;
  uint64_t disorder = 0;  // neighbouring inputs whose results go the other way than the true values
  double max_ulp = 0;     // of the result, from the true value, in units of the true value's last place
  double max_absolute = 0;
  double max_relative = 0;  // true values below the smallest normal number left out
  uint32_t worst_x = 0;     // of max_ulp
  uint32_t worst_y = 0;
  uint32_t disorder_x = 0;  // the last one

  void add(const Tally& other);
};

// `neighbours`: the inputs follow each other as bit patterns of one sign, so that their order can be judged. y may be
// null.
Tally compare(const uint32_t* x, const uint32_t* y, const uint32_t* result, const double* value,
              const uint32_t* rounded, std::size_t count, bool neighbours);

nlohmann::json to_json(const Tally& tally);
// Throws nlohmann::json::exception when a field is missing.
Tally tally_from(const nlohmann::json& json);

}  // namespace accuracy

#endif
