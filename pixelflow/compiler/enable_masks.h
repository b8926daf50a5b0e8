// The enable flag under varying conditions (Olano and Lastra 1998, sections 5.1 and 6.1.4). An element has one flag;
// what it was outside of a construct is kept in bits of memory.
//
// A region is a piece of the stream that a fixed set of elements executes: a stage, a branch, the body of a loop with
// masked jumps. It has a bit that is set in just these elements, if there is anything inside of it after which the flag
// must be restored. Four things keep the streams short:
//  - Under the flag all mask bits are known when the stream is made: those of the regions around are set, the others
//    clear. A whole byte is stored, none is read.
//  - A masked jump clears the bits of all regions that it leaves. The ends of these regions load the flag from their
//    bits as always and need not ask which elements have left.
//  - The flag is loaded when something is executed under it, not where a region ends.
//  - Bits that are no longer needed are cleared by the next store to their byte, or before another region of the same
//    parent could take them for its own.
#pragma once

#include <vector>

#include "pixelflow/compiler/ir.h"
#include "pixelflow/compiler/stream_writer.h"

namespace pfman {

/// E := the element's shader ID is one of these; 1 where there are none. Needs Z and K.
void enable_ids(pixelflow::Assembler& out, const std::vector<int>& ids);

class EnableMasks {
 public:
  /// `deep`: addresses of the mask bytes from bit 8 on, in the shader's own memory. `ids`: the shader's pixels, all
  /// where there are none.
  EnableMasks(StreamWriter& out, const ir::Code& code, std::vector<int> deep, std::vector<int> ids);

  /// The code from `first` up to `last` begins: the flag is set in the shader's pixels.
  void begin_stage(int first, int last);
  /// Afterwards the shared mask byte is zero in every element.
  void end_stage();

  /// The same within another stream: the flag is what it is, and will be again. Of the shared mask byte its elements
  /// have `known`, all elements zeros from `free_bit` on.
  void begin_call(int first, int last, int known, int free_bit);
  void end_call();

  /// The shared mask byte of the flag's elements as begin_call() takes it: nothing is left in the free bits.
  struct SharedByte {
    int known, free_bit;
  };
  SharedByte settle();

  /// False where no element can be enabled: what would be executed is left out.
  bool reachable() const { return !regions_.back().dead; }
  /// To be called before something is executed: the flag becomes that of the region.
  void prepare();

  // Where these stand in the code; K or the byte at `condition` (bit 0) is the condition.
  void begin_if(int at, int condition);
  void begin_else();
  void end_if();
  void begin_loop(int at);
  void next_iteration();
  void end_loop();
  void jump(int loop, bool leaves);

 private:
  struct Region {
    int bit = -1;      ///< set in its elements; -1: none is needed
    int free_bit = 0;  ///< the first one that regions inside may take
    bool dead = false;
    std::vector<int> known;  ///< the mask bytes of its elements, dirt apart
    std::vector<bool> dirt;  ///< bytes in which some of its elements have bits from `free_bit` on
  };
  struct Construct {
    int at = 0;  ///< in the code
    Region branch_else;
    bool has_else = false;
    bool stored = false;  ///< an `if` that wrote mask bytes
    bool else_restores = false;
    // Of a loop.
    bool restores = false;    ///< elements that left an iteration come back in the next
    int loop_bit = -1;        ///< elements that are still in the loop
    std::size_t regions = 0;  ///< how many there were outside
  };

  void begin(Region stage, int first, int last, bool everywhere);
  bool restores_within(int first, int last) const;
  int bits_within(int first, int last) const;
  Region inner(const Region& outer, int bit, int free_bit) const;
  int set_bit(Region& region, int bit) const;
  void load_enable(pixelflow::Assembler& out, const Region& region) const;
  void store_known(const Region& target, pixelflow::Gate gate = pixelflow::Gate::E);
  int address(std::size_t byte) const;
  bool dirty() const;

  StreamWriter& out_;
  const ir::Code& code_;
  std::vector<int> deep_;
  std::vector<int> ids_;
  int base_bit_ = -1;  ///< of the stage's own region, in the shared byte; -1: none
  std::vector<Region> regions_;
  std::vector<Construct> constructs_;
  bool pending_ = false;       ///< the flag is not yet that of the last region
  bool pending_next_ = false;  ///< a loop's next iteration has begun
};

}  // namespace pfman
