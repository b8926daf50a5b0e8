#include "cmodel/pixelflow/macro.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <string>

#include "cmodel/pixelflow/macro_kernels.h"

namespace pixelflow {
namespace {

bool between(Code code, Code first, Code last) { return code >= first && code <= last; }

bool is_noise(Code code) { return code == Code::NoiseFixed || code == Code::NoiseFloat; }

[[noreturn]] void refuse(const Operation& o, const std::string& what) {
  throw std::invalid_argument("operation " + std::to_string(static_cast<int>(o.code)) + ": " + what);
}

/// Bytes that an operand occupies: of noise the coordinates lie one after another.
int extent(const Operation& o, const Operand& operand) {
  return is_noise(o.code) && &operand == &o.a ? operand.bytes * o.scale : operand.bytes;
}

bool overlap(int first, int bytes, int other, int other_bytes) {
  return first < other + other_bytes && other < first + bytes;
}

void check_operand(const Operation& o, const Operand& operand, const char* name, bool is_float) {
  if (is_float && operand.bytes != 4)
    refuse(o, std::string(name) + " is a float and has 4 bytes, not " + std::to_string(operand.bytes));
  if (operand.bytes < 1 || operand.bytes > 8)
    refuse(o, std::string(name) + " has 1 to 8 bytes, not " + std::to_string(operand.bytes));
  if (!operand.uniform && operand.address + extent(o, operand) > kMemoryBytes) {
    refuse(o, std::string(name) + " leaves the memory: " + std::to_string(extent(o, operand)) + " bytes at " +
                  std::to_string(operand.address));
  }
}

void check_scale(const Operation& o, int least, int most) {
  if (o.scale < least || o.scale > most) {
    refuse(o, "scale is " + std::to_string(least) + " to " + std::to_string(most) + ", not " + std::to_string(o.scale));
  }
}

void check_scales(const Operation& o) {
  switch (o.code) {
    case Code::Multiply: check_scale(o, 0, 16); break;
    case Code::Divide: check_scale(o, 0, 16 - o.a.bytes); break;
    case Code::ShiftLeft:
    case Code::ShiftRight: check_scale(o, 0, 64); break;
    case Code::SquareRoot: check_scale(o, 0, 128 - 8 * o.a.bytes); break;
    case Code::Wrap:
    case Code::Saturate: check_scale(o, 1, 64); break;
    case Code::FixedToFloat:
    case Code::FloatToFixed: check_scale(o, -kMostBinaryScale, kMostBinaryScale); break;
    case Code::NoiseFixed:
    case Code::NoiseFloat: check_scale(o, 1, 3); break;
    default: break;
  }
}

}  // namespace

bool is_comparison(Code code) {
  return between(code, Code::Less, Code::Equal) || between(code, Code::FloatLess, Code::FloatEqual);
}

int operand_count(Code code) {
  switch (code) {
    case Code::Copy:
    case Code::ShiftLeft:
    case Code::ShiftRight:
    case Code::SquareRoot:
    case Code::Wrap:
    case Code::Saturate:
    case Code::FloatSquareRoot:
    case Code::FixedToFloat:
    case Code::FloatToFixed:
    case Code::NoiseFixed:
    case Code::NoiseFloat: return 1;
    default: return between(code, Code::Sin, Code::FastLog2) ? 1 : 2;
  }
}

bool takes_floats(Code code) {
  return between(code, Code::FloatAdd, Code::FloatEqual) || between(code, Code::FloatToFixed, Code::Pow) ||
         code == Code::NoiseFloat;
}

bool gives_float(Code code) {
  return between(code, Code::FloatAdd, Code::FloatSquareRoot) || code == Code::FixedToFloat ||
         between(code, Code::Sin, Code::Pow) || code == Code::NoiseFloat;
}

void check(const Operation& o, int workspace_bytes) {
  if (o.code >= Code::Count) refuse(o, "no such code");
  check_scales(o);
  const auto needs_space = [&](const Operand& operand) { return !operand.uniform; };
  const bool writes_d = !is_comparison(o.code), reads_b = operand_count(o.code) == 2;
  check_operand(o, o.a, "a", takes_floats(o.code));
  if (reads_b) check_operand(o, o.b, "b", takes_floats(o.code));
  if (o.code == Code::NoiseFixed && (o.a.bytes != 2 || o.d.bytes != 2))
    refuse(o, "coordinates and result have 2 bytes");
  if (is_noise(o.code) && o.a.uniform) refuse(o, "the point is a constant");
  if (writes_d) {
    check_operand(o, o.d, "d", gives_float(o.code));
    if (o.d.uniform) refuse(o, "d is a constant");
  }

  if (o.work + workspace_bytes > kMemoryBytes) refuse(o, "the workspace leaves the memory");
  const auto check_apart = [&](const Operand& operand, const char* name) {
    if (!needs_space(operand)) return;
    if (workspace_bytes > 0 && overlap(operand.address, extent(o, operand), o.work, workspace_bytes)) {
      refuse(o, std::string(name) + " overlaps the workspace");
    }
    const bool same = operand.address == o.d.address;
    if (writes_d && !same && overlap(operand.address, extent(o, operand), o.d.address, o.d.bytes)) {
      refuse(o, std::string(name) + " overlaps d and does not start where d does");
    }
  };
  check_apart(o.a, "a");
  if (reads_b) check_apart(o.b, "b");
  if (writes_d) check_apart(o.d, "d");
}

void compute(const Operation& o, PixelRow& row) {
  switch (o.code) {
    case Code::Copy:
    case Code::Add:
    case Code::Sub: macro::add(o, row); break;
    case Code::Less:
    case Code::LessEqual:
    case Code::Equal: macro::compare(o, row); break;
    case Code::FloatAdd:
    case Code::FloatSub:
    case Code::FloatMultiply:
    case Code::FloatDivide:
    case Code::FloatSquareRoot: macro::float_arithmetic(o, row); break;
    case Code::FloatLess:
    case Code::FloatLessEqual:
    case Code::FloatEqual: macro::float_compare(o, row); break;
    case Code::FixedToFloat:
      if (!macro::words(o, row)) macro::convert(o, row);
      break;
    case Code::FloatToFixed: macro::convert(o, row); break;
    case Code::NoiseFixed:
    case Code::NoiseFloat: macro::noise(o, row); break;
    default:
      if (o.code >= Code::Sin) {
        macro::function(o, row);
      } else if (!macro::words(o, row)) {
        macro::fixed(o, row);
      }
  }
}

}  // namespace pixelflow
