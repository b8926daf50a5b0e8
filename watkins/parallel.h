// Work shared among threads. What is computed may not depend on who computes it, so the result is the same for any
// number of threads.
#pragma once

#include <functional>

namespace watkins {

/// Calls work(0) ... work(count - 1), each once, on up to `threads` threads; indices are begun in order. When calls
/// throw, no new ones are begun, and the exception of the lowest index is thrown on.
void for_each_index(int count, int threads, const std::function<void(int)>& work);

/// The threads that this machine runs at once; at least 1.
int machine_threads();

}  // namespace watkins
