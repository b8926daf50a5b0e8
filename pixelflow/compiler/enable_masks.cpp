#include "pixelflow/compiler/enable_masks.h"

#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"

namespace pfman {
namespace {

using pixelflow::Alu;
using pixelflow::Assembler;
using pixelflow::Bit;
using pixelflow::Flag;
using pixelflow::FlagOp;
using pixelflow::Gate;
using pixelflow::P;
using pixelflow::Q;
using pixelflow::To;
using pixelflow::ZMode;
using Kind = ir::Instruction::Kind;

bool is_masked_loop(const ir::Instruction& i) { return i.kind == Kind::Loop && i.mask >= 0; }

}  // namespace

void enable_ids(Assembler& out, const std::vector<int>& ids) {
  if (ids.empty()) return out.flag(Flag::E, Bit::One);
  for (std::size_t n = 0; n < ids.size(); ++n) {
    for (int byte = 0; byte < kShaderIdBytes; ++byte) {
      out.alu(Alu::Xor, To::None, P::Immediate, Q::Memory,
              {.addr = kShaderIdAt + byte, .imm = ids[n] >> 8 * byte & 0xFF, .z = byte == 0 ? ZMode::Set : ZMode::And});
    }
    if (ids.size() > 1) out.flag(Flag::K, Bit::Z, false, n == 0 ? FlagOp::Move : FlagOp::Or);
  }
  out.flag(Flag::E, ids.size() > 1 ? Bit::K : Bit::Z);
}

EnableMasks::EnableMasks(StreamWriter& out, const ir::Code& code, std::vector<int> deep, std::vector<int> ids)
    : out_(out), code_(code), deep_(std::move(deep)), ids_(std::move(ids)) {}

bool EnableMasks::restores_within(int first, int last) const {
  return std::any_of(code_.code.begin() + first, code_.code.begin() + last, [](const ir::Instruction& i) {
    // An external function may have conditions of its own.
    return i.kind == Kind::IfMasked || i.kind == Kind::External || is_masked_loop(i);
  });
}

int EnableMasks::bits_within(int first, int last) const {
  int most = 0;
  for (int at = first; at < last; ++at) {
    const ir::Instruction& i = code_.code[static_cast<std::size_t>(at)];
    if (is_masked_loop(i)) {
      const int own = i.masked_breaks && i.masked_continues ? 2 : 1;
      most = std::max(most, own + bits_within(at + 1, i.match));
      at = i.match;
    } else if (i.kind == Kind::IfMasked) {
      const ir::Instruction& middle = code_.code[static_cast<std::size_t>(i.match)];
      const bool has_else = middle.kind == Kind::ElseMasked;
      const int end = has_else ? middle.match : i.match;
      const int own = (has_else ? 1 : 0) + (restores_within(at + 1, i.match) ? 1 : 0);
      most = std::max(most, own + bits_within(at + 1, end));
      at = end;
    }
  }
  return most;
}

int EnableMasks::address(std::size_t byte) const { return byte == 0 ? kMaskAt : deep_[byte - 1]; }

int EnableMasks::set_bit(Region& region, int bit) const {
  const auto byte = static_cast<std::size_t>(bit / kMaskByteBits);
  if (byte >= region.known.size()) throw std::logic_error("more mask bits than there are bytes for them");
  region.known[byte] |= 1 << bit % kMaskByteBits;
  return bit;
}

EnableMasks::Region EnableMasks::inner(const Region& outer, int bit, int free_bit) const {
  Region region{-1, free_bit, outer.dead, outer.known, std::vector<bool>(outer.known.size())};
  if (bit >= 0) region.bit = set_bit(region, bit);
  return region;
}

void EnableMasks::load_enable(Assembler& out, const Region& region) const {
  if (region.bit < 0) return enable_ids(out, ids_);
  const int byte = region.bit / kMaskByteBits;
  out.flag_of_memory(Flag::E, address(static_cast<std::size_t>(byte)), region.bit % kMaskByteBits);
  // The deeper bytes lie in the shader's own memory: elsewhere they may be anything.
  if (byte > 0 && base_bit_ >= 0) out.flag_of_memory(Flag::E, kMaskAt, base_bit_, false, FlagOp::And);
}

void EnableMasks::begin_stage(int first, int last) {
  Region stage;
  stage.known.assign(1 + deep_.size(), 0);
  out_.bare([&](Assembler& out) { enable_ids(out, ids_); });
  begin(std::move(stage), first, last, ids_.empty());
}

/// `everywhere`: the flag is set in all elements, and can be set again without a bit that tells where.
void EnableMasks::begin(Region stage, int first, int last, bool everywhere) {
  const bool own_bit = restores_within(first, last) && !everywhere;
  stage.dirt.assign(stage.known.size(), false);
  base_bit_ = -1;
  if (own_bit) {
    if (stage.free_bit >= kMaskByteBits) throw std::invalid_argument("no bit of the shared mask byte is left");
    base_bit_ = stage.bit = set_bit(stage, stage.free_bit++);
  }
  const int bits = stage.free_bit + bits_within(first, last);
  if (bits > stage.free_bit && bits > kMaskByteBits * static_cast<int>(stage.known.size())) {
    throw std::logic_error("more mask bits than there are bytes for them");
  }
  out_.bare([&](Assembler& out) {
    if (own_bit) out.store_constant(stage.known[0], kMaskAt);
    for (int byte = 1; byte * kMaskByteBits < bits && bits > stage.free_bit; ++byte) {
      out.store_constant(0, address(static_cast<std::size_t>(byte)));
    }
  });
  regions_ = {std::move(stage)};
  constructs_.clear();
  pending_ = pending_next_ = false;
}

void EnableMasks::end_stage() {
  if (regions_.size() != 1) throw std::logic_error("a stage ends within a construct");
  if (regions_[0].known[0] == 0 && !regions_[0].dirt[0]) return;
  out_.bare([](Assembler& out) { out.store_constant(0, kMaskAt, Gate::None); });
}

void EnableMasks::begin_call(int first, int last, int known, int free_bit) {
  Region call;
  call.known.assign(1 + deep_.size(), 0);
  call.known[0] = known;
  call.free_bit = free_bit;
  begin(std::move(call), first, last, false);
}

void EnableMasks::end_call() {
  if (regions_.size() != 1) throw std::logic_error("a call ends within a construct");
  prepare();
  Region before = regions_[0];
  if (base_bit_ >= 0) before.known[0] &= ~(1 << base_bit_);
  store_known(before);
}

EnableMasks::SharedByte EnableMasks::settle() {
  prepare();
  Region& region = regions_.back();
  if (dirty()) store_known(region);
  region.dirt.assign(region.dirt.size(), false);
  return {region.known[0], region.free_bit};
}

void EnableMasks::prepare() {
  if (!pending_) return;
  pending_ = false;
  Region& region = regions_.back();
  if (!pending_next_) {
    out_.bare([&](Assembler& out) { load_enable(out, region); });
    return;
  }
  pending_next_ = false;
  const Construct& loop = constructs_.back();
  Region going_on = regions_[loop.regions - 1];
  if (loop.loop_bit >= 0) going_on.bit = set_bit(going_on, loop.loop_bit);
  out_.bare([&](Assembler& out) {
    load_enable(out, going_on);
    for (std::size_t byte = 0; byte < region.known.size(); ++byte) {
      if (region.known[byte] == going_on.known[byte] && !region.dirt[byte]) continue;
      out.store_constant(region.known[byte], address(byte));
      region.dirt[byte] = false;
    }
  });
}

bool EnableMasks::dirty() const {
  const auto& dirt = regions_.back().dirt;
  return std::find(dirt.begin(), dirt.end(), true) != dirt.end();
}

/// The bytes that the flag's elements, which are those of the last region, have in `target`.
void EnableMasks::store_known(const Region& target, Gate gate) {
  Region& region = regions_.back();
  out_.bare([&](Assembler& out) {
    for (std::size_t byte = 0; byte < region.known.size(); ++byte) {
      if (region.known[byte] == target.known[byte] && !region.dirt[byte]) continue;
      out.store_constant(target.known[byte], address(byte), gate);
    }
  });
}

void EnableMasks::begin_if(int at, int condition) {
  const ir::Instruction& i = code_.code[static_cast<std::size_t>(at)];
  const ir::Instruction& middle = code_.code[static_cast<std::size_t>(i.match)];
  Construct construct;
  construct.at = at;
  construct.has_else = middle.kind == Kind::ElseMasked;
  construct.regions = regions_.size();
  construct.else_restores = construct.has_else && restores_within(i.match + 1, middle.match);
  Region& outer = regions_.back();
  if (outer.dead) {
    construct.branch_else = outer;
    constructs_.push_back(construct);
    regions_.push_back(construct.branch_else);
    return;
  }
  prepare();
  int free_bit = outer.free_bit;
  const int then_bit = restores_within(at + 1, i.match) ? free_bit++ : -1;
  const int else_bit = construct.has_else ? free_bit++ : -1;
  Region then = inner(outer, then_bit, free_bit);
  construct.branch_else = inner(outer, else_bit, free_bit);
  construct.stored = then_bit >= 0 || else_bit >= 0;
  if (!construct.stored) {
    then.dirt = outer.dirt;
    out_.bare([&](Assembler& out) {
      if (condition < 0) {
        out.flag(Flag::E, Bit::K, false, FlagOp::And);
      } else {
        out.flag_of_memory(Flag::E, condition, 0, false, FlagOp::And);
      }
    });
  } else {
    if (condition >= 0) out_.bare([&](Assembler& out) { out.flag_of_memory(Flag::K, condition, 0); });
    store_known(then, Gate::EAndK);
    store_known(construct.branch_else, Gate::EAndNotK);
    outer.dirt.assign(outer.dirt.size(), false);
    out_.bare([](Assembler& out) { out.flag(Flag::E, Bit::K, false, FlagOp::And); });
  }
  constructs_.push_back(construct);
  regions_.push_back(std::move(then));
}

void EnableMasks::begin_else() {
  Construct& construct = constructs_.back();
  Region& outer = regions_[construct.regions - 1];
  if (!outer.dead) {
    const Region& then = regions_.back();
    // What the first branch's elements have in free bits would be taken for the second's.
    if (construct.else_restores && !then.dead && dirty()) {
      prepare();
      store_known(then);
    } else if (!then.dead) {
      for (std::size_t byte = 0; byte < outer.dirt.size(); ++byte) {
        if (then.dirt[byte]) outer.dirt[byte] = true;
      }
    }
    for (std::size_t byte = 0; byte < outer.dirt.size(); ++byte) {
      if (!then.dead && then.known[byte] != outer.known[byte]) outer.dirt[byte] = true;
    }
    pending_ = true;
  }
  regions_.back() = construct.branch_else;
}

void EnableMasks::end_if() {
  const Construct construct = std::move(constructs_.back());
  constructs_.pop_back();
  const Region last = std::move(regions_.back());
  regions_.pop_back();
  Region& outer = regions_.back();
  if (outer.dead) return;
  pending_ = true;
  if (!construct.stored) return;
  for (std::size_t byte = 0; byte < outer.dirt.size(); ++byte) {
    if (!last.dead && (last.dirt[byte] || last.known[byte] != outer.known[byte])) outer.dirt[byte] = true;
  }
}

void EnableMasks::begin_loop(int at) {
  const ir::Instruction& i = code_.code[static_cast<std::size_t>(at)];
  Construct construct;
  construct.at = at;
  construct.regions = regions_.size();
  construct.restores = i.masked_continues;
  if (!reachable()) {
    constructs_.push_back(construct);
    regions_.push_back(Region(regions_.back()));
    return;
  }
  prepare();
  Region& outer = regions_.back();
  int free_bit = outer.free_bit;
  if (i.masked_breaks && i.masked_continues) construct.loop_bit = free_bit++;
  const int bit = free_bit++;
  Region body = inner(outer, bit, free_bit);
  if (construct.loop_bit >= 0) set_bit(body, construct.loop_bit);
  store_known(body);
  outer.dirt.assign(outer.dirt.size(), false);
  constructs_.push_back(construct);
  regions_.push_back(std::move(body));
}

void EnableMasks::next_iteration() {
  if (!reachable() || !constructs_.back().restores) return;
  pending_ = pending_next_ = true;
}

void EnableMasks::end_loop() {
  constructs_.pop_back();
  const Region body = std::move(regions_.back());
  regions_.pop_back();
  pending_next_ = false;
  Region& outer = regions_.back();
  if (outer.dead) return;
  pending_ = true;
  for (std::size_t byte = 0; byte < outer.dirt.size(); ++byte) {
    outer.dirt[byte] = body.dirt[byte] || body.known[byte] != outer.known[byte];
  }
}

void EnableMasks::jump(int loop, bool leaves) {
  if (!reachable()) return;
  const auto construct =
      std::find_if(constructs_.rbegin(), constructs_.rend(), [&](const Construct& c) { return c.at == loop; });
  if (construct == constructs_.rend()) throw std::logic_error("a masked jump out of no loop");
  Region target = regions_[construct->regions - 1];
  if (!leaves && construct->loop_bit >= 0) set_bit(target, construct->loop_bit);
  prepare();
  store_known(target);
  Region& region = regions_.back();
  region.dirt.assign(region.dirt.size(), false);
  region.dead = true;
}

}  // namespace pfman
