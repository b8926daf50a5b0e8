// Lifetimes, variables without a value, unneeded code, copies.
#include "pixelflow/compiler/lifetime.h"

#include <gtest/gtest.h>

#include "pixelflow/compiler/memory_layout.h"
#include "tests/pfman_memory/code_builder.h"

namespace pfman_tests {
namespace {

using pixelflow::Code;
using Kind = CodeBuilder::Kind;

std::string warnings(const CodeBuilder& b) {
  CodeBuilder copy("copy");
  pfman::Diagnostics diagnostics;
  diagnostics.add_file("shader");
  copy.code.variables = b.code.variables;
  copy.code.code = b.code.code;
  copy.code.color = b.code.color;
  copy.code.parameters = b.code.parameters;
  pfman::to_ssa(copy.code, diagnostics);
  return diagnostics.text();
}

TEST(Lifetimes, FromDefinitionToLastUse) {
  CodeBuilder b("straight");
  const int x = b.variable("x", 1), y = b.variable("y", 1), c = b.variable("c", 1);
  b.put(x, 1);
  b.put(y, 2);
  b.operate(Code::Add, b.use(c), b.use(x), b.use(y));
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  EXPECT_FALSE(l.alive_before(0, x));
  EXPECT_TRUE(l.alive_before(1, x));
  EXPECT_TRUE(l.alive_before(2, x));
  EXPECT_TRUE(l.alive_before(2, y));
  EXPECT_FALSE(l.alive_after(2, x));
  EXPECT_TRUE(l.alive_before(3, c));
  EXPECT_TRUE(l.interfere(x, y));
  EXPECT_FALSE(l.interfere(x, c));
}

/// What one branch needs is not kept in the other.
TEST(Lifetimes, MaskedBranchesAreApart) {
  CodeBuilder b("branches");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), y = b.variable("y", 1), c = b.variable("c", 1);
  const int branch = b.begin_if(Kind::IfMasked, b.use(p));
  const int in_then = b.put(x, 1);
  b.copy(c, x);
  const int middle = b.begin_else(branch);
  b.put(y, 1);
  const int in_else = b.copy(c, y);
  b.end_if(middle);
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  EXPECT_TRUE(l.alive_after(in_then, x));
  EXPECT_FALSE(l.alive_before(in_else, x));
  EXPECT_TRUE(l.alive_before(in_else, y));
  EXPECT_FALSE(l.interfere(x, y));
}

TEST(Lifetimes, AroundALoop) {
  CodeBuilder b("loop");
  const int x = b.variable("x", 1), t = b.variable("t", 1), c = b.variable("c", 1);
  b.put(x, 1);
  b.put(c, 0);
  const int loop = b.begin_loop();
  b.loop_test(loop, b.uniform_literal(0));
  b.operate(Code::Add, b.use(c), b.use(c), b.use(x));
  const int last = b.put(t, 3);
  b.operate(Code::Add, b.use(c), b.use(c), b.use(t));
  b.loop_next(loop);
  b.end_loop(loop);
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  EXPECT_TRUE(l.alive_after(last, x)) << "the next iteration reads it";
  EXPECT_TRUE(l.interfere(x, t));
  EXPECT_FALSE(l.alive_before(b.size(), x));
}

/// Where only one of two ways gives a value, the other one keeps no bytes for it.
TEST(Lifetimes, NotBeforeThereIsAValue) {
  CodeBuilder b("guarded");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), y = b.variable("y", 1), c = b.variable("c", 1);
  b.put(y, 1);
  const int read = b.copy(c, y);
  int branch = b.begin_if(Kind::IfMasked, b.use(p));
  b.put(x, 1);
  b.end_if(branch);
  branch = b.begin_if(Kind::IfMasked, b.use(p));
  b.copy(c, x);
  b.end_if(branch);
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  EXPECT_FALSE(l.alive_before(read, x));
  EXPECT_FALSE(l.interfere(x, y));
}

