// What a random program may refer to where it is being written.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/random_shaders/generator.h"
#include "tests/reference/number.h"

namespace random_shaders {

using reference::Number;

/// A variable, or a parameter.
struct Name {
  std::string text;
  Number number;
  int rows = 0;  ///< of an array; 0 for a scalar
  bool uniform = false;
  bool writable = true;
  int mask = 0;           ///< the masked block that it is declared in
  bool constant = false;  ///< `const`
};

struct FunctionName {
  std::string text;
  std::vector<Name> parameters;
  std::vector<bool> outputs;
  Number result;
  bool uniform = false;  ///< its result
  bool is_void = false;
  bool has_output() const {
    for (const bool output : outputs) {
      if (output) return true;
    }
    return false;
  }
};

/// An expression with the type that it has, from the bottom up.
struct Typed {
  Piece piece;
  Number number;
  int rows = 0;
  bool uniform = false;
};

struct Context {
  std::vector<Name> names;
  std::vector<FunctionName> functions;
  int mask = 0;                ///< the innermost masked block
  int loops = 0;               ///< around, in this function
  bool may_mask = false;       ///< the innermost loop may be left by single lanes
  bool ordinary = false;       ///< the innermost loop may be left by all
  bool varying_if = false;     ///< between here and the innermost loop
  bool effects = true;         ///< expressions may assign
  std::set<std::string> busy;  ///< assigned elsewhere in the same expression
};

/// Shared by expressions and statements.
struct Writer {
  Random& random;
  const Settings& settings;
  int names = 0;
  int masks = 0;
  int varying_bytes = 0;  ///< of everything declared so far
  bool textures = false;  ///< may be looked up

  std::string fresh(const std::string& letter) { return letter + std::to_string(names++); }
};

std::string spelled(const Number& number);  ///< "signed fixed<8,4>", "float", "int", "bool"
Number random_type(Random& random);
Number random_fixed(Random& random);
/// A literal that such a number can hold, or nearly.
std::string literal_for(Random& random, const Number& number);

// Expressions. `rows` is 0 for a scalar; `uniform` asks for a uniform one.
struct Wish {
  int rows = 0;
  bool uniform = false;
  int depth = 2;
  bool bounded = false;  ///< a demand from above will limit its size
};
Typed any_value(Writer& writer, const Context& context, const Wish& wish);
Typed fixed_value(Writer& writer, const Context& context, const Wish& wish);
Typed float_value(Writer& writer, const Context& context, const Wish& wish);
Typed condition(Writer& writer, const Context& context, bool uniform, int depth);
Typed array_value(Writer& writer, const Context& context, const Wish& wish);
/// An operation on an array, which stays fixed point if that is.
Typed fixed_array(Writer& writer, const Context& context, const Typed& array, const Wish& wish);
/// Something to assign to a variable of the type; sometimes a literal.
Piece value_for(Writer& writer, const Context& context, const Number& number, int rows, bool uniform);
/// A uniform index below `rows`.
Piece index_below(Writer& writer, const Context& context, int rows);
Typed cast(Writer& writer, Typed value, const Number& to, bool saturate);
Typed call(Writer& writer, const Context& context, const FunctionName& function);

/// Statements of a body, with what they declare taken out of the context again.
std::vector<Piece> statements(Writer& writer, Context context, int count, int depth);
/// One that declares: the context gets its name.
Piece declaration(Writer& writer, Context& context);

}  // namespace random_shaders
