// A program text that can be taken apart: where a failing program is reduced, statements go and expressions shrink.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace random_shaders {

struct Piece {
  enum class Kind {
    Text,        // stays as it is
    Expression,  // may become one of the expressions in it, or a number
    Statement,   // may go, or become the statements in it
  };
  Kind kind = Kind::Text;
  std::string text;  ///< each '$' stands for the next of the children
  std::vector<Piece> children;
};

Piece text(const std::string& words);
Piece expression(const std::string& form, std::vector<Piece> children = {});
Piece statement(const std::string& form, std::vector<Piece> children = {});
Piece sequence(std::vector<Piece> children);  ///< one after another

std::string render(const Piece& piece);

/// The smallest program found for which `fails` still holds, with at most `tries` calls of it.
Piece reduce(Piece piece, const std::function<bool(const Piece&)>& fails, int tries);

}  // namespace random_shaders
