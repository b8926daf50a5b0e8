#include "pixelflow/compiler/picture_colour.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"

namespace pfman {
namespace {

using pixelflow::Code;
using pixelflow::Operand;
using pixelflow::Operation;

constexpr int kColourBits = 8;  ///< of a component, all of them behind the point

class ColourWriter {
 public:
  explicit ColourWriter(StreamWriter& out) : out_(out) {}

  void take(int address, int bytes) { std::fill_n(taken_.begin() + address, bytes, true); }
  bool is_free(int address, int bytes) const {
    return std::none_of(taken_.begin() + address, taken_.begin() + address + bytes, [](bool t) { return t; });
  }
  /// Bytes that nothing needs, first in the shared area, then in the shader's own.
  int find(int bytes) {
    for (const auto& [first, last] : {std::pair{kColorAt, pixelflow::kMemoryBytes}, {kParametersAt, kSharedAt}}) {
      for (int at = first; at + bytes <= last; ++at) {
        if (is_free(at, bytes)) return at;
      }
    }
    throw std::logic_error("no memory is left for the conversion of a colour");
  }

  void component(int to, int from, const Scalar& type) {
    if (type.is_float) {
      operate(Code::FloatToFixed, {.address = byte(to), .bytes = 1}, {.address = byte(from), .bytes = 4}, kColourBits);
    } else if (type.exponent >= kColourBits) {
      narrow(to, from, type);
    } else {
      widen(to, from, type);
    }
  }

  void operate(Code code, const Operand& d, const Operand& a, int scale) {
    Operation operation{.code = code, .d = d, .a = a, .b = {}, .scale = scale};
    const auto before = taken_;
    take(d.address, d.bytes);
    take(a.address, a.bytes);
    const int work = pixelflow::workspace_bytes(operation);
    if (work > 0) operation.work = byte(find(work));
    taken_ = before;
    out_.operate(operation);
  }

 private:
  static std::uint8_t byte(int value) { return static_cast<std::uint8_t>(value); }

  /// Bits behind the point are dropped, whole bytes of them by reading only what is above.
  void narrow(int to, int from, const Scalar& type) {
    const int drop = type.exponent - kColourBits, whole = drop / 8;
    const Operand d{.address = byte(to), .bytes = 1};
    if (whole >= type.bytes()) {  // between -1 and 1 of the last place: 0 in any case
      operate(Code::Copy, d, {.bytes = 1, .uniform = true}, 0);
      return;
    }
    Operand a{.address = byte(from + whole), .bytes = byte(type.bytes() - whole), .is_signed = type.is_signed};
    const bool fits = !type.is_signed && type.size - drop <= kColourBits;
    if (drop % 8 != 0) {
      Operand shifted = a;
      shifted.address = fits ? d.address : byte(find(a.bytes));
      if (fits) shifted.bytes = 1;
      operate(Code::ShiftRight, shifted, a, drop % 8);
      a = shifted;
    }
    if (!fits) {
      operate(Code::Saturate, d, a, kColourBits);
    } else if (a.address != d.address) {
      operate(Code::Copy, d, {.address = a.address, .bytes = 1}, 0);
    }
  }

  /// More than eight bits before the last shift, or after it, are white.
  void widen(int to, int from, const Scalar& type) {
    const int places = std::min(kColourBits - type.exponent, kColourBits);
    const Operand d{.address = byte(to), .bytes = 1};
    Operand a{.address = byte(from), .bytes = byte(type.bytes()), .is_signed = type.is_signed};
    if (!type.is_signed && type.size + places <= kColourBits) return operate(Code::ShiftLeft, d, a, places);
    if (type.is_signed || type.size > kColourBits) {
      const Operand limited{.address = byte(find(1)), .bytes = 1};
      operate(Code::Saturate, limited, a, kColourBits);
      a = limited;
    }
    const auto before = taken_;
    take(a.address, a.bytes);
    const Operand wide{.address = byte(find(2)), .bytes = 2};
    taken_ = before;
    operate(Code::ShiftLeft, wide, a, places);
    operate(Code::Saturate, d, wide, kColourBits);
  }

  StreamWriter& out_;
  std::array<bool, pixelflow::kMemoryBytes> taken_{};
};

}  // namespace

void write_picture_colour(StreamWriter& out, const ir::Code& code, const MemoryMap& map) {
  ColourWriter writer(out);
  const int components = static_cast<int>(code.color.size());
  const auto place = [&](int n) {
    return map.address[static_cast<std::size_t>(code.color[static_cast<std::size_t>(n)])];
  };
  const auto type = [&](int n) -> const Scalar& {
    return code.variables[static_cast<std::size_t>(code.color[static_cast<std::size_t>(n)])].scalar;
  };
  writer.take(kMaskAt, 1);
  for (int n = 0; n < components; ++n) writer.take(place(n), type(n).bytes());
  // A colour that is what a light has left may lie where the picture's goes.
  const bool apart = writer.is_free(kColorAt, components);
  writer.take(kColorAt, components);
  const int first = apart ? kColorAt : writer.find(components);
  if (!apart) writer.take(first, components);
  for (int n = 0; n < components; ++n) writer.component(first + n, place(n), type(n));
  if (apart) return;
  const auto bytes = static_cast<std::uint8_t>(components);
  writer.operate(Code::Copy, {.address = kColorAt, .bytes = bytes},
                 {.address = static_cast<std::uint8_t>(first), .bytes = bytes}, 0);
}

}  // namespace pfman