TEST(Lifetimes, RetainedOverTheLights) {
  CodeBuilder b("stages");
  const int p = b.parameter("p", 2), sum = b.variable("sum", 2), pre = b.variable("pre", 2),
            post = b.variable("post", 2), light = b.at_address("px_light_color", 2, pfman::kLightColorAt),
            inside = b.variable("inside", 2);
  b.copy(pre, p);
  b.copy(sum, pre);
  b.copy(post, pre);
  b.stage(1);
  b.copy(inside, light);
  b.operate(Code::Add, b.use(sum), b.use(sum), b.use(inside));
  b.stage(2);
  b.operate(Code::Add, b.use(sum), b.use(sum), b.use(post));
  b.code.color = {sum};
  const pfman::Lifetimes l(b.code);
  EXPECT_TRUE(l.retained(sum));
  EXPECT_TRUE(l.retained(post));
  EXPECT_FALSE(l.retained(pre));
  EXPECT_FALSE(l.retained(p));
  EXPECT_FALSE(l.retained(inside));
  EXPECT_FALSE(l.retained(light)) << "it is new for each light";
  EXPECT_FALSE(l.alive_before(0, light));
  EXPECT_TRUE(l.interfere(light, sum));
}

TEST(Lifetimes, SurfaceWithoutIlluminanceRetainsWhatItReceives) {
  CodeBuilder b("plain");
  const int used = b.parameter("used", 2), unused = b.parameter("unused", 2), c = b.variable("c", 2);
  b.copy(c, used);
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  EXPECT_TRUE(l.retained(used));
  EXPECT_FALSE(l.retained(unused));
}

TEST(Lifetimes, MaskBytesAreAlwaysAlive) {
  CodeBuilder b("masks");
  const int m = b.variable("m", 1), x = b.variable("x", 1);
  b.put(x, 1);
  b.code.mask_bytes = {m};
  b.code.color = {x};
  const pfman::Lifetimes l(b.code);
  for (int i = 0; i <= b.size(); ++i) EXPECT_TRUE(l.alive_before(i, m)) << i;
  EXPECT_TRUE(l.interfere(m, x));
}

/// The element written is not known: the others stay as they are.
TEST(Lifetimes, ElementByRunTimeIndexKeepsTheArray) {
  CodeBuilder b("array");
  const int a = b.variable("a", 1, 4), c = b.variable("c", 1);
  for (int n = 0; n < 4; ++n) {
    pfman::ir::Operand d = b.use(a);
    d.offset = n;
    b.operate(Code::Copy, d, b.literal(1, 1));
  }
  b.operate(Code::Copy, b.element(a, b.uniform_literal(2)), b.literal(9, 1));
  b.operate(Code::Copy, b.use(c), b.element(a, b.uniform_literal(1)));
  b.code.color = {c};
  const pfman::Lifetimes l(b.code);
  for (int i = 1; i <= 5; ++i) EXPECT_TRUE(l.alive_before(i, a)) << i;
  EXPECT_TRUE(l.interfere(a, c)) << "the result must not lie on any element";
}

TEST(Lifetimes, Dump) {
  CodeBuilder b("dumped");
  const int x = b.variable("x", 1), c = b.variable("c", 2);
  b.put(x, 1);
  b.operate(Code::Add, b.use(c), b.use(x), b.literal(1, 1));
  b.code.color = {c};
  EXPECT_EQ(pfman::dump(pfman::Lifetimes(b.code), b.code),
            "lifetimes of dumped: instruction, line, variables alive before it\n"
            "              x, 1 bytes\n"
            "              | c, 2 bytes\n"
            "0     3       . .\n"
            "1     4       # .\n"
            "2     end     . #\n");
}

TEST(Uninitialised, OnceAVariableAtItsFirstUse) {
  CodeBuilder b("w604");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), c = b.variable("c", 1);
  const int branch = b.begin_if(Kind::IfMasked, b.use(p));
  b.put(x, 1);
  b.end_if(branch);
  b.copy(c, x);
  b.copy(c, x);
  b.code.color = {c};
  EXPECT_EQ(warnings(b), "shader:7:5: warning: 'x' may be used before it has a value [W604]\n");
}

TEST(Uninitialised, NotWhereEveryWayGivesAValue) {
  CodeBuilder b("given");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), c = b.variable("c", 1), t = b.temporary(1);
  const int branch = b.begin_if(Kind::IfMasked, b.use(p));
  b.put(x, 1);
  const int middle = b.begin_else(branch);
  b.put(x, 2);
  b.end_if(middle);
  b.operate(Code::Add, b.use(c), b.use(x), b.use(t));
  b.code.color = {c};
  EXPECT_EQ(warnings(b), "") << "temporaries are the compiler's own business";
}

