#include "cmodel/pixelflow/pixel_row_alu.h"

#include <array>
#include <utility>

namespace pixelflow {

using namespace vectors;

alignas(kWidth) const std::uint8_t kZeros[kWidth] = {};
alignas(kWidth) const std::uint8_t kOnes[kWidth] = {
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255};

namespace {

// What a loop writes besides the result: most instructions set no flag, or the carry alone.
enum class Flags { None, Carry, All };
enum class Gating { None, E, EAndK };

constexpr bool adds(Alu fn) {
  return fn == Alu::Add || fn == Alu::Sub || fn == Alu::ReverseSub || fn == Alu::AddSub || fn == Alu::AddIf ||
         fn == Alu::NegateIf;
}

constexpr bool uses_k(Alu fn) {
  return fn == Alu::AddSub || fn == Alu::AddIf || fn == Alu::NegateIf || fn == Alu::Select;
}

template <Alu Fn, Flags F, Gating G>
void alu(const AluRows& a) {
  const Bytes invert = fill<Bytes>(a.gate == Gate::EAndNotK ? 0xFF : 0);
  for (int v = 0; v < a.vectors; ++v) {
    const int at = v * kWidth;
    Bytes p = load(a.p + v * a.p_stride), q = load(a.q + v * a.q_stride);
    const Bytes cin = load(a.cin + v * a.cin_stride);
    const Bytes k = uses_k(Fn) || G == Gating::EAndK ? load(a.k + at) : Bytes{};

    Bytes result{}, carry{}, sign;  // carry and sign in bit 7
    if constexpr (Fn == Alu::Sub) q = ~q;
    if constexpr (Fn == Alu::ReverseSub) p = ~p;
    if constexpr (Fn == Alu::AddSub) q ^= k;
    if constexpr (Fn == Alu::AddIf) q &= k;
    if constexpr (Fn == Alu::NegateIf) p ^= k;
    if constexpr (Fn == Alu::And) result = p & q;
    if constexpr (Fn == Alu::Or) result = p | q;
    if constexpr (Fn == Alu::Xor) result = p ^ q;
    if constexpr (Fn == Alu::AndNot) result = p & ~q;
    if constexpr (Fn == Alu::Select) result = select(k, p, q);
    if constexpr (Fn == Alu::ShiftLeft) result = (q + q) - cin, carry = q;
    if constexpr (Fn == Alu::ShiftRight)
      result = shift_right(q, 1) | (cin & std::uint8_t{0x80}), carry = shift_left(q, 7);
    sign = result;
    if constexpr (adds(Fn)) {
      result = p + q - cin;
      carry = carry_bit(p, q, result);
      sign = p ^ q ^ carry;
    }

    std::uint8_t* const to = a.result + v * a.result_stride;
    if constexpr (G == Gating::None) {
      store(to, result);
    } else {
      const Bytes e = load(a.e + at);
      const Bytes gate = G == Gating::E ? e : e & (k ^ invert);
      store(to, select(gate, result, load(to)));
    }
    if constexpr (F != Flags::None) store(a.c_out + v * a.c_stride, top_bit(carry));
    if constexpr (F == Flags::All) {
      const Bytes z = is_zero(result) & load(a.z_in + v * a.z_in_stride);
      store(a.s_out + v * a.s_stride, top_bit(sign));
      store(a.z_out + v * a.z_stride, z);
    }
  }
}

using Loop = void (*)(const AluRows&);
constexpr int kCodes = 16;
constexpr int kVariants = 9;  // flags times gating

template <std::size_t... N>
constexpr std::array<Loop, sizeof...(N)> make_loops(std::index_sequence<N...>) {
  return {
      &alu<static_cast<Alu>(N / kVariants <= static_cast<int>(Alu::ShiftRight) ? N / kVariants
                                                                               : static_cast<int>(Alu::ShiftRight) + 1),
           static_cast<Flags>(N % kVariants / 3), static_cast<Gating>(N % 3)>...};
}

constexpr auto kLoops = make_loops(std::make_index_sequence<kCodes * kVariants>());

}  // namespace

void run_alu(std::uint8_t fn, const AluRows& a) {
  const Flags flags = a.set_zs ? Flags::All : a.set_c ? Flags::Carry : Flags::None;
  const Gating gating = a.gate == Gate::None ? Gating::None : a.gate == Gate::E ? Gating::E : Gating::EAndK;
  kLoops[static_cast<std::size_t>((fn & (kCodes - 1)) * kVariants + static_cast<int>(flags) * 3 +
                                  static_cast<int>(gating))](a);
}

}  // namespace pixelflow
