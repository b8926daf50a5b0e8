// Random programs: functions, a surface, lights.
#include "tests/random_shaders/generator.h"

#include <algorithm>

#include "tests/random_shaders/context.h"

namespace random_shaders {
namespace {

using reference::kFloat;
using reference::signed_fixed;
using reference::unsigned_fixed;

std::string dimension(int rows) { return rows > 0 ? "[" + std::to_string(rows) + "]" : ""; }

Piece function_definition(Writer& writer, Context& context) {
  FunctionName function;
  function.text = writer.fresh("f");
  function.uniform = writer.random.one_in(4);
  function.is_void = !function.uniform && writer.random.one_in(5);
  function.result = random_type(writer.random);
  Context inner;
  inner.functions = context.functions;
  inner.mask = ++writer.masks;
  std::string head = (function.uniform ? "uniform " : "") + (function.is_void ? "void" : spelled(function.result)) +
                     " " + function.text + "(";
  const int count = writer.random.between(1, 3);
  for (int n = 0; n < count; ++n) {
    Name parameter;
    parameter.text = writer.fresh("p");
    parameter.number = random_type(writer.random);
    if (parameter.number.size > 32) parameter.number = signed_fixed(12, 6);
    parameter.uniform = function.uniform || writer.random.one_in(4);
    parameter.rows = writer.random.one_in(5) && !parameter.number.is_bool() ? 3 : 0;
    parameter.mask = inner.mask;
    const bool output = !parameter.uniform && writer.random.one_in(3);
    function.outputs.push_back(output);
    function.parameters.push_back(parameter);
    inner.names.push_back(parameter);
    head += (n == 0 ? "" : ", ") + std::string(output ? "output " : "") + (parameter.uniform ? "uniform " : "") +
            spelled(parameter.number) + " " + parameter.text + dimension(parameter.rows);
  }
  // One context from statement to statement, for the value that is returned.
  std::vector<Piece> body;
  body.push_back(declaration(writer, inner));
  for (Piece& piece : statements(writer, inner, writer.random.between(0, 3), 1)) body.push_back(std::move(piece));
  Piece value = value_for(writer, inner, function.result, 0, function.uniform);
  context.functions.push_back(function);
  if (function.is_void) return sequence({text(head + ") {\n"), sequence(std::move(body)), text("}\n")});
  return sequence({text(head + ") {\n"), sequence(std::move(body)), text("return "), std::move(value), text(";\n}\n")});
}

/// A parameter's text; the context gets its name.
std::string parameter(Writer& writer, Context& context, bool uniform) {
  Name name;
  name.text = writer.fresh(uniform ? "a" : "x");
  name.number = random_type(writer.random);
  name.uniform = uniform;
  name.writable = false;
  name.rows = writer.random.one_in(4) && !name.number.is_bool() ? writer.random.between(2, 4) : 0;
  if (!uniform && name.rows > 0 && name.number.size > 32) name.number = unsigned_fixed(8, 8);
  const bool unit = name.rows > 0 && (name.number.floating || name.number.is_signed) && writer.random.one_in(4);
  std::string initial = literal_for(writer.random, name.number);
  if (name.rows > 0) {
    initial = "{" + initial;
    for (int n = 1; n < name.rows; ++n) initial += ", " + literal_for(writer.random, name.number);
    initial += "}";
  }
  if (!uniform) writer.varying_bytes += (name.number.size + 7) / 8 * std::max(1, name.rows);
  context.names.push_back(name);
  return std::string(uniform ? "uniform " : "varying ") + (unit ? "unit " : "") + spelled(name.number) + " " +
         name.text + dimension(name.rows) + " = " + initial;
}

/// Eight bits that depend on all bits of the scalar: the raw integer's bytes, or a float's in a fixed-point type.
std::string mixed_in(Writer& writer, const std::string& hash, const std::string& name, const Number& number) {
  static const std::vector<int> kExponents = {-64, -30, 0, 8, 16, 32, 60, 100, 128};
  std::string value = name, made;
  Number type = number;
  if (number.floating) {
    type = signed_fixed(writer.random.one_in(2) ? 64 : 32, writer.random.of(kExponents));
    value = writer.fresh("t");
    made = spelled(type) + " " + value + " = " + name + ";\n";
  }
  // The raw integer: its exponent shifted away, which is no instruction.
  const auto shifted = [&](int right) {
    const int left = type.exponent - right;
    std::string amount = value;
    if (left > 64) amount = "(" + amount + " << 64)";
    if (left < -64) amount = "(" + amount + " >> 64)";
    const int rest = left > 64 ? left - 64 : left < -64 ? left + 64 : left;
    if (rest == 0) return amount;
    return "(" + amount + (rest > 0 ? " << " : " >> ") + std::to_string(rest > 0 ? rest : -rest) + ")";
  };
  for (int bit = 0; bit < type.size; bit += 8) {
    made += hash + " = " + hash + " * 3 + fixed<8,0>(" + shifted(bit) + ");\n";
  }
  return made;
}

/// What the surface has computed, in its colour.
std::vector<Piece> observation(Writer& writer, const Context& context) {
  std::vector<Piece> made;
  const std::string hash = writer.fresh("h");
  made.push_back(text("fixed<8,0> " + hash + " = 0;\n"));
  std::vector<std::string> parts;
  for (const Name& name : context.names) {
    if (!name.writable) continue;
    for (int n = 0; n < std::max(1, name.rows); ++n) {
      const std::string scalar = name.text + (name.rows > 0 ? "[" + std::to_string(n) + "]" : "");
      made.push_back(statement(mixed_in(writer, hash, scalar, name.number)));
      if (writer.random.one_in(4) && parts.size() < 2) {
        parts.push_back("px_shader_color[" + std::to_string(parts.size()) + "] = " + hash + " >> 8;\n");
        made.push_back(statement(parts.back()));
      }
    }
  }
  made.push_back(text("px_shader_color[2] = " + hash + " >> 8;\n"));
  return made;
}

Piece light_definition(Writer& writer, const Context& functions, const std::string& name, bool three, bool strict) {
  Context context;
  context.functions = functions.functions;
  context.mask = ++writer.masks;
  const int saved = writer.varying_bytes;
  writer.varying_bytes = 60;  // lights have less memory
  std::string head = "light " + name + "(";
  const int count = writer.random.between(0, 3);
  for (int n = 0; n < count; ++n) head += (n == 0 ? "" : ", ") + parameter(writer, context, true);
  head += ") {\n";
  std::vector<Piece> pieces{text(head)};
  pieces.push_back(declaration(writer, context));
  for (Piece& one : statements(writer, context, writer.random.between(0, 2), 1)) pieces.push_back(std::move(one));
  const int kind = writer.random.below(strict ? 4 : 5);
  const auto vector = [&](bool uniform) { return array_value(writer, context, {3, uniform, 1, false}).piece; };
  Context inside = context;
  if (kind <= 2) {
    inside.names.push_back({"px_light_ray", kFloat, 3, false, false, 0});
    inside.names.push_back({"px_light_distance", kFloat, 0, false, false, 0});
  }
  if (kind == 3) inside.names.push_back({"px_light_ray", kFloat, 3, false, false, 0});
  if (kind == 2) inside.mask = ++writer.masks;
  std::vector<Piece> body = statements(writer, inside, writer.random.between(0, 2), 1);
  std::vector<Piece> after;
  if (writer.random.one_in(2)) {
    Context colors = inside;
    colors.names.push_back({"px_light_color", unsigned_fixed(16, 12), 3, false, true, 0});
    after = statements(writer, colors, 2, 1);
  }
  static const char* const kColors[] = {"px_light_color", "px_light_ambient", "px_light_specular"};
  for (int n = 0; n < 3; ++n) {
    if (n > 0 && !three && writer.random.one_in(2)) continue;
    body.push_back(
        statement(std::string(kColors[n]) + " = $;\n", {array_value(writer, inside, {3, false, 2, false}).piece}));
  }
  for (Piece& one : after) body.push_back(std::move(one));
  Piece all = sequence(std::move(body));
  if (kind <= 1) {
    pieces.push_back(sequence({text("illuminate ("), vector(false), text(") {\n"), all, text("}\n")}));
  } else if (kind == 2) {
    // The cone is tested behind the body, which must not change what it is made of.
    Context kept = context;
    for (const Name& one : context.names) {
      if (one.writable) kept.busy.insert(one.text);
    }
    pieces.push_back(sequence({text("illuminate ("), vector(false), text(", "),
                               array_value(writer, kept, {3, false, 1, false}).piece, text(", "),
                               float_value(writer, kept, {0, true, 1, false}).piece, text(") {\n"), all, text("}\n")}));
  } else if (kind == 3) {
    pieces.push_back(sequence({text("solar ("), vector(false), text(", 0.0) {\n"), all, text("}\n")}));
  } else {
    pieces.push_back(all);
  }
  pieces.push_back(text("}\n"));
  writer.varying_bytes = saved;
  return sequence(std::move(pieces));
}

}  // namespace

Program random_program(std::uint64_t seed, const Settings& settings) {
  Random random(seed);
  Writer writer{random, settings};
  Context context;
  std::vector<Piece> pieces;
  const int functions = random.one_in(2) ? 0 : random.between(1, 2);
  for (int n = 0; n < functions; ++n) pieces.push_back(function_definition(writer, context));
  Program program;
  writer.varying_bytes = 0;
  const bool lit = random.one_in(5), alone = !lit && random.one_in(8);
  if (lit || alone) {
    const int lights = lit ? random.between(1, 2) : 1;
    for (int n = 0; n < lights; ++n) {
      program.lights.push_back(writer.fresh("l"));
      pieces.push_back(light_definition(writer, context, program.lights.back(), lit, false));
    }
  }
  if (alone) {
    program.text = sequence(std::move(pieces));
    return program;
  }
  program.surface = "s";
  context.mask = ++writer.masks;
  // Other types than the picture's are converted at the end.
  Number color = unsigned_fixed(8, 8);
  if (random.one_in(5)) color = random.one_in(2) ? kFloat : Number{false, random.one_in(2), random.between(4, 20), 12};
  std::string head = "surface s(output varying " + spelled(color) + " px_shader_color[3]";
  const int varying = random.between(1, 3), uniform = random.between(0, 3);
  for (int n = 0; n < varying; ++n) head += ", " + parameter(writer, context, false);
  for (int n = 0; n < uniform; ++n) head += ", " + parameter(writer, context, true);
  if (random.one_in(4)) {
    static const std::vector<std::string> kNormals = {"unit float", "float", "unit signed fixed<10,8>"};
    const int kind = random.below(3);
    head += ", varying transform_as_normal " + kNormals[static_cast<std::size_t>(kind)] + " px_material_normal[3]";
    context.names.push_back({"px_material_normal", kind == 2 ? signed_fixed(10, 8) : kFloat, 3, false, false, 0});
  }
  if (random.one_in(4)) {
    head += ", varying fixed<16,12> px_shader_texcoord[2]";
    context.names.push_back({"px_shader_texcoord", unsigned_fixed(16, 12), 2, false, false, 0});
  }
  if (random.one_in(6)) {
    head += ", uniform float px_shader_time";
    context.names.push_back({"px_shader_time", kFloat, 0, true, false, 0});
  }
  if (random.one_in(8)) {
    head += ", varying signed fixed<20,8> px_shader_position[3]";
    context.names.push_back({"px_shader_position", signed_fixed(20, 8), 3, false, false, 0});
  } else if (random.one_in(6)) {
    head += ", varying float px_shader_position[3]";
    context.names.push_back({"px_shader_position", kFloat, 3, false, false, 0});
  }
  if (random.one_in(6)) {
    head += ", varying float px_shader_view[3]";
    context.names.push_back({"px_shader_view", kFloat, 3, false, false, 0});
  }
  pieces.push_back(text(head + ") {\npx_shader_color = {0, 0, 0};\n"));
  const int declarations = random.between(1, 4);
  for (int n = 0; n < declarations; ++n) pieces.push_back(declaration(writer, context));
  writer.textures = random.one_in(4);
  const bool large = random.one_in(12);
  for (Piece& one :
       statements(writer, context, random.between(1, (large ? 2 : 1) * settings.statements), large ? 5 : 2)) {
    pieces.push_back(std::move(one));
  }
  if (lit) {
    Context inside = context;
    inside.names.push_back({"px_light_direction", signed_fixed(16, 14), 3, false, false, 0});
    for (const char* name : {"px_light_color", "px_light_ambient", "px_light_specular"}) {
      inside.names.push_back({name, unsigned_fixed(16, 12), 3, false, false, 0});
    }
    std::vector<Piece> body = statements(writer, inside, random.between(1, 4), 2);
    const bool cone = random.one_in(3) && head.find("px_shader_position") != std::string::npos;
    std::vector<Piece> parts{text("illuminance (")};
    if (cone) {
      inside.mask = ++writer.masks;
      body = statements(writer, inside, random.between(1, 3), 1);
      parts.push_back(text("px_shader_position, "));
      parts.push_back(array_value(writer, context, {3, false, 1, false}).piece);
      parts.push_back(text(", "));
      parts.push_back(float_value(writer, context, {0, true, 1, false}).piece);
    }
    parts.push_back(text(") {\n"));
    parts.push_back(sequence(std::move(body)));
    parts.push_back(text("}\n"));
    pieces.push_back(sequence(std::move(parts)));
    for (Piece& one : statements(writer, context, random.between(0, 2), 1)) pieces.push_back(std::move(one));
  }
  if (color == unsigned_fixed(8, 8)) {
    for (Piece& one : observation(writer, context)) pieces.push_back(std::move(one));
  } else {
    pieces.push_back(statement("px_shader_color = $;\n", {array_value(writer, context, {3, false, 2, false}).piece}));
  }
  pieces.push_back(text("}\n"));
  program.text = sequence(std::move(pieces));
  return program;
}

}  // namespace random_shaders
