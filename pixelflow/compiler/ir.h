// Shaders as straight code for the pixel processors: instructions on variables of pixel memory, between markers of
// control flow. Uniform values are trees that the host evaluates while it makes the stream.
//
// One list holds all stages. The same list serves every pass: lower() makes it, to_ssa() renames its variables so that
// each has one definition, merge_phis() joins them again where control flow meets, allocate() gives them addresses, and
// generate() walks it and appends operations to a stream.
//
// Control flow as one pixel sees it is what lifetimes go by: masked statements write only where the pixel's enable flag
// is set, so the other branch of a masked `if` is to a pixel as if it were not there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/compiler/tree.h"

namespace pfman::ir {

/// Bytes of pixel memory: `count` numbers of one type, one after another.
struct Variable {
  std::string name;  ///< "ss", "lit[1]", "t17"
  Scalar scalar;
  int count =
      1;  ///< more than one only where an index is not known before the stream is made, or bytes must be adjacent
  bool temporary = false;      ///< no variable of the source
  Location where;              ///< of its declaration, or of the expression
  std::optional<int> address;  ///< where it has to lie: parameters, communication area
  std::string source;          ///< the variable of the source that it is, or is an element of
  std::vector<int> versions;   ///< by to_ssa(): which of its definitions, from 1 on, the one at the start among them

  int bytes() const { return count * scalar.bytes(); }
};

/// The variable's name with its versions, as figure 10 writes it: "i2", "i2_3", "lit[1].2".
std::string label(const Variable& variable);

struct Operand {
  enum class Kind : std::uint8_t { None, Pixel, Uniform };
  Kind kind = Kind::None;
  bool is_signed = false;
  int variable = -1;  ///< Pixel
  int offset = 0;     ///< Pixel: first byte within the variable; a number is shifted right by whole bytes that way
  int bytes = 0;      ///< of the number: 1 to 8. Several numbers of Noise and Lookup follow one another
  int uniform = -1;   ///< Uniform: its value, uniforms[uniform]
  int index = -1;     ///< Pixel: uniforms[index], where not -1, times the bytes of an element is added to the offset
  int elements = 1;   ///< Pixel with index: how many elements the index may name

  explicit operator bool() const { return kind != Kind::None; }
};

struct Instruction {
  enum class Kind : std::uint8_t {
    Operate,  // d := code(a, b), with scale. A comparison leaves its result in K and, where there is a d, as 0 or 1 in
              // it
    And,      // d := a op b, byte by byte, all of the same length
    Or,
    Xor,
    Select,   // d := condition ? a : b, byte by byte
    Uniform,  // uniforms[uniform] is evaluated for its effect: Assign, Sequence
    // Control flow on the host.
    If,  // uniforms[uniform]
    Else,
    EndIf,
    Loop,
    LoopTest,  // leaves the loop unless uniforms[uniform]
    LoopNext,  // where `continue` goes; the step follows
    EndLoop,   // back to Loop
    Break,
    Continue,
    // Control flow by the enable flag, which enable_masks.h keeps. A Loop with such jumps has mask >= 0, and says
    // which: masked_breaks, masked_continues.
    IfMasked,  // condition
    ElseMasked,
    EndIfMasked,
    BreakMasked,
    ContinueMasked,
    Lookup,    // d := 3 or 4 bytes of texture uniforms[uniform]; a: two floats s, t, or three of a direction
               // (environment)
    External,  // external function; arguments
    Stage,     // the illuminance's body, or what follows it, begins here: stage
  };
  Kind kind = Kind::Operate;
  pixelflow::Code code = pixelflow::Code::Copy;
  int scale = 0;
  Operand d, a, b;
  Operand condition;  ///< Select, IfMasked: a bool variable, bit 0, read before anything is written; None: K as the
                      ///< comparison just before left it
  int uniform = -1;
  int match = -1;  ///< index of the matching marker: If -> Else or EndIf, Else -> EndIf, Loop <-> EndLoop, jumps,
                   ///< LoopTest, LoopNext -> Loop
  int mask = -1;
  bool masked_breaks = false, masked_continues = false;
  bool environment = false;
  bool shared = false;  ///< Lookup: together with those of other surfaces; stands in no construct
  int stage = 0;        ///< Stage: 1 illum, 2 post-illum
  const Function* external = nullptr;
  std::vector<Operand>
      arguments;  ///< External: in the parameters' order; outputs are definitions (and uses: they are copied in).
                  ///< Stage: what common code in the illuminance's place would read and leave
  Location where;

  // Filled by allocate().
  int work = 0;  ///< first byte of the operation's workspace
};

/// A φ-function, for --dump=ssa: d is one of the operands, by the way control flow came.
struct Phi {
  int before = 0;  ///< instruction in front of which it stands
  int d = 0;
  std::vector<int> operands;  ///< one for each of predecessors()' instructions
};

/// A parameter as the code knows it.
struct Parameter {
  const ShaderParameter* declared = nullptr;
  std::vector<int>
      variables;  ///< varying: the ir variables that hold it at the start, one an element, or one with a count
};

struct Code {
  Shader::Kind kind = Shader::Kind::Surface;
  std::string name;
  Location where;
  std::vector<Variable> variables;
  std::vector<Instruction> code;
  std::vector<NodePtr> uniforms;
  /// Variables of the uniform trees: those of the shader and copies of those of functions, one for each call.
  std::vector<std::unique_ptr<pfman::Variable>> uniform_variables;
  std::vector<Parameter> parameters;
  std::vector<int> color;       ///< surface: variables of px_shader_color's components at the end, in its declared type
  int mask_bits = 0;            ///< used at the same time, at most
  std::vector<int> mask_bytes;  ///< variables for mask bits 8 and up, eight each
  bool has_illuminance = false;
  bool needs_position = false;  ///< reads px_shader_position
  /// Surface of the flag shared_phong: types of the normal and the view, where common code can take the place of its
  /// illuminance; the Stage instructions then name what it reads and leaves.
  struct SharedPhong {
    Scalar normal, view;
  };
  std::optional<SharedPhong> shared_phong;
  std::vector<Phi> phis;  ///< between to_ssa() and merge_phis()
  // Pixel memory if every variable had bytes of its own, before anything is renamed; without parameters. By to_ssa().
  int source_bytes = 0;     ///< variables of the source
  int temporary_bytes = 0;  ///< the compiler's
};

/// One instruction a line, control flow indented: for --dump=ssa and listings.
std::string dump(const Code& code, const Diagnostics& diagnostics);

}  // namespace pfman::ir
