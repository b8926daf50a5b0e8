#include "tests/pfman_memory/random_code.h"

#include <algorithm>

#include "pixelflow/compiler/ir_access.h"
#include "pixelflow/compiler/memory_layout.h"

namespace pfman_tests {

using pixelflow::Code;

RandomCode::RandomCode(std::uint64_t seed, const RandomShape& shape)
    : builder("random", shape.light_shader ? pfman::Shader::Kind::Light : pfman::Shader::Kind::Surface),
      random_(static_cast<std::uint32_t>(seed * 2654435761u + 1)),
      shape_(shape) {
  declare();
  block(shape_.statements, 0);
  if (shape_.lights && !shape_.light_shader) {
    const Values before = has_value_;
    stage(1);
    block(shape_.statements, 0);
    // There may be no light.
    has_value_ = before;
    has_value_.resize(builder.code.variables.size(), false);
    stage(2);
    block(shape_.statements / 2, 0);
  }
  const std::vector<int> outputs = shape_.light_shader ? pfman::ir::used_at_end(builder.code) : builder.code.color;
  for (const int v : outputs) builder.operate(Code::Add, builder.use(v), source(0, false, v), source(2));
}

void RandomCode::declare() {
  constexpr int kSizes[] = {1, 2, 4, 8, 3};
  constexpr int kLightBytes = 2;
  if (shape_.light_shader) {
    for (int n = 0; n < 3; ++n) {
      singles_.push_back(
          builder.at_address("light" + std::to_string(n), kLightBytes, pfman::kLightColorAt + kLightBytes * n));
    }
  } else {
    for (int n = 2 + below(3); n > 0; --n)
      singles_.push_back(builder.parameter("p" + std::to_string(n), kSizes[below(4)]));
  }
  const std::vector<int> given = singles_;
  for (int n = 5 + below(12); n > 0; --n)
    singles_.push_back(builder.variable("v" + std::to_string(n), kSizes[below(5)]));
  for (int n = 2 + below(3); n > 0; --n) singles_.push_back(builder.float_variable("f" + std::to_string(n)));
  for (int n = 4 + below(8); n > 0; --n) singles_.push_back(builder.temporary(kSizes[below(3)]));
  condition_ = builder.variable("condition", 1);
  point_ = builder.variable("point", 2, 3);
  coordinates_ = builder.float_variable("coordinates", 2);
  texel_ = builder.variable("texel", 1, 3);
  arrays_ = {builder.variable("array", 1 + below(4), 2 + below(3)), point_, texel_};
  if (!shape_.light_shader) {
    for (int n = 0; n < 3; ++n) {
      builder.code.color.push_back(builder.variable("color" + std::to_string(n), 2));
      singles_.push_back(builder.code.color.back());
    }
  }
  if (chance(20)) builder.code.mask_bytes.push_back(builder.variable("masks", 1));
  has_value_.assign(builder.code.variables.size(), false);
  if (!shape_.light_shader) {
    for (const int v : given) give(v);
  }
  const int first = pick(2, false);
  builder.put(first, 7);
  give(first);
}

void RandomCode::stage(int number) {
  builder.stage(number);
  if (number != 1) return;
  for (int n = 0; n < 2; ++n) {
    const int v = builder.at_address("px_light" + std::to_string(n), 2, pfman::kLightColorAt + 2 * n);
    const int to = pick(2, false);
    has_value_.resize(builder.code.variables.size(), false);
    builder.copy(to, v);
    give(to);
  }
}

void RandomCode::block(int statements, int depth) {
  for (int n = 0; n < statements; ++n) statement(depth);
}

void RandomCode::statement(int depth) {
  const int kind = below(100);
  if (depth < 3 && shape_.branches && kind < 8) return branch(depth);
  if (depth < 3 && shape_.branches && kind < 11) return twice(depth);
  if (depth < 3 && shape_.loops && kind < 17) return loop(depth);
  if (!loops_.empty() && kind < 20) return jump();
  assign();
}

int RandomCode::pick(int bytes, bool with_value) {
  std::vector<int> fitting;
  for (const int v : singles_) {
    if (bytes != 0 && size_of(v) != bytes) continue;
    if (with_value && !has_value_[static_cast<std::size_t>(v)]) continue;
    if (!with_value && std::find(frozen_.begin(), frozen_.end(), v) != frozen_.end()) continue;
    fitting.push_back(v);
  }
  return fitting.empty() ? -1 : fitting[static_cast<std::size_t>(below(static_cast<int>(fitting.size())))];
}

RandomCode::Operand RandomCode::source(int bytes, bool literal_allowed, int whole) {
  const int v = pick(bytes, true);
  if (v < 0 || (literal_allowed && chance(20))) return builder.literal(random_(), bytes == 0 ? 1 + below(4) : bytes);
  Operand operand = builder.use(v);
  if (bytes == 0 && v != whole && operand.bytes > 1 && chance(15)) {  // without its low bytes, as a shift leaves it
    operand.offset = 1 + below(operand.bytes - 1);
    operand.bytes -= operand.offset;
  }
  return operand;
}

RandomCode::Operand RandomCode::target(int bytes) {
  int v = pick(bytes, false);
  if (v < 0) {
    v = builder.variable("more", bytes == 0 ? 4 : bytes);
    has_value_.push_back(false);
    singles_.push_back(v);
  }
  return builder.use(v);
}

void RandomCode::assign() {
  switch (below(10)) {
    case 0: return assign_float();
    case 1: return assign_bytes();
    case 2:
    case 3: return assign_copy();
    case 4: return assign_part();
    case 5: return assign_element();
    case 6: return chance(50) ? noise() : lookup();
    default: return assign_fixed();
  }
}

void RandomCode::assign_fixed() {
  constexpr Code kCodes[] = {Code::Add, Code::Sub, Code::Multiply, Code::Divide, Code::Remainder, Code::ShiftRight};
  const Code code = kCodes[below(6)];
  const Operand d = target(0), a = source(0, false, d.variable);
  if (a.kind == Operand::Kind::Uniform) {
    builder.operate(Code::Copy, d, a);
  } else {
    const bool scaled = code == Code::Multiply || code == Code::Divide || code == Code::ShiftRight;
    const Operand b = code == Code::ShiftRight ? Operand{} : source(0, true, d.variable);
    builder.operate(code, d, a, b, scaled ? below(3) : 0);
  }
  give(d.variable);
}

void RandomCode::assign_float() {
  constexpr Code kUnary[] = {Code::FloatSquareRoot, Code::Sin, Code::Exp, Code::Log2};
  constexpr Code kBinary[] = {Code::FloatAdd, Code::FloatMultiply, Code::FloatDivide, Code::Pow, Code::Atan2};
  const int a = pick(4, true);
  if (a < 0) return;
  const Operand d = target(4);
  if (chance(30)) {
    builder.operate(kUnary[below(4)], d, builder.use(a));
  } else {
    builder.operate(kBinary[below(5)], d, builder.use(a), source(4));
  }
  give(d.variable);
}

void RandomCode::assign_bytes() {
  const int bytes = 1 + below(2);
  const int a = pick(bytes, true);
  if (a < 0) return;
  const Operand b = source(bytes);
  const Operand d = target(bytes);
  constexpr Kind kKinds[] = {Kind::And, Kind::Or, Kind::Xor, Kind::Select};
  const Kind kind = kKinds[below(4)];
  Operand condition;
  if (kind == Kind::Select) {
    const int byte = pick(1, true);
    if (byte >= 0 && chance(60)) {
      condition = builder.use(byte);
    } else {
      builder.operate(Code::Less, chance(30) ? target(1) : Operand{}, builder.use(a), source(bytes));
    }
  }
  auto& instruction = builder.add(kind);
  instruction.d = d;
  instruction.a = builder.use(a);
  instruction.b = b;
  instruction.condition = condition;
  give(d.variable);
}

void RandomCode::assign_copy() {
  const int a = pick(0, true);
  if (a < 0) return;
  const Operand d = target(size_of(a));
  builder.copy(d.variable, a);
  give(d.variable);
}

/// Some bytes of a number.
void RandomCode::assign_part() {
  const int v = pick(4, true);
  if (v < 0 || std::find(frozen_.begin(), frozen_.end(), v) != frozen_.end()) return;
  Operand d = builder.use(v);
  d.offset = below(3);
  d.bytes = 1 + below(4 - d.offset);
  const Operand a = source(2);
  if (a.kind == Operand::Kind::Uniform) {
    builder.operate(Code::Copy, d, builder.literal(random_(), d.bytes));
  } else if (a.variable != v) {
    builder.operate(Code::Add, d, a, builder.literal(3, 1));
  }
}

void RandomCode::assign_element() {
  const int v = arrays_[static_cast<std::size_t>(below(3))];
  const bool known = has_value_[static_cast<std::size_t>(v)];
  if (!known) {
    const int count = builder.code.variables[static_cast<std::size_t>(v)].count;
    for (int n = 0; n < count; ++n) {
      Operand d = builder.use(v);
      d.offset = n * size_of(v);
      builder.operate(Code::Copy, d, builder.literal(random_(), d.bytes));
    }
    return give(v);
  }
  const Operand element = builder.element(v, builder.uniform_literal(0));
  if (chance(50)) {
    builder.operate(Code::Add, element, source(0, false),
                    chance(50) ? builder.element(v, builder.uniform_literal(0)) : source(1));
    if (builder.code.code.back().a.kind == Operand::Kind::Uniform) builder.code.code.back().a = element;
  } else {
    const Operand d = target(0);
    builder.operate(Code::Multiply, d, element, source(0, true, d.variable), 1);
    give(d.variable);
  }
}

void RandomCode::noise() {
  if (!has_value_[static_cast<std::size_t>(point_)]) return;
  const Operand d = target(2);
  builder.operate(Code::NoiseFixed, d, builder.use(point_), {}, 3);
  give(d.variable);
}

void RandomCode::lookup() {
  if (!has_value_[static_cast<std::size_t>(coordinates_)]) {
    for (int n = 0; n < 2; ++n) {
      Operand d = builder.use(coordinates_);
      d.offset = 4 * n;
      builder.operate(Code::Copy, d, source(4));
    }
    return give(coordinates_);
  }
  auto& instruction = builder.add(Kind::Lookup);
  instruction.d = builder.use(texel_);
  instruction.a = builder.use(coordinates_);
  instruction.uniform = builder.uniform_literal(1);
  give(texel_);
}

void RandomCode::branch(int depth) {
  const bool masked = chance(70);
  int at = 0;
  if (masked) {
    const int byte = pick(1, true);
    if (byte >= 0 && chance(50)) {
      at = builder.begin_if(Kind::IfMasked, builder.use(byte));
    } else {
      builder.operate(Code::LessEqual, {}, source(0, false), source(0));
      if (builder.code.code.back().a.kind == Operand::Kind::Uniform)
        builder.code.code.back().a = builder.use(pick(0, true));
      at = builder.begin_if(Kind::IfMasked);
    }
  } else {
    at = builder.begin_if(Kind::If, {}, builder.uniform_literal(0));
  }
  const Values before = has_value_;
  const bool was_masked = !loops_.empty() && loops_.back().masked;
  if (masked && !loops_.empty()) loops_.back().masked = true;
  block(1 + below(4), depth + 1);
  Values after_then = has_value_;
  has_value_ = before;
  has_value_.resize(after_then.size(), false);
  if (chance(50)) {
    at = builder.begin_else(at);
    block(1 + below(4), depth + 1);
  }
  after_then.resize(has_value_.size(), false);
  for (std::size_t v = 0; v < has_value_.size(); ++v) has_value_[v] = has_value_[v] && after_then[v];
  builder.end_if(at);
  if (!loops_.empty()) loops_.back().masked = was_masked;
}

/// A variable that has a value only where a condition holds, and is read only there.
void RandomCode::twice(int depth) {
  const auto is_frozen = [&](int v) { return std::find(frozen_.begin(), frozen_.end(), v) != frozen_.end(); };
  std::vector<int> fresh;
  for (const int v : singles_) {
    if (!has_value_[static_cast<std::size_t>(v)] && !is_frozen(v)) fresh.push_back(v);
  }
  if (fresh.empty() || is_frozen(condition_)) return;
  builder.operate(Code::Less, builder.use(condition_), builder.use(pick(0, true)), source(0));
  const int v = fresh[static_cast<std::size_t>(below(static_cast<int>(fresh.size())))];
  int at = builder.begin_if(Kind::IfMasked, builder.use(condition_));
  builder.operate(Code::Add, builder.use(v), builder.use(pick(0, true)), source(0));
  builder.end_if(at);
  frozen_.push_back(v);
  frozen_.push_back(condition_);
  block(1 + below(4), depth + 1);
  frozen_.pop_back();
  frozen_.pop_back();
  at = builder.begin_if(Kind::IfMasked, builder.use(condition_));
  const Operand d = target(size_of(v));
  builder.operate(Code::Add, d, builder.use(v), source(0, true, d.variable));
  builder.end_if(at);
}

void RandomCode::loop(int depth) {
  const bool masked = chance(70), test_last = chance(30);
  const int at = builder.begin_loop(masked, masked);
  builder.code.code[static_cast<std::size_t>(at)].uniform = builder.uniform_literal(0);
  if (!test_last) builder.loop_test(at, builder.uniform_literal(0));
  const Values before = has_value_;
  loops_.push_back({at, false, false, before});
  block(2 + below(5), depth + 1);
  loops_.pop_back();
  // Jumps may have left out anything of the body.
  const std::size_t variables = has_value_.size();
  has_value_ = before;
  has_value_.resize(variables, false);
  builder.loop_next(at);
  if (chance(50)) assign();
  if (test_last) builder.loop_test(at, builder.uniform_literal(0));
  builder.end_loop(at);
  has_value_ = before;
  has_value_.resize(builder.code.variables.size(), false);
}

void RandomCode::jump() {
  const LoopState& loop = loops_.back();
  const bool has_masks = builder.code.code[static_cast<std::size_t>(loop.at)].mask >= 0;
  if (loop.masked) {
    if (has_masks) builder.jump(chance(50) ? Kind::BreakMasked : Kind::ContinueMasked, loop.at);
    return;
  }
  // Within a branch of the host only, or the rest of the body is for nobody.
  const int at = builder.begin_if(Kind::If, {}, builder.uniform_literal(0));
  builder.jump(chance(50) ? Kind::Break : Kind::Continue, loop.at);
  builder.end_if(at);
}

}  // namespace pfman_tests
