#include "tests/accuracy/run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "tests/accuracy/hard_pairs.h"
#include "tests/accuracy/oracle.h"

namespace accuracy {
namespace {

using pixelflow::native::BinaryFunction;
using pixelflow::native::UnaryFunction;

constexpr uint64_t kAll = uint64_t{1} << 32;
constexpr uint64_t kChunk = uint64_t{1} << 24;
constexpr std::size_t kBlock = 4096;

struct Block {
  std::vector<uint32_t> x = std::vector<uint32_t>(kBlock + 1);
  std::vector<uint32_t> result = std::vector<uint32_t>(kBlock + 1);
  std::vector<double> value = std::vector<double>(kBlock + 1);
  std::vector<uint32_t> rounded = std::vector<uint32_t>(kBlock + 1);
};

Tally run_pairs(const BinaryFunction& function, const Pairs& pairs) {
  Oracle oracle(function.name);
  Tally tally;
  Block block;
  for (std::size_t first = 0; first < pairs.x.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, pairs.x.size() - first);
    const uint32_t* x = pairs.x.data() + first;
    const uint32_t* y = pairs.y.data() + first;
    function.batch(x, y, block.result.data(), count);
    oracle.values(x, y, block.value.data(), block.rounded.data(), count);
    tally.add(compare(x, y, block.result.data(), block.value.data(), block.rounded.data(), count, false));
  }
  return tally;
}

// FNV-1a.
std::string hash_of(const std::vector<uint32_t>& words) {
  uint64_t hash = 0xCBF29CE484222325u;
  for (const uint32_t word : words) hash = (hash ^ word) * 0x100000001B3u;
  return std::to_string(hash);
}

std::map<std::string, Tally> read_state(const std::string& path) {
  std::map<std::string, Tally> done;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_discarded()) continue;  // a line that was being written when the run was stopped
    done[json.at("chunk").get<std::string>()] = tally_from(json);
  }
  return done;
}

}  // namespace

Tally run_arguments(const UnaryFunction& function, uint64_t first, uint64_t span, uint64_t every) {
  Oracle oracle(function.name);
  Tally tally;
  Block block;
  const uint64_t end = first + span;
  for (uint64_t next = first; next < end;) {
    // With every argument, a block begins with the last one of the block before, whose order is judged with it.
    const bool overlap = every == 1 && next != first;
    const uint64_t start = overlap ? next - 1 : next;
    std::size_t count = 0;
    for (uint64_t x = start; x < end && count < kBlock + (overlap ? 1u : 0u); x += every) {
      block.x[count++] = static_cast<uint32_t>(x);
    }
    function.batch(block.x.data(), block.result.data(), count);
    oracle.values(block.x.data(), nullptr, block.value.data(), block.rounded.data(), count);
    Tally part = compare(block.x.data(), nullptr, block.result.data(), block.value.data(), block.rounded.data(), count,
                         every == 1);
    if (overlap) {  // counted already
      const bool equal = block.result[0] == block.rounded[0];
      const Tally again = equal ? Tally{}
                                : compare(block.x.data(), nullptr, block.result.data(), block.value.data(),
                                          block.rounded.data(), 1, false);
      part.inputs -= 1;
      part.equal -= equal ? 1 : 0;
      part.one_off -= again.one_off;
      part.further -= again.further;
      part.special -= again.special;
    }
    tally.add(part);
    next = start + count * every;
  }
  return tally;
}

Tally run_random_pairs(const BinaryFunction& function, uint64_t seed, uint64_t first, uint64_t count) {
  Tally tally;
  constexpr uint64_t kPart = 1 << 16;
  for (uint64_t part = 0; part < count; part += kPart) {
    tally.add(run_pairs(function, random_pairs(function.name, seed, first + part, std::min(kPart, count - part))));
  }
  return tally;
}

Tally run_hard_pairs(const BinaryFunction& function) { return run_pairs(function, hard_pairs()); }

std::string fingerprint(const UnaryFunction& function) {
  std::vector<uint32_t> x;
  for (uint64_t next = 0; next < kAll; next += 65537) x.push_back(static_cast<uint32_t>(next));
  std::vector<uint32_t> result(x.size());
  function.batch(x.data(), result.data(), x.size());
  return hash_of(result);
}

