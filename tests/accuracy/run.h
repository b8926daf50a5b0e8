// Accuracy runs in chunks: each finished chunk is a line of a state file, and a run that is started again goes on after
// it.
#ifndef VSG_TESTS_ACCURACY_RUN_H_
#define VSG_TESTS_ACCURACY_RUN_H_

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cmodel/pixelflow/native/functions.h"
#include "tests/accuracy/comparison.h"

namespace accuracy {

// Arguments first, first + every, ... below first + span of a function of one argument; their order is judged when
// every = 1.
Tally run_arguments(const pixelflow::native::UnaryFunction& function, uint64_t first, uint64_t span, uint64_t every);
// Pairs of the random sequence, and the hard pairs.
Tally run_random_pairs(const pixelflow::native::BinaryFunction& function, uint64_t seed, uint64_t first,
                       uint64_t count);
Tally run_hard_pairs(const pixelflow::native::BinaryFunction& function);

// One piece of work. `key` names it in the state file.
struct Chunk {
  std::string function;
  std::string key;
  uint64_t inputs;
  std::function<Tally()> work;
};

std::vector<Chunk> chunks_of(const pixelflow::native::UnaryFunction& function, uint64_t every);
std::vector<Chunk> chunks_of(const pixelflow::native::BinaryFunction& function, uint64_t pairs, uint64_t seed);

// What a function returns for a fixed sample, as a hash: chunks of another version of it do not count.
std::string fingerprint(const pixelflow::native::UnaryFunction& function);
std::string fingerprint(const pixelflow::native::BinaryFunction& function);

// Of every function, by name.
std::map<std::string, std::string> fingerprints();

// Called after each chunk with the inputs that are done, those of this run among them, and all.
using Progress = std::function<void(uint64_t done, uint64_t done_now, uint64_t all)>;

// Runs what the state file does not hold yet, appends it, and returns the sums by function. An empty path keeps no
// state. Throws std::runtime_error when the file cannot be read or written, and what a chunk's work throws, once every
// thread has ended.
std::map<std::string, Tally> run(const std::vector<Chunk>& chunks, const std::string& state_file, unsigned threads,
                                 const Progress& progress);

}  // namespace accuracy

#endif
