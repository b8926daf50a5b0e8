// Multiplication of fixed-point numbers, column by column: all byte products of a column go into W, whose low byte is
// then the product's next byte.
#include <algorithm>
#include <utility>

#include "pixelflow/microcode/routines.h"

namespace pixelflow {
namespace {

/// The factors with the uniform one, if any, in b.
std::pair<Operand, Operand> factors(const Operation& o) {
  return o.a.uniform ? std::pair{o.b, o.a} : std::pair{o.a, o.b};
}

template <typename Visit>
void each_product(const Operand& a, const Operand& b, int column, Visit&& visit) {
  for (int i = std::max(0, column - b.bytes + 1); i <= std::min<int>(a.bytes - 1, column); ++i) visit(i, column - i);
}

/// True where a byte of d is written before a later column reads it as a factor.
bool needs_workspace(const Operation& o) {
  const auto [a, b] = factors(o);
  const int columns = o.scale + o.d.bytes;
  for (int n = 0; n < o.d.bytes; ++n) {
    const int written = o.d.address + n;
    for (int column = o.scale + n + 1; column < columns; ++column) {
      bool hit = false;
      each_product(a, b, column, [&, fa = a, fb = b](int i, int j) {
        hit = hit || fa.address + i == written || (!fb.uniform && fb.address + j == written);
      });
      if (hit) return true;
    }
  }
  return false;
}

}  // namespace

int multiply_workspace(const Operation& o) { return needs_workspace(o) ? o.d.bytes : 0; }

void write_multiply(Assembler& a, const Operation& o) {
  const auto [fa, fb] = factors(o);
  const bool aside = needs_workspace(o);
  const int result = aside ? o.work : o.d.address;
  a.clear_w();
  for (int column = 0; column < o.scale + o.d.bytes; ++column) {
    each_product(fa, fb, column, [&, fa = fa, fb = fb](int i, int j) {
      const bool signed_a = fa.is_signed && i == fa.bytes - 1;
      const bool signed_b = fb.is_signed && j == fb.bytes - 1;
      if (fb.uniform) {
        if (constant_byte(fb, j) != 0) a.multiply_constant(constant_byte(fb, j), fa.address + i, signed_b, signed_a);
        return;
      }
      a.load_x(fa.address + i);
      a.multiply(fb.address + j, signed_a, signed_b);
    });
    if (column < o.scale) {
      a.down();
    } else {
      a.store_w_down(result + column - o.scale);
    }
  }
  if (aside) {
    for (int n = 0; n < o.d.bytes; ++n) {
      a.load_m(result + n);
      a.store(P::M, o.d.address + n);
    }
  }
}

}  // namespace pixelflow
