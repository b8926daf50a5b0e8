#include "pixelflow/shading/stream_cache.h"

#include <algorithm>

namespace pfman {

const Streams& StreamCache::streams(const CompiledShader& shader, const GenerateInput& input, int user) {
  const std::scoped_lock lock(mutex_);
  for (Entry& entry : entries_) {
    if (entry.shader != &shader || entry.user != user) continue;
    if (entry.input == input) {
      ++reused_;
    } else {
      entry.streams = std::make_unique<Streams>(generate(shader, input));
      entry.input = input;
      ++made_;
    }
    return *entry.streams;
  }
  entries_.push_back({&shader, user, input, std::make_unique<Streams>(generate(shader, input))});
  ++made_;
  return *entries_.back().streams;
}

int StreamCache::made() const {
  const std::scoped_lock lock(mutex_);
  return made_;
}

int StreamCache::reused() const {
  const std::scoped_lock lock(mutex_);
  return reused_;
}

const SharedPhong& StreamCache::find_common_code(const CompiledShader& surface) {
  const auto known =
      std::find_if(codes_.begin(), codes_.end(), [&](const auto& code) { return code->serves(surface); });
  return known != codes_.end() ? **known : *codes_.emplace_back(std::make_unique<SharedPhong>(surface));
}

const SharedPhong& StreamCache::common_code(const CompiledShader& surface) {
  const std::scoped_lock lock(mutex_);
  return find_common_code(surface);
}

const CommonIllum& StreamCache::common_illum(const std::vector<Sharer>& sharers, int block) {
  const std::scoped_lock lock(mutex_);
  for (const CommonEntry& entry : common_) {
    if (entry.block == block && entry.sharers == sharers) return *entry.streams;
  }
  const SharedPhong& code = find_common_code(*sharers.at(0).shader);
  auto made = std::make_unique<CommonIllum>();
  std::vector<int> all;
  for (const Sharer& sharer : sharers) {
    all.insert(all.end(), sharer.ids.begin(), sharer.ids.end());
    made->to_block.push_back(code.copies(*sharer.shader, block, sharer.ids, false));
    made->from_block.push_back(code.copies(*sharer.shader, block, sharer.ids, true));
  }
  made->illum = code.illum(block, all);
  return *common_.emplace_back(CommonEntry{sharers, block, std::move(made)}).streams;
}

}  // namespace pfman
