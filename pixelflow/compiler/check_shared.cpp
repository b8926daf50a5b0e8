// Surfaces that share their lighting or texturing with others (Olano and Lastra 1998, section 6.1.5.3): the shader sets
// the common code's inputs and reads its results.
//
// #pragma pfman shared_phong: inputs px_magic_kd[3], px_magic_ks[3], px_magic_exp, results px_magic_diffuse[3],
// px_magic_highlight[3], all varying floats. #pragma pfman shared_texture: inputs uniform int px_magic_texid and
// px_magic_texcoord[2], result fixed<8,8> px_magic_texel[4]. The common code, below in the language itself, stands
// before the first statement of the surface's own block in which a result is named, that of shared_texture also before
// an illuminance in front of it; where no result is named it does not run.
#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "pixelflow/compiler/checker.h"
#include "pixelflow/language/parser.h"

namespace pfman {
namespace {

const std::string kPhong = "shared_phong", kTexture = "shared_texture";

constexpr const char* kPhongCode = R"(
void shared_phong()
{
    px_magic_diffuse = { 0, 0, 0 };
    px_magic_highlight = { 0, 0, 0 };
    illuminance () {
        float facing = dot(px_material_normal, px_light_direction);
        if (facing > 0) {
            px_magic_diffuse += px_magic_kd * facing * px_light_color;
            float halfway[3] = normalize(px_light_direction - px_shader_view);
            float shine = pow(max(dot(px_material_normal, halfway), 0), px_magic_exp);
            px_magic_highlight += px_magic_ks * shine * px_light_color;
        }
    }
}
)";

constexpr const char* kTextureCode = R"(
void shared_texture()
{
    px_magic_texel = texture4(px_magic_texid, px_magic_texcoord[0], px_magic_texcoord[1]);
}
)";

void move_to(ast::Expression& expression, Location where) {
  expression.where = where;
  for (const auto& operand : expression.operands) move_to(*operand, where);
}

void move_to(ast::Statement& statement, Location where) {
  statement.where = where;
  for (const auto& expression : statement.expressions) {
    if (expression) move_to(*expression, where);
  }
  for (ast::Declarator& declarator : statement.declarators) {
    declarator.where = where;
    if (declarator.initial) move_to(*declarator.initial, where);
  }
  for (const auto& inner : statement.body) move_to(*inner, where);
}

ast::StatementPtr common_code(const char* text, Location where) {
  Diagnostics mistakes;
  ast::Unit unit = parse_text(text, "common code", {}, mistakes);
  if (mistakes.has_errors()) throw std::logic_error(mistakes.text());
  move_to(*unit.definitions.at(0).body, where);
  return std::move(unit.definitions[0].body);
}

/// Whether one of the names stands in it; and the last place in a statement.
class Search {
 public:
  explicit Search(std::vector<std::string> names = {}) : names_(std::move(names)) {}

  void look(const ast::Expression& expression) {
    last_ = std::max(last_, expression.where, before);
    const bool named = expression.kind == ast::Expression::Kind::Name &&
                       std::find(names_.begin(), names_.end(), expression.name) != names_.end();
    found_ = found_ || named;
    for (const auto& operand : expression.operands) look(*operand);
  }
  void look(const ast::Statement& statement) {
    last_ = std::max(last_, statement.where, before);
    for (const auto& expression : statement.expressions) {
      if (expression) look(*expression);
    }
    for (const ast::Declarator& declarator : statement.declarators) {
      last_ = std::max(last_, declarator.where, before);
      if (declarator.initial) look(*declarator.initial);
    }
    for (const auto& inner : statement.body) look(*inner);
  }
  bool found() const { return found_; }
  Location last() const { return last_; }

  static bool before(const Location& a, const Location& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  }

 private:
  std::vector<std::string> names_;
  bool found_ = false;
  Location last_;
};

bool mentions(const ast::Statement& statement, std::vector<std::string> names) {
  Search search(std::move(names));
  search.look(statement);
  return search.found();
}

}  // namespace

