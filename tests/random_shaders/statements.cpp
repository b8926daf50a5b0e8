// Random statements.
#include <algorithm>

#include "tests/random_shaders/context.h"

namespace random_shaders {
namespace {

constexpr int kVaryingBytes = 120;  ///< of a program's variables

int bytes_of(const Number& number, int rows) { return (number.size + 7) / 8 * std::max(rows, 1); }

bool may_assign(const Context& context, const Name& name) {
  return name.writable && (!name.uniform || name.mask == context.mask);
}

std::vector<Name> targets(const Context& context) {
  std::vector<Name> found;
  for (const Name& name : context.names) {
    if (may_assign(context, name)) found.push_back(name);
  }
  return found;
}

Context masked(Writer& writer, Context context) {
  context.mask = ++writer.masks;
  context.varying_if = true;
  return context;
}

Piece block(Writer& writer, const Context& context, int count, int depth) {
  return sequence({text("{\n"), sequence(statements(writer, context, count, depth)), text("}\n")});
}

Piece assignment(Writer& writer, const Context& context) {
  const std::vector<Name> found = targets(context);
  if (found.empty()) return text("");
  const Name& name = writer.random.of(found);
  const bool element = name.rows > 0 && writer.random.one_in(2);
  const int rows = element ? 0 : name.rows;
  Piece target = element ? expression(name.text + "[$]", {index_below(writer, context, name.rows)}) : text(name.text);
  if (target.kind == Piece::Kind::Expression) target.kind = Piece::Kind::Text;
  if (rows == 0 && writer.random.one_in(6)) {
    return statement("$" + std::string(writer.random.one_in(2) ? "++" : "--") + ";\n", {target});
  }
  if (writer.random.one_in(3) && !name.number.is_bool()) {
    static const std::vector<std::string> kFloat = {"+=", "-=", "*=", "/=", "%="};
    static const std::vector<std::string> kFixed = {"+=", "-=", "*=", "/=", "%=", "+=", "-=", "*=", "<<=", ">>="};
    const std::string op = writer.random.of(name.number.floating || rows > 0 ? kFloat : kFixed);
    if (op == "<<=" || op == ">>=") {
      return statement("$ " + op + " " + std::to_string(writer.random.between(0, 5)) + ";\n", {target});
    }
    const Wish wish{0, name.uniform, writer.random.between(0, 2), false};
    Typed value = name.number.floating ? float_value(writer, context, wish) : any_value(writer, context, wish);
    if (!value.number.floating && (value.number.size > 32 || (op == "%=" && value.number.size > 8))) {
      value = cast(writer, std::move(value), reference::unsigned_fixed(7, 2), false);
    }
    return statement("$ " + op + " $;\n", {target, value.piece});
  }
  return statement("$ = $;\n", {target, value_for(writer, context, name.number, rows, name.uniform)});
}

/// An assignment, or an increment, as an operand.
Piece nested_assignment(Writer& writer, const Context& context) {
  std::vector<Name> found;
  for (const Name& name : targets(context)) {
    if (name.rows == 0) found.push_back(name);
  }
  if (found.size() < 2) return assignment(writer, context);
  const Name outer = writer.random.of(found), inner = writer.random.of(found);
  if (outer.text == inner.text || (outer.uniform && !inner.uniform) || outer.number.is_bool()) {
    return assignment(writer, context);
  }
  Context rest = context;
  rest.busy.insert(inner.text);
  rest.busy.insert(outer.text);
  const Piece value = value_for(writer, rest, inner.number, 0, inner.uniform);
  const Piece inside = writer.random.one_in(2) ? expression("(" + inner.text + " = $)", {value})
                                               : expression(inner.text + (writer.random.one_in(2) ? "++" : "--"));
  const Piece other = outer.number.floating ? float_value(writer, rest, {0, outer.uniform, 1, false}).piece
                                            : expression(std::to_string(writer.random.below(9)));
  return statement(outer.text + " = $ " + (writer.random.one_in(2) ? "+" : "*") + " $;\n", {inside, other});
}

Piece if_statement(Writer& writer, const Context& context, int depth) {
  const bool uniform = writer.random.one_in(3);
  const Typed chosen = condition(writer, context, uniform, writer.random.between(0, 2));
  const bool twice = writer.random.one_in(2);
  const auto branch = [&] {
    const Context inner = chosen.uniform ? context : masked(writer, context);
    return block(writer, inner, writer.random.between(1, 3), depth - 1);
  };
  Piece first = branch();
  if (!twice) return statement("if ($) $", {chosen.piece, std::move(first)});
  Piece second = branch();
  return statement("if ($) $else $", {chosen.piece, std::move(first), std::move(second)});
}

Piece leaving(Writer& writer, const Context& context) {
  const std::string word = writer.random.one_in(2) ? "break" : "continue";
  if (context.varying_if) return context.may_mask ? statement(word + ";\n") : text("");
  if (context.may_mask && writer.random.one_in(2)) {
    const Typed chosen = condition(writer, context, false, 1);
    if (!chosen.uniform) return statement("if ($) { " + word + "; }\n", {chosen.piece});
  }
  if (!context.ordinary) return text("");
  const Typed chosen = condition(writer, context, true, 1);
  return statement("if ($) " + word + ";\n", {chosen.piece});
}

Piece loop(Writer& writer, const Context& context, int depth) {
  const std::string counter = writer.fresh("i");
  const std::string count = std::to_string(writer.random.between(1, 4));
  Context inner = context;
  ++inner.loops;
  inner.names.push_back({counter, reference::signed_fixed(32, 0), 0, true, false, 0});
  inner.varying_if = false;
  inner.ordinary = true;
  const int kind = writer.random.below(4);
  inner.may_mask = kind < 2 && writer.random.one_in(2);
  if (inner.may_mask) inner.mask = ++writer.masks;
  Piece body = sequence(statements(writer, inner, writer.random.between(1, 4), depth - 1));
  const std::string declared = "uniform int " + counter + " = 0;\n";
  if (kind < 2) {
    const std::string head = "for (" + counter + " = 0; " + counter + " < " + count + "; " + counter + "++) {\n";
    return sequence({text(declared), statement(head + "$}\n", {std::move(body)})});
  }
  // The counter goes first, so that a `continue` goes on with the next number.
  if (kind == 2) {
    return sequence({text(declared), statement("while (" + counter + " < " + count + ") {\n" + counter + "++;\n$}\n",
                                               {std::move(body)})});
  }
  return sequence({text(declared), statement("do {\n" + counter + "++;\n$} while (" + counter + " < " + count + ");\n",
                                             {std::move(body)})});
}

Piece call_statement(Writer& writer, const Context& context) {
  if (context.functions.empty()) return assignment(writer, context);
  const FunctionName& function = writer.random.of(context.functions);
  std::set<std::string> outputs;
  std::vector<Piece> arguments(function.parameters.size());
  Context rest = context;
  for (std::size_t n = 0; n < function.parameters.size(); ++n) {
    if (!function.outputs[n]) continue;
    std::vector<Name> fitting;
    for (const Name& name : targets(context)) {
      const bool same = name.number.is_bool() == function.parameters[n].number.is_bool() &&
                        name.number.floating == function.parameters[n].number.floating;
      if (!name.uniform && same && name.rows == function.parameters[n].rows && !outputs.contains(name.text)) {
        fitting.push_back(name);
      }
    }
    if (fitting.empty()) return assignment(writer, context);
    const Name& name = writer.random.of(fitting);
    outputs.insert(name.text);
    rest.busy.insert(name.text);
    arguments[n] = text(name.text);
  }
  std::string form = function.text + "(";
  for (std::size_t n = 0; n < function.parameters.size(); ++n) {
    form += n == 0 ? "$" : ", $";
    const Name& parameter = function.parameters[n];
    if (!function.outputs[n]) {
      arguments[n] = value_for(writer, rest, parameter.number, parameter.rows, parameter.uniform);
    }
  }
  form += ")";
  std::vector<Name> fitting;
  for (const Name& name : targets(rest)) {
    if (name.rows == 0 && !function.is_void && !rest.busy.contains(name.text) && (!name.uniform || function.uniform) &&
        !(name.number.is_bool() && function.result.floating)) {
      fitting.push_back(name);
    }
  }
  if (fitting.empty() || writer.random.one_in(4)) return statement(form + ";\n", std::move(arguments));
  return statement(writer.random.of(fitting).text + " = " + form + ";\n", std::move(arguments));
}

}  // namespace

Piece declaration(Writer& writer, Context& context) {
  Name name;
  name.number = random_type(writer.random);
  name.uniform = writer.random.one_in(3);
  name.mask = context.mask;
  if (writer.random.one_in(4)) {
    name.rows = writer.random.between(2, 4);
    if (name.number.is_bool()) name.number = reference::unsigned_fixed(8, 8);
  }
  if (!name.uniform && writer.varying_bytes + bytes_of(name.number, name.rows) > kVaryingBytes) name.uniform = true;
  if (!name.uniform) writer.varying_bytes += bytes_of(name.number, name.rows);
  name.text = writer.fresh(name.uniform ? "u" : "v");
  const std::string dimension = name.rows > 0 ? "[" + std::to_string(name.rows) + "]" : "";
  if (name.uniform && name.rows == 0 && writer.random.one_in(4)) {
    name.writable = false;
    name.constant = true;
    context.names.push_back(name);
    return text("const " + spelled(name.number) + " " + name.text + " = " + literal_for(writer.random, name.number) +
                ";\n");
  }
  Piece value = value_for(writer, context, name.number, name.rows, name.uniform);
  context.names.push_back(name);
  return statement((name.uniform ? "uniform " : "") + spelled(name.number) + " " + name.text + dimension + " = $;\n",
                   {std::move(value)});
}

/// A matrix, whose rows then are arrays.
Piece matrix_declaration(Writer& writer, Context& context) {
  const Number number = writer.random.one_in(2) ? reference::kFloat : reference::signed_fixed(12, 5);
  const bool uniform = writer.random.one_in(2) || writer.varying_bytes + 16 > kVaryingBytes;
  if (!uniform) writer.varying_bytes += 4 * bytes_of(number, 1);
  const std::string name = writer.fresh("m");
  std::vector<Piece> elements;
  for (int n = 0; n < 4; ++n) elements.push_back(any_value(writer, context, {0, uniform, 1, false}).piece);
  for (const char* row : {"[0]", "[1]"}) context.names.push_back({name + row, number, 2, uniform, true, context.mask});
  return statement((uniform ? "uniform " : "") + spelled(number) + " " + name + "[2][2] = {{$, $}, {$, $}};\n",
                   std::move(elements));
}

std::vector<Piece> statements(Writer& writer, Context context, int count, int depth) {
  std::vector<Piece> made;
  for (int n = 0; n < count; ++n) {
    const int kind = writer.random.below(depth > 0 ? 14 : 9);
    if (kind <= 1) {
      const bool matrix = writer.random.one_in(12);
      made.push_back(matrix ? matrix_declaration(writer, context) : declaration(writer, context));
    } else if (kind == 2) {
      made.push_back(nested_assignment(writer, context));
    } else if (kind == 3 && context.loops > 0) {
      made.push_back(leaving(writer, context));
    } else if (kind == 4) {
      made.push_back(call_statement(writer, context));
    } else if (kind <= 8) {
      made.push_back(assignment(writer, context));
    } else if (kind <= 11) {
      made.push_back(if_statement(writer, context, depth));
    } else if (kind == 12) {
      made.push_back(block(writer, context, 2, depth - 1));
    } else {
      made.push_back(context.loops < 2 ? loop(writer, context, depth) : assignment(writer, context));
    }
  }
  return made;
}

}  // namespace random_shaders
