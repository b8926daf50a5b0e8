// The control flow of one pixel. Masked jumps are jumps to it, and the stages of a surface a loop over the lights.
#include <algorithm>
#include <stdexcept>

#include "pixelflow/compiler/lifetime.h"

namespace pfman {

using ir::Instruction;
using Kind = ir::Instruction::Kind;

namespace {

class Flow {
 public:
  explicit Flow(const ir::Code& code) : code_(code.code), size_(static_cast<int>(code_.size())), next_(size_) {
    for (int i = 0; i < size_; ++i) {
      if (code_[i].kind == Kind::LoopNext) steps_.push_back({match(i), i});
      if (code_[i].kind == Kind::Break || code_[i].kind == Kind::LoopTest) exits_.push_back({match(i), i});
    }
  }

  std::vector<std::vector<int>> all() {
    for (int i = 0; i < size_; ++i) next_[i] = of(i);
    add_lights();
    return std::move(next_);
  }

 private:
  int match(int i) const {
    const int to = code_[i].match;
    if (to < 0 || to >= size_) throw std::logic_error("control flow: a marker without its counterpart");
    return to;
  }

  int behind_loop(int loop) const {
    const int end = match(loop);
    if (code_[loop].kind != Kind::Loop || code_[end].kind != Kind::EndLoop) {
      throw std::logic_error("control flow: a jump without its loop");
    }
    return end + 1;
  }

  int step_of(int loop) const {
    for (const auto& [of, step] : steps_) {
      if (of == loop) return step;
    }
    return match(loop);
  }

  std::vector<int> of(int i) const {
    const int straight = i + 1;
    switch (code_[i].kind) {
      case Kind::If:
      case Kind::IfMasked: {
        const int other = match(i);
        const bool has_else = code_[other].kind == Kind::Else || code_[other].kind == Kind::ElseMasked;
        const int elsewhere = has_else ? other + 1 : other;
        return elsewhere == straight ? std::vector{straight} : std::vector{straight, elsewhere};
      }
      case Kind::Else:
      case Kind::ElseMasked: return {match(i)};
      case Kind::LoopTest: {
        const int out = behind_loop(match(i));
        return out == straight ? std::vector{straight} : std::vector{straight, out};
      }
      case Kind::EndLoop: return {match(i)};
      case Kind::Break:
      case Kind::BreakMasked: return {behind_loop(match(i))};
      case Kind::Continue: return {step_of(match(i))};
      case Kind::ContinueMasked: {
        // The host goes on without the pixel, and may leave the loop before the iteration ends.
        const int loop = match(i), step = step_of(loop);
        const bool may_leave = std::any_of(exits_.begin(), exits_.end(), [&](const auto& exit) {
          return exit.first == loop && exit.second > i && exit.second < step;
        });
        return may_leave ? std::vector{step, behind_loop(loop)} : std::vector{step};
      }
      default: return {straight};
    }
  }

  /// The illuminance's body runs once for each light, or not at all.
  void add_lights() {
    int begin = -1, end = size_;
    for (int i = 0; i < size_; ++i) {
      if (code_[i].kind != Kind::Stage) continue;
      (code_[i].stage == 1 ? begin : end) = i;
    }
    if (begin < 0) return;
    for (int i = begin; i < end; ++i) {
      std::vector<int>& next = next_[i];
      if (std::find(next.begin(), next.end(), end) != next.end()) next.push_back(begin);
    }
    if (next_[begin].front() != end) next_[begin].push_back(end);
  }

  const std::vector<Instruction>& code_;
  int size_;
  std::vector<std::vector<int>> next_;
  std::vector<std::pair<int, int>> steps_;  ///< loop, its LoopNext
  std::vector<std::pair<int, int>> exits_;  ///< loop, where the host may leave it
};

}  // namespace

std::vector<std::vector<int>> successors(const ir::Code& code) { return Flow(code).all(); }

std::vector<std::vector<int>> predecessors(const std::vector<std::vector<int>>& successors) {
  const int size = static_cast<int>(successors.size());
  std::vector<std::vector<int>> before(size + 1);
  std::vector<bool> reached(size + 1, false);
  std::vector<int> open;
  const auto reach = [&](int start) {
    before[start].push_back(start - 1);
    reached[start] = true;
    open.push_back(start);
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      if (i == size) continue;
      for (const int next : successors[i]) {
        if (reached[next]) continue;
        reached[next] = true;
        open.push_back(next);
      }
    }
  };
  for (int i = 0; i <= size; ++i) {
    if (!reached[i]) reach(i);
  }
  for (int i = 0; i < size; ++i) {
    for (const int next : successors[i]) before[next].push_back(i);
  }
  for (std::vector<int>& from : before) std::sort(from.begin(), from.end());
  return before;
}

}  // namespace pfman