/// A flag belongs to the surface in whose text it stands, else to the next one of its file, else to the one before; in
/// a file without surfaces, to all.
void Checker::read_flags() {
  for (const ast::Pragma& pragma : unit_.pragmas) {
    if (pragma.text != kPhong && pragma.text != kTexture) {
      error(100, pragma.where, "unknown pragma 'pfman " + pragma.text + "'");
      continue;
    }
    const ast::Definition *around = nullptr, *behind = nullptr, *ahead = nullptr;
    bool same_file = false;
    for (const ast::Definition& definition : unit_.definitions) {
      if (definition.kind != ast::Definition::Kind::Surface || definition.where.file != pragma.where.file) continue;
      same_file = true;
      Search end;
      if (definition.body) end.look(*definition.body);
      const bool starts = Search::before(definition.where, pragma.where);
      if (starts && Search::before(pragma.where, end.last())) around = &definition;
      if (starts) behind = &definition;
      if (!starts && ahead == nullptr) ahead = &definition;
    }
    const ast::Definition* owner = around != nullptr ? around : ahead != nullptr ? ahead : behind;
    for (const ast::Definition& definition : unit_.definitions) {
      const bool surface = definition.kind == ast::Definition::Kind::Surface;
      if (surface && (!same_file || &definition == owner)) flags_[&definition][pragma.text] = pragma.where;
    }
  }
}

/// Declares one of the variables that shader and common code share.
void Checker::shared_variable(const char* name, const Scalar& scalar, int elements, bool varying, bool result,
                              Statements& out) {
  Type type;
  type.scalar = scalar;
  type.varying = varying;
  if (elements > 0) {
    type.rank = 1;
    type.dimensions = {elements, 1};
  }
  const Location where = around_.definition->where;
  Variable* variable = new_variable(name, type, Variable::Role::Local, where);
  declare(variable, result ? "the shared result" : nullptr).shared = true;
  out.push_back(make_statement(Statement::Kind::Declare, where));
  out.back()->variable = variable;
}

void Checker::insert_common(const std::string& flag, Location where, Statements& out) {
  if (flag == kPhong) {
    bool complete = true;
    for (const char* name : {"px_material_normal", "px_shader_view"}) {
      if (find(name) != nullptr) continue;
      error(110, where, "'" + flag + "' needs the parameter '" + name + "'");
      complete = false;
    }
    if (!complete) return;
  }
  common_.push_back(common_code(flag == kPhong ? kPhongCode : kTextureCode, where));
  in_common_code_ = true;
  block(common_.back()->body, out, true);
  in_common_code_ = false;
}

void Checker::surface_body(const ast::Definition& definition, Statements& out) {
  const auto found = flags_.find(&definition);
  const std::map<std::string, Location> none;
  std::map<std::string, Location> flags = found == flags_.end() ? none : found->second;
  around_.shader->shared_phong = flags.contains(kPhong);
  around_.shader->shared_texture = flags.contains(kTexture);
  const Scalar real = Scalar::floating();
  if (around_.shader->shared_phong) {
    shared_variable("px_magic_kd", real, 3, true, false, out);
    shared_variable("px_magic_ks", real, 3, true, false, out);
    shared_variable("px_magic_exp", real, 0, true, false, out);
    shared_variable("px_magic_diffuse", real, 3, true, true, out);
    shared_variable("px_magic_highlight", real, 3, true, true, out);
  }
  if (around_.shader->shared_texture) {
    shared_variable("px_magic_texid", Scalar::integer(), 0, false, false, out);
    shared_variable("px_magic_texcoord", real, 2, true, false, out);
    shared_variable("px_magic_texel", Scalar::fixed(false, 8, 8), 4, true, true, out);
  }
  const std::vector<std::string> texel = {"px_magic_texel"}, sums = {"px_magic_diffuse", "px_magic_highlight"};
  const auto insert = [&](const std::string& flag) {
    insert_common(flag, flags.at(flag), out);
    flags.erase(flag);
  };
  for (const ast::StatementPtr& one : definition.body->body) {
    const bool sums_due = flags.contains(kPhong) && mentions(*one, sums);
    const bool lights_due = sums_due || one->kind == ast::Statement::Kind::Illuminance;
    // Between the first stage and the last: not behind the illuminance.
    const bool texel_due = mentions(*one, texel) || (lights_due && mentions(*definition.body, texel));
    if (flags.contains(kTexture) && texel_due) insert(kTexture);
    if (sums_due) insert(kPhong);
    statement(*one, out, true);
  }
}

}  // namespace pfman
