#include "pixelflow/shading/region_programs.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using pixelflow::Alu;
using pixelflow::append;
using pixelflow::append_instructions;
using pixelflow::Assembler;
using pixelflow::Code;
using pixelflow::Control;
using pixelflow::Gate;
using pixelflow::kDepthBytes;
using pixelflow::Operand;
using pixelflow::P;
using pixelflow::Program;
using pixelflow::Q;
using pixelflow::To;

// A plane has so many bytes that its steps add up to less than a float's last bit wherever in the region.
constexpr int kPlaneAt = kDepthAt + kDepthBytes;
constexpr int kPlaneBytes = 5;
constexpr int kWorkAt = kPlaneAt + kPlaneBytes;
constexpr int kXAt = kPositionAt, kYAt = kPositionAt + 4, kZAt = kPositionAt + 8;

Operand number(int address, int bytes = 4, bool is_signed = false) {
  return {
      .address = static_cast<std::uint8_t>(address), .bytes = static_cast<std::uint8_t>(bytes), .is_signed = is_signed};
}
Operand constant(double value) {
  return {.bytes = 4, .uniform = true, .constant = std::bit_cast<std::uint32_t>(static_cast<float>(value))};
}

void operate(Program& program, Code code, int d, const Operand& a, const Operand& b = {}, int scale = 0) {
  append(program, {.code = code, .d = number(d), .a = a, .b = b, .scale = scale, .flush = false, .work = kWorkAt});
}

void to_packet(Assembler& out, int address, int byte) {
  out.load_m(address);
  out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = byte, .gate = Gate::None});
}

/// M, and with it memory[address], becomes memory[address] xor mask.
void flip(Assembler& out, int address, int mask) {
  out.load_m(address);
  out.alu(Alu::Xor, To::Memory, P::M, Q::Immediate, {.addr = address, .imm = mask});
}

/// A plane over one axis of the region, as a float: first + step n, n up to `most`.
void plane(Program& program, int d, double first, double step, int most, bool along_columns) {
  const double largest = std::max(std::abs(first), std::abs(first + step * most));
  // As many places behind the point as the plane holds, and as the conversion takes.
  const int scale = largest > 0 ? std::clamp(8 * kPlaneBytes - 3 - std::ilogb(largest), -64, 128) : 0;
  const auto fixed = [&](double value) { return std::llround(std::clamp(std::ldexp(value, scale), -0x1p62, 0x1p62)); };
  pixelflow::append_plane(program, kPlaneAt, kPlaneBytes, along_columns ? fixed(step) : 0,
                          along_columns ? 0 : fixed(step), fixed(first));
  operate(program, Code::FixedToFloat, d, number(kPlaneAt, kPlaneBytes, true), {}, scale);
}

}  // namespace

Program send_pixel(int number) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    for (int n = 0; n < kDepthBytes; ++n) to_packet(out, kDepthAt + n, n);
    for (int n = 0; n < kPacketPayload; ++n) to_packet(out, kShaderIdAt + kPacketPayload * number + n, kDepthBytes + n);
    out.control(Control::Send);
  });
  return program;
}

Program take_pixel(int number) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    const auto take = [&](int byte, int address) {
      out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = address, .imm = byte, .gate = Gate::None});
    };
    out.control(Control::WaitInbound);
    for (int n = 0; n < kDepthBytes && number == 0; ++n) take(n, kDepthAt + n);
    for (int n = 0; n < kPacketPayload; ++n) take(kDepthBytes + n, kShaderIdAt + kPacketPayload * number + n);
    out.control(Control::FreeInbound);
  });
  return program;
}

Program pre_shade(const EyeSpace& eye, int first_column, int first_row) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    out.flag(pixelflow::Flag::E, pixelflow::Bit::One);
    for (int n = 0; n < kDepthBytes && eye.perspective; ++n) flip(out, kDepthAt + n, 0xFF);
  });
  const double depths = kFarthest;
  operate(program, Code::FixedToFloat, kZAt, number(kDepthAt));
  if (eye.perspective) {
    operate(program, Code::FloatMultiply, kZAt, number(kZAt), constant((1 / eye.near - 1 / eye.far) / depths));
    operate(program, Code::FloatAdd, kZAt, number(kZAt), constant(1 / eye.far));
    operate(program, Code::FloatDivide, kZAt, constant(1), number(kZAt));
  } else {
    operate(program, Code::FloatMultiply, kZAt, number(kZAt), constant((eye.far - eye.near) / depths));
    operate(program, Code::FloatAdd, kZAt, number(kZAt), constant(eye.near));
  }
  plane(program, kXAt, eye.x0 + eye.dx * first_column, eye.dx, pixelflow::kRegionWidth - 1, true);
  plane(program, kYAt, eye.y0 + eye.dy * first_row, eye.dy, pixelflow::kRegionHeight - 1, false);
  if (eye.perspective) {
    operate(program, Code::FloatMultiply, kXAt, number(kXAt), number(kZAt));
    operate(program, Code::FloatMultiply, kYAt, number(kYAt), number(kZAt));
  }
  append_instructions(program, [&](Assembler& out) { flip(out, kZAt + 3, 0x80); });
  return program;
}

Program clear_rest(int packets) {
  Program program;
  append_instructions(program, [&](Assembler& out) {
    for (int address = kShaderIdAt + kPacketPayload * packets; address < pixelflow::kMemoryBytes; ++address) {
      if (address >= kPositionAt && address < kPositionAt + 12) continue;
      out.store_constant(0, address, Gate::None);
    }
  });
  return program;
}

Program send_colors() {
  Program program;
  append_instructions(program, [](Assembler& out) {
    for (int n = 0; n < 3; ++n) to_packet(out, kColorAt + n, n);
    out.control(Control::Send);
  });
  return program;
}

}  // namespace pfman
