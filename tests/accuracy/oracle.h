// Correctly rounded float32 values of the mathematical functions.
//
// The C library's double functions are wrong by less than 2^-51 of their value (GNU C library manual, "Known maximum
// errors"); where the doubles that far to either side round to different float32 numbers, MPFR decides with 200 bits.
#ifndef VSG_TESTS_ACCURACY_ORACLE_H_
#define VSG_TESTS_ACCURACY_ORACLE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace accuracy {

// One function, exact or fast: both have the same truth. Functions of one argument ignore y. For atan2, x holds the
// first operand (the ordinate). Not to be shared between threads.
class Oracle {
 public:
  // An unknown name throws std::invalid_argument.
  explicit Oracle(std::string_view function);
  ~Oracle();
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  // The value as a double, and rounded to float32; NaN is 0x7FC00000.
  void values(const uint32_t* x, const uint32_t* y, double* value, uint32_t* rounded, std::size_t count);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace accuracy

#endif