TEST(Uninitialised, LightsMayRunNoTimesLoopsRunOnce) {
  CodeBuilder b("none");
  const int x = b.variable("x", 1), y = b.variable("y", 1), c = b.variable("c", 1);
  const int loop = b.begin_loop();
  b.loop_test(loop, b.uniform_literal(0));
  b.put(x, 1);
  b.loop_next(loop);
  b.end_loop(loop);
  b.stage(1);
  b.put(y, 1);
  b.stage(2);
  b.operate(Code::Add, b.use(c), b.use(x), b.use(y));
  b.code.color = {c};
  EXPECT_EQ(warnings(b), "shader:12:5: warning: 'y' may be used before it has a value [W604]\n");
}

TEST(Uninitialised, ColourThatIsNeverAssigned) {
  CodeBuilder b("colourless");
  const int c = b.variable("px_shader_color", 1);
  b.put(b.variable("x", 1), 1);
  b.code.color = {c};
  EXPECT_EQ(warnings(b), "shader:1:3: warning: 'px_shader_color' may be used before it has a value [W604]\n");
}

TEST(Uninitialised, ArrayByElements) {
  CodeBuilder b("elements");
  const int a = b.variable("a", 1, 2), c = b.variable("c", 1);
  b.operate(Code::Copy, b.element(a, b.uniform_literal(1)), b.literal(1, 1));
  b.operate(Code::Copy, b.use(c), b.element(a, b.uniform_literal(1)));
  b.code.color = {c};
  EXPECT_EQ(warnings(b), "");
}

TEST(Unused, DropsWhatNobodyReads) {
  CodeBuilder b("unused");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), y = b.variable("y", 1), c = b.variable("c", 1);
  b.put(x, 1);
  b.operate(Code::Add, b.use(y), b.use(x), b.use(y));
  b.operate(Code::Less, {}, b.use(p), b.literal(4, 1));
  const int branch = b.begin_if(Kind::IfMasked);
  b.put(c, 1);
  b.end_if(branch);
  b.put(c, 2);
  b.code.color = {c};
  pfman::drop_unused(b.code);
  ASSERT_EQ(b.size(), 5);
  EXPECT_EQ(b.code.code[0].code, Code::Less);
  EXPECT_EQ(b.code.code[1].match, 3) << "matches follow";
  EXPECT_EQ(b.code.variables.size(), 2u);
}

TEST(Unused, MaskedBranchesWithNothingInThem) {
  CodeBuilder b("empty");
  const int p = b.parameter("p", 1), x = b.variable("x", 1), c = b.variable("c", 1);
  const int outer = b.begin_if(Kind::IfMasked, b.use(p));
  b.operate(Code::Less, {}, b.use(p), b.literal(4, 1));
  const int inner = b.begin_if(Kind::IfMasked);
  b.put(x, 1);
  const int middle = b.begin_else(inner);
  b.put(x, 2);
  b.end_if(middle);
  b.end_if(outer);
  b.put(c, 2);
  b.code.color = {c};
  pfman::drop_unused(b.code);
  EXPECT_EQ(b.size(), 1);
}

TEST(Unused, ComparisonWhoseBitIsNotRead) {
  CodeBuilder b("bit");
  const int p = b.parameter("p", 1), bit = b.variable("bit", 1), c = b.variable("c", 1);
  b.operate(Code::Less, b.use(bit), b.use(p), b.literal(4, 1));
  b.put(c, 1);
  b.operate(Code::Less, b.use(bit), b.use(p), b.literal(5, 1));
  auto& choice = b.add(Kind::Select);
  choice.d = choice.a = b.use(c);
  choice.b = b.literal(3, 1);
  b.code.color = {c};
  pfman::drop_unused(b.code);
  ASSERT_EQ(b.size(), 3);
  EXPECT_EQ(b.code.code[1].code, Code::Less) << "the choice behind it reads K";
}

