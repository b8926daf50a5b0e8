// Rows of bits: sets of variables, one for each instruction or variable.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace pfman {

class BitMatrix {
 public:
  BitMatrix() = default;
  BitMatrix(int rows, int columns)
      : words_((columns + 63) / 64), columns_(columns), bits_(static_cast<std::size_t>(rows) * words_) {}

  int words() const { return words_; }  ///< of a row
  int columns() const { return columns_; }
  std::uint64_t* row(int r) { return bits_.data() + static_cast<std::size_t>(r) * words_; }
  const std::uint64_t* row(int r) const { return bits_.data() + static_cast<std::size_t>(r) * words_; }

  bool test(int r, int c) const { return row(r)[c / 64] >> (c % 64) & 1; }
  void set(int r, int c) { row(r)[c / 64] |= std::uint64_t{1} << (c % 64); }
  void reset(int r, int c) { row(r)[c / 64] &= ~(std::uint64_t{1} << (c % 64)); }
  void add(int r, const std::uint64_t* other) {
    std::uint64_t* const own = row(r);
    for (int w = 0; w < words_; ++w) own[w] |= other[w];
  }
  void keep(int r, const std::uint64_t* other) {
    std::uint64_t* const own = row(r);
    for (int w = 0; w < words_; ++w) own[w] &= other[w];
  }

  /// visit(column) for each bit that is set, in ascending order.
  template <typename Visit>
  void each(int r, Visit&& visit) const {
    for (int w = 0; w < words_; ++w) {
      for (std::uint64_t rest = row(r)[w]; rest != 0; rest &= rest - 1) visit(64 * w + std::countr_zero(rest));
    }
  }

 private:
  int words_ = 0, columns_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace pfman
