// Statements.
#include "tests/reference/resolver.h"

namespace reference {
namespace {

StepPtr make_step(Step::Kind kind, pfman::Location where) {
  auto made = std::make_unique<Step>();
  made->kind = kind;
  made->where = where;
  return made;
}

}  // namespace

StepPtr Resolver::body_step(const Statement& statement) {
  scopes_.emplace_back();
  StepPtr made = step(statement);
  scopes_.pop_back();
  return made;
}

StepPtr Resolver::step(const Statement& statement) {
  using Kind = Statement::Kind;
  switch (statement.kind) {
    case Kind::Declaration: {
      StepPtr made = make_step(Step::Kind::Block, statement.where);
      for (const auto& declarator : statement.declarators) {
        StepPtr one = make_step(Step::Kind::Declare, declarator.where);
        // The initial value is outside the variable's scope.
        NodePtr initial = declarator.initial ? node(*declarator.initial) : nullptr;
        one->variable = declare(declarator, declarator.specifiers->rate == pfman::ast::Rate::Uniform);
        if (initial && initial->shape != one->variable->shape) fail(203, declarator.where, "initial value's shape");
        if (initial && one->variable->uniform && !initial->uniform) fail(301, declarator.where, "varying value");
        one->nodes.push_back(initial ? root(std::move(initial), one->variable->number) : nullptr);
        made->body.push_back(std::move(one));
      }
      return made;
    }
    case Kind::Constant: declare_constants(statement.declarators); return make_step(Step::Kind::Block, statement.where);
    case Kind::Expression: {
      StepPtr made = make_step(Step::Kind::Evaluate, statement.where);
      NodePtr value = node(*statement.expressions[0]);
      const bool empty = value->kind == Node::Kind::Call && value->function->result == nullptr;
      made->nodes.push_back(empty ? std::move(value) : whole(std::move(value)));
      return made;
    }
    case Kind::Block: {
      StepPtr made = make_step(Step::Kind::Block, statement.where);
      scopes_.emplace_back();
      for (const auto& inner : statement.body) made->body.push_back(step(*inner));
      scopes_.pop_back();
      return made;
    }
    case Kind::If: return if_step(statement);
    case Kind::While:
    case Kind::DoWhile:
    case Kind::For: return loop_step(statement);
    case Kind::Illuminance: return light_step(statement, Step::Kind::Illuminance);
    case Kind::Illuminate: return light_step(statement, Step::Kind::Illuminate);
    case Kind::Solar: return light_step(statement, Step::Kind::Solar);
    case Kind::Break:
    case Kind::Continue: {
      if (varying_ifs_.empty()) fail(304, statement.where, "outside a loop");
      StepPtr made =
          make_step(statement.kind == Kind::Break ? Step::Kind::Break : Step::Kind::Continue, statement.where);
      made->masked = varying_ifs_.back() > 0;
      return made;
    }
    case Kind::Return: {
      StepPtr made = make_step(Step::Kind::Return, statement.where);
      if (!statement.expressions.empty() && result_ != nullptr) {
        made->nodes.push_back(root(node(*statement.expressions[0]), result_->number));
        made->variable = result_;
      }
      return made;
    }
    case Kind::Empty: break;
  }
  return make_step(Step::Kind::Block, statement.where);
}

StepPtr Resolver::if_step(const Statement& statement) {
  StepPtr made = make_step(Step::Kind::If, statement.where);
  made->nodes.push_back(condition(node(*statement.expressions[0])));
  made->varying = !made->nodes[0]->uniform;
  if (made->varying && !varying_ifs_.empty()) ++varying_ifs_.back();
  for (const auto& branch : statement.body) made->body.push_back(body_step(*branch));
  if (made->varying && !varying_ifs_.empty()) --varying_ifs_.back();
  return made;
}

StepPtr Resolver::loop_step(const Statement& statement) {
  StepPtr made = make_step(Step::Kind::Loop, statement.where);
  const bool counted = statement.kind == Statement::Kind::For;
  made->body_first = statement.kind == Statement::Kind::DoWhile;
  StepPtr whole_loop;
  if (counted) {
    whole_loop = make_step(Step::Kind::Block, statement.where);
    if (statement.expressions[0]) {
      StepPtr first = make_step(Step::Kind::Evaluate, statement.where);
      first->nodes.push_back(whole(node(*statement.expressions[0])));
      whole_loop->body.push_back(std::move(first));
    }
  }
  const auto& test = statement.expressions[counted ? 1 : 0];
  made->nodes.push_back(test ? condition(node(*test)) : nullptr);
  if (test && !made->nodes[0]->uniform) fail(303, statement.where, "varying loop condition");
  made->nodes.push_back(counted && statement.expressions[2] ? whole(node(*statement.expressions[2])) : nullptr);
  varying_ifs_.push_back(0);
  made->body.push_back(body_step(*statement.body[0]));
  varying_ifs_.pop_back();
  if (!counted) return made;
  whole_loop->body.push_back(std::move(made));
  return whole_loop;
}

StepPtr Resolver::light_step(const Statement& statement, Step::Kind kind) {
  StepPtr made = make_step(kind, statement.where);
  // Position or axis and angle; an illuminance's position can only be the surface's.
  for (std::size_t n = 0; n < statement.expressions.size(); ++n) {
    if (kind == Step::Kind::Illuminance && n == 0) continue;
    made->nodes.push_back(root(node(*statement.expressions[n]), kFloat));
  }
  made->body.push_back(body_step(*statement.body[0]));
  return made;
}

}  // namespace reference