TEST(Unused, IndicesThatMayBeWrongStay) {
  CodeBuilder b("index");
  const int a = b.parameter("a", 1, 3), x = b.variable("x", 1), c = b.variable("c", 1);
  b.operate(Code::Copy, b.use(x), b.element(a, b.uniform_literal(7)));
  b.put(c, 1);
  b.code.color = {c};
  pfman::drop_unused(b.code);
  EXPECT_EQ(b.size(), 2);
}

TEST(Copies, JoinedWhereOneDies) {
  CodeBuilder b("copies");
  const int p = b.parameter("p", 2), x = b.variable("x", 2), y = b.variable("y", 2), c = b.variable("c", 2);
  b.copy(x, p);
  b.copy(y, x);
  b.operate(Code::Add, b.use(y), b.use(y), b.literal(1, 1));
  b.operate(Code::Add, b.use(c), b.use(y), b.use(x));
  b.code.color = {c};
  pfman::join_copies(b.code);
  ASSERT_EQ(b.size(), 3) << "x lies in p's place, y must not";
  EXPECT_EQ(b.code.code[0].code, Code::Copy);
  EXPECT_EQ(b.code.variables[static_cast<std::size_t>(b.code.code[0].a.variable)].name, "p");
  EXPECT_EQ(b.code.variables[static_cast<std::size_t>(b.code.code[2].b.variable)].name, "p");
}

TEST(Copies, AliveAtTheSameTimeButUnchanged) {
  CodeBuilder b("equal");
  const int p = b.parameter("p", 2), x = b.variable("x", 2), c = b.variable("c", 2);
  b.copy(x, p);
  b.operate(Code::Add, b.use(c), b.use(x), b.use(p));
  b.code.color = {c};
  pfman::join_copies(b.code);
  EXPECT_EQ(b.size(), 1);
}

TEST(Copies, NotIntoTwoPlaces) {
  CodeBuilder b("places", pfman::Shader::Kind::Light);
  const int one = b.at_address("px_light_color", 2, pfman::kLightColorAt),
            other = b.at_address("px_light_specular", 2, pfman::kLightSpecularAt);
  b.put(one, 5);
  b.copy(other, one);
  pfman::join_copies(b.code);
  EXPECT_EQ(b.size(), 2);
}

/// Lights and other shaders read the position again.
TEST(Copies, PositionIsNeverWritten) {
  for (const bool changes : {false, true}) {
    CodeBuilder b("position");
    const int position = b.at_address("px_shader_position", 4, pfman::kPositionAt), x = b.variable("x", 4),
              c = b.variable("c", 4);
    b.copy(x, position);
    if (changes) b.operate(Code::Add, b.use(x), b.use(x), b.literal(1, 1));
    b.operate(Code::Add, b.use(c), b.use(x), b.literal(1, 1));
    b.code.color = {c};
    pfman::join_copies(b.code);
    EXPECT_EQ(b.size(), changes ? 3 : 1);
  }
}

TEST(Copies, ColourStaysOutOfTheSharedArea) {
  CodeBuilder b("colour");
  const int light = b.at_address("px_light_color", 2, pfman::kLightColorAt), c = b.variable("c", 2);
  b.put(c, 0);
  b.stage(1);
  b.copy(c, light);
  b.code.color = {c};
  pfman::join_copies(b.code);
  EXPECT_EQ(b.size(), 3);
}

TEST(Phis, TwoPlacesInOneWebAreRefused) {
  CodeBuilder b("web");
  const int p = b.parameter("p", 2), q = b.parameter("q", 2);
  b.put(p, 1);
  b.code.color = {p};
  b.code.phis.push_back({1, p, {q}});
  EXPECT_THROW(pfman::merge_phis(b.code), std::logic_error);
}

TEST(Phis, VersionsAliveAtOnceAreRefused) {
  CodeBuilder b("web");
  const int x = b.variable("x", 2), y = b.variable("y", 2), z = b.variable("z", 2), c = b.variable("c", 2);
  b.put(x, 1);
  b.put(y, 2);
  b.operate(Code::Add, b.use(c), b.use(x), b.use(y));
  b.operate(Code::Add, b.use(c), b.use(c), b.use(z));
  b.code.color = {c};
  b.code.phis.push_back({3, z, {x}});
  b.code.phis.push_back({3, z, {y}});
  EXPECT_THROW(pfman::merge_phis(b.code), std::logic_error);
}

}  // namespace
}  // namespace pfman_tests
