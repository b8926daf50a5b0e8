// Statements: control flow on the host and by masks, loops, stages.
#include <algorithm>

#include "pixelflow/compiler/lowering.h"

namespace pfman {

void Lowering::lower_body(const std::vector<StatementPtr>& body) {
  for (const StatementPtr& statement : body) {
    if (too_long_) return;
    lower_statement(*statement);
  }
}

void Lowering::lower_statement(const Statement& statement) {
  where_ = statement.where;
  switch (statement.kind) {
    case Statement::Kind::Evaluate: {
      const Node& node = *statement.expression;
      where_ = node.where;
      if (node.op == Op::Call && node.type.is_void) {
        lower_call(node);
      } else if (is_uniform(node)) {
        NodePtr tree = uniform_tree(node);
        if (!is_pure(*tree)) evaluate(std::move(tree));
      } else {
        lower_node(node);
      }
      return;
    }
    case Statement::Kind::Declare: return;
    case Statement::Kind::Block: return lower_body(statement.body);
    case Statement::Kind::If: return lower_if(statement);
    case Statement::Kind::Loop: return lower_loop(statement);
    case Statement::Kind::Break:
    case Statement::Kind::Continue: return lower_jump(statement);
    case Statement::Kind::Illuminance: return begin_illuminance(statement);
  }
}

void Lowering::take_bits(int count) {
  mask_bits_ += count;
  code_.mask_bits = std::max(code_.mask_bits, mask_bits_);
}

void Lowering::lower_if(const Statement& statement) {
  const Node& test = *statement.expression;
  const bool has_else = statement.body.size() > 1;
  const Location where = statement.where;
  if (is_uniform(test)) {
    int opening = begin_if(uniform_tree(test));
    lower_statement(*statement.body[0]);
    where_ = where;
    if (has_else) {
      opening = begin_else(opening);
      lower_statement(*statement.body[1]);
      where_ = where;
    }
    return end_if(opening);
  }
  where_ = test.where;
  ir::Instruction masked;
  masked.kind = Kind::IfMasked;
  masked.condition = condition(test);
  const int bits = has_else ? 2 : 1;
  take_bits(bits);
  int opening = append(std::move(masked));
  lower_statement(*statement.body[0]);
  where_ = where;
  if (has_else) {
    ir::Instruction middle;
    middle.kind = Kind::ElseMasked;
    const int between = append(std::move(middle));
    at(opening).match = between;
    opening = between;
    lower_statement(*statement.body[1]);
    where_ = where;
  }
  ir::Instruction closing;
  closing.kind = Kind::EndIfMasked;
  closing.match = opening;
  const int end = append(std::move(closing));
  at(opening).match = end;
  mask_bits_ -= bits;
}

void Lowering::test_loop(const Statement& statement, int loop) {
  if (!statement.expression) return;
  where_ = statement.expression->where;
  ir::Instruction test;
  test.kind = Kind::LoopTest;
  test.uniform = add_uniform(uniform_tree(*statement.expression));
  test.match = loop;
  append(std::move(test));
}

void Lowering::lower_loop(const Statement& statement) {
  const int bits = statement.masked_breaks || statement.masked_continues
                       ? 1 + (statement.masked_breaks ? 1 : 0) + (statement.masked_continues ? 1 : 0)
                       : 0;
  const int loop = begin_loop();
  if (bits > 0) at(loop).mask = mask_bits_;
  take_bits(bits);
  at(loop).masked_breaks = statement.masked_breaks;
  at(loop).masked_continues = statement.masked_continues;
  loops_.push_back(loop);
  if (!statement.test_last) test_loop(statement, loop);
  lower_body(statement.body);
  where_ = statement.where;
  ir::Instruction next;
  next.kind = Kind::LoopNext;
  next.match = loop;
  append(std::move(next));
  if (statement.step) lower_statement(*statement.step);
  if (statement.test_last) test_loop(statement, loop);
  where_ = statement.where;
  end_loop(loop);
  loops_.pop_back();
  mask_bits_ -= bits;
}

void Lowering::lower_jump(const Statement& statement) {
  const bool is_break = statement.kind == Statement::Kind::Break;
  ir::Instruction jump;
  jump.match = loops_.back();
  if (statement.masked) {
    jump.kind = is_break ? Kind::BreakMasked : Kind::ContinueMasked;
  } else {
    jump.kind = is_break ? Kind::Break : Kind::Continue;
  }
  append(std::move(jump));
}

void Lowering::begin_illuminance(const Statement& statement) {
  code_.has_illuminance = true;
  ir::Instruction stage;
  stage.kind = Kind::Stage;
  stage.stage = 1;
  append(stage);
  lower_body(statement.body);
  where_ = statement.where;
  stage.stage = 2;
  append(stage);
}

}  // namespace pfman
