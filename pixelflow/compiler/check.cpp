// A unit: its constants, functions and shaders.
#include "pixelflow/compiler/check.h"

#include "pixelflow/compiler/checker.h"

namespace pfman {

using Kind = ast::Definition::Kind;

void Checker::run() {
  scopes_.emplace_back();
  for (const ast::Definition& definition : unit_.definitions) {
    if (definition.kind == Kind::Constant) constants(definition.declarators, tree_.constants);
  }
  for (const ast::Definition& definition : unit_.definitions) {
    if (definition.kind == Kind::Function || definition.kind == Kind::Extern) declare_function(definition);
  }
  const std::vector<const ast::Definition*> order = functions_in_order();
  for (const ast::Definition* function : order) check_function(*function);
  read_flags();
  std::map<std::string, Location> shaders;
  for (const ast::Definition& definition : unit_.definitions) {
    if (definition.kind != Kind::Surface && definition.kind != Kind::Light) continue;
    const auto [first, is_new] = shaders.emplace(definition.name, definition.where);
    if (!is_new) {
      diagnostics_.add({111,
                        definition.where,
                        "shader '" + definition.name + "' is defined twice",
                        {{first->second, "the first definition"}}});
    }
    check_shader(definition);
  }
  // Externals first: they call nothing; then the others in the order in which they were checked.
  for (const ast::Definition& definition : unit_.definitions) {
    if (definition.kind != Kind::Extern) continue;
    const auto found = all_functions_.find(&definition);
    if (found != all_functions_.end()) tree_.functions.push_back(std::move(found->second));
  }
  for (const ast::Definition* definition : order) tree_.functions.push_back(std::move(all_functions_.at(definition)));
}

Tree check(const ast::Unit& unit, Diagnostics& diagnostics) {
  Tree tree;
  Checker(unit, tree, diagnostics).run();
  return tree;
}

}  // namespace pfman