std::string fingerprint(const BinaryFunction& function) {
  const Pairs hard = hard_pairs();
  std::vector<uint32_t> result(hard.x.size());
  function.batch(hard.x.data(), hard.y.data(), result.data(), result.size());
  const Pairs random = random_pairs(function.name, 1, 0, 1 << 16);
  std::vector<uint32_t> more(random.x.size());
  function.batch(random.x.data(), random.y.data(), more.data(), more.size());
  result.insert(result.end(), more.begin(), more.end());
  return hash_of(result);
}

std::map<std::string, std::string> fingerprints() {
  std::map<std::string, std::string> all;
  for (const UnaryFunction& function : pixelflow::native::unary_functions()) {
    all[std::string(function.name)] = fingerprint(function);
  }
  for (const BinaryFunction& function : pixelflow::native::binary_functions()) {
    all[std::string(function.name)] = fingerprint(function);
  }
  return all;
}

std::vector<Chunk> chunks_of(const UnaryFunction& function, uint64_t every) {
  std::vector<Chunk> chunks;
  const std::string version = fingerprint(function);
  const uint64_t span = every == 1 ? kChunk : kAll;
  for (uint64_t first = 0; first < kAll; first += span) {
    const std::string key = std::string(function.name) + " " + version + " every " + std::to_string(every) + " from " +
                            std::to_string(first);
    chunks.push_back({std::string(function.name), key, (span + every - 1) / every,
                      [&function, first, span, every] { return run_arguments(function, first, span, every); }});
  }
  return chunks;
}

std::vector<Chunk> chunks_of(const BinaryFunction& function, uint64_t pairs, uint64_t seed) {
  std::vector<Chunk> chunks;
  const std::string name(function.name);
  const std::string version = fingerprint(function);
  chunks.push_back(
      {name, name + " " + version + " hard", hard_pairs().x.size(), [&function] { return run_hard_pairs(function); }});
  constexpr uint64_t kPairs = 1 << 22;
  for (uint64_t first = 0; first < pairs; first += kPairs) {
    const uint64_t count = std::min(kPairs, pairs - first);
    const std::string key = name + " " + version + " seed " + std::to_string(seed) + " from " + std::to_string(first) +
                            " count " + std::to_string(count);
    chunks.push_back(
        {name, key, count, [&function, seed, first, count] { return run_random_pairs(function, seed, first, count); }});
  }
  return chunks;
}

std::map<std::string, Tally> run(const std::vector<Chunk>& chunks, const std::string& state_file, unsigned threads,
                                 const Progress& progress) {
  const std::map<std::string, Tally> known =
      state_file.empty() ? std::map<std::string, Tally>() : read_state(state_file);
  std::ofstream state;
  if (!state_file.empty()) {
    state.open(state_file, std::ios::app);
    if (!state) throw std::runtime_error(state_file + ": cannot be written");
  }
  std::map<std::string, Tally> sums;
  std::vector<const Chunk*> left;
  uint64_t all = 0;
  uint64_t done = 0;
  for (const Chunk& chunk : chunks) {
    all += chunk.inputs;
    const auto found = known.find(chunk.key);
    if (found == known.end()) {
      left.push_back(&chunk);
    } else {
      sums[chunk.function].add(found->second);
      done += chunk.inputs;
    }
  }
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  bool failed = false;
  uint64_t done_now = 0;
  std::exception_ptr thrown;
  const auto work = [&] {
    while (true) {
      const std::size_t mine = next++;
      if (mine >= left.size()) return;
      const Chunk& chunk = *left[mine];
      const Tally tally = chunk.work();
      const std::lock_guard lock(mutex);
      sums[chunk.function].add(tally);
      if (state.is_open()) {
        nlohmann::json line = to_json(tally);
        line["chunk"] = chunk.key;
        state << line.dump() << '\n' << std::flush;
        failed |= !state;
      }
      done += chunk.inputs;
      done_now += chunk.inputs;
      if (progress) progress(done, done_now, all);
    }
  };
  // No exception may leave a thread; the first one stops them all.
  const auto worker = [&] {
    try {
      work();
    } catch (...) {
      next = left.size();
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned i = 1; i < threads; ++i) pool.emplace_back(worker);
  worker();
  pool.clear();
  if (thrown) std::rethrow_exception(thrown);
  if (failed) throw std::runtime_error(state_file + ": cannot be written");
  return sums;
}

}  // namespace accuracy
