// The typed tree: a unit after all names, types and rates are resolved and every conversion stands in it.
//
// Made by check(), sized by size_fixed(), taken apart by lower(); its uniform expressions are evaluated on the host.
// The functions of the library are already written out in terms of the operators below, arguments that are used more
// than once in hidden variables; every operator works on scalars, or element by element on arrays of one shape with
// scalars repeated. Written out as well are the cone of an illuminance (an `if` around its body), illuminate and solar
// (assignments to px_light_ray, px_light_distance and px_light_direction, the cone as an `if` that blackens the
// colours), what a light that does not assign a colour leaves, the normalisation of `unit` parameters, and
// px_shader_view from px_shader_position: these are ordinary statements here.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cmodel/pixelflow/operation.h"
#include "pixelflow/compiler/types.h"
#include "pixelflow/language/ast.h"

namespace pfman {

struct Variable {
  enum class Role : std::uint8_t {
    Local,
    Parameter,          ///< of a shader
    FunctionParameter,  ///< of a function
    Constant,           ///< `const`: initialised where it is declared
    Light,              ///< px_light_direction, _color, _ambient, _specular: the communication area
    Hidden,             ///< made by the compiler
  };
  std::string name;
  Type type;
  Role role = Role::Local;
  Location where;
  bool output = false;
  bool unit = false;
  ast::Transform transform = ast::Transform::None;
  int id = 0;  ///< unique in the unit
};

struct Function;

struct Node {
  enum class Op : std::uint8_t {
    Literal,   // raw: of a fixed number its raw integer, sign-extended; of a float its 32 bits
    Variable,  // variable
    Element,   // operands[0] an array (Variable, or Element of two dimensions), operands[1] the uniform index
    Array,     // one scalar (or row) each
    // Arithmetic: fixed or float by the operands' type, which is then the same kind for both.
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,  // floored
    ShiftLeft,  // fixed by a uniform count: operands[1]
    ShiftRight,
    Complement,  // fixed, one exponent
    BitAnd,
    BitOr,
    BitXor,
    // Conditions: type bool. Operands of comparisons are both float or both fixed; arrays give one bool (Equal,
    // NotEqual).
    Less,
    LessEqual,
    Equal,
    NotEqual,
    Not,  // of a bool
    And,
    Or,      // of bools; uniform ones stop early
    Select,  // operands[0] ? operands[1] : operands[2]; the condition is a bool, both others have the node's type
    // Conversions: a fixed source is a root of the sizing passes.
    Convert,   // to type.scalar: wraps fixed to fixed, saturates float to fixed; to bool: value != 0
    Saturate,  // to type.scalar, fixed; saturates
    // Primitives of the library.
    Abs,
    Floor,
    Ceil,
    Round,
    SquareRoot,
    Math,         // math: a function of floats, of one or two operands
    Noise,        // operands: one to three scalars, all float, or all S(16,8) giving U(16,16)
    CellNoise,    // operands: one to three scalars, float or fixed; U(8,8)
    Turbulence,   // operands[0] float[3], operands[1] uniform int
    Texture,      // operands: uniform id, s, t; U(8,8) array of 3 or 4
    Environment,  // operands: uniform id, float[3]; U(8,8)[3]
    // Effects.
    Assign,    // operands[0] (Variable or Element) := operands[1]; the value is the new one
    Sequence,  // operands in order; the value is the last one's
    Postfix,   // operands[0] a Variable or Element, operands[1] its new value; the value is the old one
    Call,      // function, operands in the order of its parameters; output arguments are Variables or Elements
  };
  Op op;
  Type type;     ///< after size_fixed(): of a fixed node, what is computed and stored
  Scalar exact;  ///< of a fixed node: the bottom-up type
  Location where;
  std::vector<std::unique_ptr<Node>> operands;
  std::uint64_t raw = 0;
  Variable* variable = nullptr;
  pixelflow::Code math = pixelflow::Code::Sin;
  const Function* function = nullptr;
  /// Set by check(): a result of the library, of which every fraction bit is computed.
  bool precise = false;
  /// Texture: the lookup that shared_texture stands for.
  bool shared = false;
  /// Set by size_fixed(): the node is only computed to be added or subtracted (keeps guard bits).
  bool under = false;
};
using NodePtr = std::unique_ptr<Node>;

struct Statement {
  enum class Kind : std::uint8_t {
    Evaluate,  // expression; a declaration with an initial value is an Assign here
    Declare,   // variable comes into being, without a value
    Block,     // body
    If,        // expression a bool; body[0], body[1] if there is an else. Masked where the expression varies
    Loop,      // expression uniform or null (true), tested first unless test_last; step a Block or null; body[0]
    Break,     // masked or not
    Continue,
    Illuminance,  // body[0]; top level of a surface, once at most
  };
  Kind kind;
  Location where;
  NodePtr expression;
  Variable* variable = nullptr;
  std::vector<std::unique_ptr<Statement>> body;
  std::unique_ptr<Statement> step;
  bool test_last = false;
  bool masked = false;         ///< Break, Continue: under a varying condition within their loop
  bool masked_breaks = false;  ///< Loop: holds a masked break of its own
  bool masked_continues = false;
};
using StatementPtr = std::unique_ptr<Statement>;

struct Function {
  std::string name;
  Location where;
  Type result;
  std::vector<Variable*> parameters;
  std::vector<StatementPtr> body;  ///< without the return
  NodePtr value;                   ///< what it returns; null for void
  bool is_external = false;
  std::string linkage;  ///< external: the name under which C++ registers it
};

struct ShaderParameter {
  Variable* variable = nullptr;
  NodePtr initial;  ///< uniform constant expression; null for px_ parameters
  bool used = false;
};

struct Shader {
  enum class Kind : std::uint8_t { Surface, Light };
  Kind kind = Kind::Surface;
  std::string name;
  Location where;
  std::vector<ShaderParameter> parameters;
  std::vector<StatementPtr> body;
  bool shared_phong = false;
  bool shared_texture = false;
  bool three_colours = false;  ///< surface: reads ambient or specular of lights. Light: assigns all three
};

/// A checked unit. Constants are ordinary variables of role Constant whose value is `constants`' Assign node.
struct Tree {
  std::vector<std::unique_ptr<Variable>> variables;  ///< all that nodes refer to
  std::vector<NodePtr> constants;                    ///< Assign nodes of unit-wide constants, in order
  std::vector<std::unique_ptr<Function>> functions;  ///< each after those that it calls
  std::vector<std::unique_ptr<Shader>> shaders;
};

NodePtr clone(const Node& node);
NodePtr clone_alone(const Node& node);  ///< without operands

/// For --dump=types: the tree as indented text, every node with its type and rate, fixed ones with bottom-up and final
/// sizes.
std::string dump(const Tree& tree);

}  // namespace pfman
