// Streams in words: operations with addresses, cycles and the lines of the text that they come from.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "pixelflow/compiler/generate.h"

namespace pfman {

/// The text of a line of a shader's file, or nothing.
using LineText = std::function<std::string(std::uint32_t file, std::uint32_t line)>;

/// All stages. A line a step: cycles, operation, addresses in hexadecimal; above it the line of the text.
std::string listing(const Streams& streams, const Diagnostics& files, const LineText& line_text);

/// Cycles by stage, then by line of the text.
std::string cycles_text(const Streams& streams, const Diagnostics& files, const LineText& line_text);

/// How often each operation of the library stands in the streams, and "instructions" for bare ones; a lookup is
/// "lookup".
std::map<std::string, int> operation_counts(const Streams& streams);

}  // namespace pfman
