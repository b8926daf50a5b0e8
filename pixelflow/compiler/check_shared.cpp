// Shaders that share their lighting or texturing with others (Olano and Lastra 1998, section 6.1.5.3).
#include "pixelflow/compiler/checker.h"

namespace pfman {

void Checker::read_flags() {}

void Checker::surface_body(const ast::Definition& definition, Statements& out) {
  block(definition.body->body, out, true);
}

}  // namespace pfman
