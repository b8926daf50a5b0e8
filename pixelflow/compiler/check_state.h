// What the checker knows of expressions, names and what stands around a statement; for check*.cpp alone.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "pixelflow/compiler/tree.h"
#include "pixelflow/language/ast.h"

namespace pfman {

/// An expression, which has no type of its own yet where it consists of literals: they take that of what they meet.
struct Value {
  enum class Kind : std::uint8_t {
    Mistake,  // has been reported; silences what it is part of
    Typed,    // node
    Literal,  // number; integer unless real
    Choice,   // node ? parts[0] : parts[1]
    Array,    // parts
    Library,  // a function of the library, name, of parts
  };
  Kind kind = Kind::Mistake;
  Location where;
  NodePtr node;
  bool real = false;  ///< of an untyped one: a real literal is in it
  double number = 0;
  std::int64_t integer = 0;
  std::string name;
  std::vector<Value> parts;
  Type shape;  ///< of an untyped one; the scalar is open

  static Value typed(NodePtr node);
  static Value whole(std::int64_t integer, Location where);
  static Value of(double number, Location where);
  bool mistake() const { return kind == Kind::Mistake; }
  bool untyped() const { return kind != Kind::Mistake && kind != Kind::Typed; }
  const Type& type() const { return kind == Kind::Typed ? node->type : shape; }
  std::string spelled() const;  ///< its type, as messages name it
};
using Values = std::vector<Value>;

std::string counted(std::size_t count, const std::string& what);  ///< "1 argument", "2 arguments"

/// A name and what may be done with it.
struct Symbol {
  Variable* variable = nullptr;
  const char* protection = nullptr;  ///< why it may not be assigned, or null
  int masks = 0;                     ///< varying conditions around its declaration
  std::size_t loops = 0;             ///< loops around its declaration
  bool used = false;
  bool shared = false;  ///< common code of several shaders may assign it
};

/// An assignment to a uniform variable.
struct Assigned {
  std::string name;
  Location where;
};
/// A loop that is being checked.
struct CheckedLoop {
  int masks = 0;  ///< varying conditions around it
  bool masked_breaks = false, masked_continues = false;
  std::vector<Assigned> assigned;  ///< uniform variables from outside, in the body
};
/// What is around a statement.
struct Surroundings {
  const ast::Definition* definition = nullptr;
  Shader* shader = nullptr;
  Function* function = nullptr;
  int masks = 0;
  std::vector<CheckedLoop> loops;
  bool in_illuminance = false, in_illuminate = false, in_solar = false;
  bool illuminance_seen = false, source_seen = false;
  std::set<std::string> colors_named, colors_assigned;
  Variable *ray = nullptr, *distance = nullptr;
  Variable* position = nullptr;  ///< of the surface point, as it comes in
};

}  // namespace pfman
