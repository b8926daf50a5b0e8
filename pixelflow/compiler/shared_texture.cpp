#include "pixelflow/compiler/shared_texture.h"

#include "pixelflow/compiler/enable_masks.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using pixelflow::Alu;
using pixelflow::Assembler;
using pixelflow::Control;
using pixelflow::P;
using pixelflow::Q;
using pixelflow::To;

constexpr int kFloatBytes = 4;

template <typename Write>
pixelflow::Program program(Write&& write) {
  pixelflow::Program result;
  pixelflow::append_instructions(result, write);
  return result;
}

}  // namespace

pixelflow::Program put_coordinates(const TextureUser& user) {
  const int bytes = kFloatBytes * (user.lookup->environment ? 3 : 2);
  return program([&](Assembler& out) {
    enable_ids(out, *user.ids);
    for (int n = 0; n < bytes; ++n) {
      out.load_m(user.lookup->shared->coordinates + n);
      out.alu(Alu::Or, To::Port, P::M, Q::Immediate, {.addr = n});
    }
  });
}

pixelflow::Program send_coordinates() {
  return program([](Assembler& out) { out.control(Control::Send); });
}

pixelflow::Program take_texels(std::span<const TextureUser> users) {
  return program([&](Assembler& out) {
    out.control(Control::WaitInbound);
    for (const TextureUser& user : users) {
      enable_ids(out, *user.ids);
      for (int n = 0; n < user.lookup->components; ++n) {
        out.alu(Alu::Or, To::Memory, P::Zero, Q::Port, {.addr = user.lookup->shared->texel + n, .imm = n});
      }
    }
    out.control(Control::FreeInbound);
  });
}

}  // namespace pfman
