// Appends to a stream of programs: operations of the microcode library, and bare instructions for what has none.
#pragma once

#include <utility>

#include "pixelflow/compiler/generate.h"
#include "pixelflow/microcode/library.h"

namespace pfman {

class StreamWriter {
 public:
  /// Appends to what the stream holds.
  explicit StreamWriter(Stream& stream) : stream_(stream) {
    if (stream_.parts.empty()) stream_.parts.emplace_back();
  }

  /// The place in the text that what follows comes from.
  void at(Location where) { where_ = where; }

  /// Leaves out what changes nothing: a copy onto itself, a factor of one.
  void operate(pixelflow::Operation operation);

  template <typename Write>
  void bare(Write&& write) {
    pixelflow::append_instructions(program(), std::forward<Write>(write));
    close_step();
  }

  /// A function of C++ appends what it likes.
  template <typename Write>
  void foreign(Write&& write) {
    write(program());
    stream_.parts.back().places.resize(program().steps.size(), where_);
  }

  // d, byte by byte from the lowest; d is an operand or apart from it. All have d's length.
  void logic(pixelflow::Alu function, const pixelflow::Operand& d, const pixelflow::Operand& a,
             const pixelflow::Operand& b);
  /// d := K ? a : b.
  void select(const pixelflow::Operand& d, const pixelflow::Operand& a, const pixelflow::Operand& b);

  /// Ends the program with a lookup: sends the first `bytes` bytes from `coordinates` on.
  void send(const Lookup& lookup, int coordinates, int bytes);
  /// Ends the program with a shared lookup.
  void share(const Lookup& lookup);
  /// The lookup's answer.
  void receive(int address, int bytes);

 private:
  pixelflow::Program& program() { return stream_.parts.back().program; }
  /// Joins the step just written to the one before it where neither is an operation and both come from one place.
  void close_step();

  Stream& stream_;
  Location where_;
};

}  // namespace pfman
