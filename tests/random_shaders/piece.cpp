#include "tests/random_shaders/piece.h"

#include <utility>

namespace random_shaders {

Piece text(const std::string& words) { return {Piece::Kind::Text, words, {}}; }
Piece expression(const std::string& form, std::vector<Piece> children) {
  return {Piece::Kind::Expression, form, std::move(children)};
}
Piece statement(const std::string& form, std::vector<Piece> children) {
  return {Piece::Kind::Statement, form, std::move(children)};
}
Piece sequence(std::vector<Piece> children) {
  return {Piece::Kind::Text, std::string(children.size(), '$'), std::move(children)};
}

namespace {

void render_to(const Piece& piece, std::string& out) {
  std::size_t next = 0;
  for (const char letter : piece.text) {
    if (letter == '$' && next < piece.children.size()) {
      render_to(piece.children[next++], out);
    } else {
      out += letter;
    }
  }
}

/// The pieces in order, outer ones first.
void collect(Piece& piece, std::vector<Piece*>& all) {
  all.push_back(&piece);
  for (Piece& child : piece.children) collect(child, all);
}

/// What might stand in a piece's place.
std::vector<Piece> smaller(const Piece& piece) {
  std::vector<Piece> found;
  if (piece.kind == Piece::Kind::Text) return found;
  const bool number = piece.text == "0" || piece.text == "1" || piece.text == "0.5f";
  if (piece.kind == Piece::Kind::Statement && !piece.text.empty()) found.push_back(statement(""));
  if (piece.kind == Piece::Kind::Expression && !number) {
    for (const char* simple : {"0", "1", "0.5f"}) found.push_back(expression(simple));
  }
  std::vector<const Piece*> open;
  for (const Piece& child : piece.children) open.push_back(&child);
  // The nearest pieces inside of the same kind, through texts.
  while (!open.empty()) {
    const Piece* inner = open.back();
    open.pop_back();
    if (inner->kind == piece.kind) {
      found.push_back(*inner);
    } else if (inner->kind == Piece::Kind::Text) {
      if (piece.kind == Piece::Kind::Statement && inner->children.size() > 1) found.push_back(*inner);
      for (const Piece& child : inner->children) open.push_back(&child);
    }
  }
  return found;
}

}  // namespace

std::string render(const Piece& piece) {
  std::string out;
  render_to(piece, out);
  return out;
}

Piece reduce(Piece piece, const std::function<bool(const Piece&)>& fails, int tries) {
  bool progress = true;
  while (progress && tries > 0) {
    progress = false;
    for (std::size_t at = 0; tries > 0; ++at) {
      std::vector<Piece*> all;
      collect(piece, all);
      if (at >= all.size()) break;
      const Piece original = *all[at];
      for (const Piece& candidate : smaller(original)) {
        if (tries-- <= 0) break;
        *all[at] = candidate;
        if (fails(piece)) {
          progress = true;
          break;
        }
        *all[at] = original;
      }
    }
  }
  return piece;
}

}  // namespace random_shaders
