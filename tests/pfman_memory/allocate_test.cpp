// Places in pixel memory: what is shared, what is kept apart, what lights may use, and what is said when it is not
// enough.
#include "pixelflow/compiler/allocate.h"

#include <gtest/gtest.h>

#include "pixelflow/compiler/generate.h"
#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"
#include "tests/pfman_memory/code_builder.h"

namespace pfman_tests {
namespace {

using pixelflow::Code;
using Kind = CodeBuilder::Kind;

struct Allocate : testing::Test {
  pfman::MemoryMap map(CodeBuilder& b, bool share = true) {
    diagnostics.add_file("shader");
    return pfman::allocate(b.code, {.share = share}, diagnostics);
  }
  pfman::Diagnostics diagnostics;
};

TEST_F(Allocate, ADyingOperandMakesRoomForTheResult) {
  CodeBuilder b("chain");
  const int x = b.variable("x", 2), y = b.variable("y", 2), c = b.variable("c", 2);
  b.put(x, 1);
  b.operate(Code::Add, b.use(y), b.use(x), b.literal(1, 2));
  b.operate(Code::Add, b.use(c), b.use(y), b.literal(1, 2));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  EXPECT_EQ(m.address, (std::vector{pfman::kParametersAt, pfman::kParametersAt, pfman::kParametersAt}));
  EXPECT_EQ(m.peak_bytes, 2);
  EXPECT_EQ(m.first_free, pfman::kParametersAt + 2);
}

/// A product of two bytes by two, of which the upper ones are taken, must begin where its factor does, or apart.
TEST_F(Allocate, ResultNeverLiesAcrossAnOperand) {
  CodeBuilder b("across");
  const int x = b.variable("x", 4), y = b.variable("y", 1), c = b.variable("c", 2);
  b.put(y, 1);
  b.put(x, 1);
  pfman::ir::Operand upper = b.use(x);
  upper.offset = 1;
  upper.bytes = 3;
  b.operate(Code::Add, b.use(c), upper, b.use(y));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  const int result = m.address[static_cast<std::size_t>(c)], operand = m.address[static_cast<std::size_t>(x)] + 1;
  EXPECT_TRUE(result == operand || result + 2 <= operand || result >= operand + 3) << result << " and " << operand;
}

TEST_F(Allocate, ParametersStayAndTheirBytesAreFreeAfterwards) {
  CodeBuilder b("parameters");
  const int p = b.parameter("p", 4), unused = b.parameter("unused", 2), q = b.parameter("q", 2), x = b.variable("x", 2),
            c = b.variable("c", 4);
  b.operate(Code::Add, b.use(x), b.use(p), b.use(q));
  b.operate(Code::Add, b.use(c), b.use(x), b.use(q));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  EXPECT_EQ(m.address[static_cast<std::size_t>(p)], 2);
  EXPECT_EQ(m.address[static_cast<std::size_t>(unused)], -1);
  EXPECT_EQ(m.address[static_cast<std::size_t>(q)], 8);
  EXPECT_EQ(m.address[static_cast<std::size_t>(x)], 2);
  EXPECT_EQ(m.address[static_cast<std::size_t>(c)], 2);
  EXPECT_EQ(m.parameter_bytes, 10) << "the shader ID's two included";
  EXPECT_EQ(m.first_free, 10);
  EXPECT_EQ(m.allocated_bytes, 0) << "everything lies where parameters were";
}

TEST_F(Allocate, WorkspaceIsApartFromEverythingAlive) {
  CodeBuilder b("workspace");
  const int kept = b.float_variable("kept"), x = b.float_variable("x"), c = b.float_variable("c");
  b.put(kept, 1);
  b.put(x, 1);
  b.operate(Code::FloatMultiply, b.use(c), b.use(x), b.use(x));
  b.operate(Code::FloatAdd, b.use(c), b.use(c), b.use(kept));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  pixelflow::Operation product{.code = Code::FloatMultiply, .d = {}, .a = {}, .b = {}};
  const int bytes = pixelflow::workspace_bytes(product);
  ASSERT_GT(bytes, 0);
  const int work = b.code.code[2].work;
  for (const int v : {kept, x, c}) {
    const int at = m.address[static_cast<std::size_t>(v)];
    EXPECT_TRUE(at + 4 <= work || work + bytes <= at) << b.code.variables[static_cast<std::size_t>(v)].name;
  }
  EXPECT_EQ(m.peak_bytes, 8 + bytes);
  EXPECT_EQ(m.peak_at, 2);
  EXPECT_EQ(m.allocated_bytes, 8) << "workspaces are not variables";
}

/// The first byte for lights is behind what must survive them, not behind all that the first stage uses.
TEST_F(Allocate, HighWaterMark) {
  CodeBuilder b("lit");
  const int p = b.parameter("p", 2), wide = b.variable("wide", 8), other = b.variable("other", 8),
            kept = b.variable("kept", 2), c = b.variable("c", 2);
  b.operate(Code::Add, b.use(wide), b.use(p), b.literal(1, 8));
  b.operate(Code::Add, b.use(other), b.use(wide), b.use(p));
  b.operate(Code::Add, b.use(kept), b.use(other), b.use(wide));
  b.put(c, 0);
  b.stage(1);
  b.operate(Code::Add, b.use(c), b.use(c), b.use(kept));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  EXPECT_EQ(m.high_water, pfman::kParametersAt + 4);
  EXPECT_EQ(m.first_free, pfman::kParametersAt + 18);
}

TEST_F(Allocate, LightsGrowDownwards) {
  CodeBuilder b("light", pfman::Shader::Kind::Light);
  const int x = b.variable("x", 4), y = b.variable("y", 2),
            out = b.at_address("px_light_color", 2, pfman::kLightColorAt);
  b.put(x, 1);
  b.put(y, 1);
  b.operate(Code::Add, b.use(out), b.use(x), b.use(y));
  const pfman::MemoryMap m = map(b);
  EXPECT_EQ(m.address[static_cast<std::size_t>(x)], pfman::kSharedAt - 4);
  EXPECT_EQ(m.address[static_cast<std::size_t>(y)], pfman::kSharedAt - 6);
  EXPECT_EQ(m.address[static_cast<std::size_t>(out)], pfman::kLightColorAt);
  EXPECT_EQ(m.first_free, pfman::kSharedAt - 6);
  EXPECT_EQ(m.allocated_bytes, 6);
}

TEST_F(Allocate, WithoutSharing) {
  CodeBuilder b("unshared");
  const int x = b.variable("x", 2), y = b.variable("y", 4), c = b.variable("c", 1);
  b.put(x, 1);
  b.operate(Code::Add, b.use(y), b.use(x), b.literal(1, 2));
  b.operate(Code::Add, b.use(c), b.use(y), b.literal(1, 2));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b, false);
  EXPECT_EQ(m.address, (std::vector{2, 4, 8}));
  EXPECT_EQ(m.first_free, 9);
}

void write_nothing(pixelflow::Program&, const std::vector<pfman::ExternalArgument>&, const pfman::PixelWorkspace&) {}

TEST_F(Allocate, ExternalFunctionHasItsWorkspaceAndItsResultsApart) {
  constexpr int kWorkspace = 9;
  pfman::register_external("tests_pfman_memory_external", write_nothing, kWorkspace);
  pfman::Variable in, out;
  in.type.scalar = out.type.scalar = pfman::Scalar::fixed(false, 16, 0);
  out.output = true;
  pfman::Function function;
  function.linkage = "tests_pfman_memory_external";
  function.name = "external";
  function.parameters = {&in, &out};
  CodeBuilder b("caller");
  const int x = b.variable("x", 2), y = b.variable("y", 2);
  b.put(x, 1);
  b.put(y, 1);
  auto& call = b.add(Kind::External);
  call.external = &function;
  call.arguments = {b.use(x), b.use(y)};
  b.code.color = {y};
  const pfman::MemoryMap m = map(b);
  EXPECT_NE(m.address[0], m.address[1]);
  EXPECT_GE(b.code.code[2].work, pfman::kParametersAt + 4);
  EXPECT_EQ(m.peak_bytes, 4 + kWorkspace);
}

TEST_F(Allocate, BytesOfVariables) {
  CodeBuilder b("counted");
  const int p = b.parameter("p", 4), i = b.variable("i", 1), t = b.temporary(2), c = b.variable("c", 2);
  b.put(i, 1);
  b.operate(Code::Add, b.use(t), b.use(p), b.use(i));
  b.put(i, 3);
  b.operate(Code::Add, b.use(c), b.use(t), b.use(i));
  b.code.color = {c};
  pfman::to_ssa(b.code, diagnostics);
  EXPECT_EQ(b.code.source_bytes, 3) << "versions of a variable count once";
  EXPECT_EQ(b.code.temporary_bytes, 2);
  EXPECT_EQ(map(b).varying_bytes, 5);
}

TEST_F(Allocate, MemoryExceeded) {
  CodeBuilder b("greedy");
  const auto array = [&](const std::string& name, int count) {
    std::vector<int> elements;
    for (int n = 0; n < count; ++n) {
      elements.push_back(b.float_variable(name));
      pfman::ir::Variable& element = b.code.variables.back();
      element.name += "[" + std::to_string(n) + "]";
      element.where = b.code.variables[static_cast<std::size_t>(elements[0])].where;
    }
    return elements;
  };
  std::vector<int> all = array("lit", 3);
  const std::vector<int> points = array("points", 48);
  all.insert(all.end(), points.begin(), points.end());
  const int row = b.variable("row", 1), t = b.temporary(8), place = b.parameter("place", 4);
  for (const int v : all) b.operate(Code::Add, b.use(v), b.use(place), b.use(place));
  b.put(row, 1);
  b.operate(Code::Divide, b.use(t), b.use(place), b.use(row), 2);
  for (const int v : all) b.operate(Code::FloatAdd, b.use(place), b.use(place), b.use(v));
  b.operate(Code::Add, b.use(place), b.use(t), b.use(row));
  b.code.color = {place};
  map(b);
  const int at = b.size() - 1 - 51;  // the first sum
  const std::string line = std::to_string(b.code.code[static_cast<std::size_t>(at)].where.line);
  pixelflow::Operation sum{.code = Code::FloatAdd, .d = {}, .a = {}, .b = {}};
  const int work = pixelflow::workspace_bytes(sum);
  EXPECT_EQ(diagnostics.text(),
            "shader:1:1: error: shader 'greedy' needs " + std::to_string(217 + work) +
                " bytes of pixel memory at line " + line + ", 217 are available [E501]\n" +
                "shader:1:3: note: 'lit': float, 12 bytes; as fixed of 16 bits it would take 6 less\n"
                "shader:4:3: note: 'points': float, 192 bytes; as fixed of 16 bits it would take 96 less\n"
                "shader:52:3: note: 'row': fixed, 1 byte\n"
                "shader:53:3: note: an intermediate result: fixed, 8 bytes\n"
                "shader:54:3: note: 'place': fixed, 4 bytes\n"
                "shader:" +
                line + ":5: note: workspace of float_add: " + std::to_string(work) + " bytes\n");
}

TEST_F(Allocate, TransferExceeded) {
  CodeBuilder b("wide");
  for (int n = 0; n < 35; ++n) b.parameter("p" + std::to_string(n), 4);
  const int c = b.variable("c", 1);
  b.put(c, 1);
  b.code.color = {c};
  map(b);
  EXPECT_EQ(diagnostics.text(),
            "shader:1:1: error: shader 'wide' receives 142 bytes for each pixel, its ID included; the 5 packets of a "
            "transfer have 140 [E502]\n");
}

TEST_F(Allocate, ExactlyFits) {
  CodeBuilder b("full");
  std::vector<int> all;
  for (int n = 0; n < 27; ++n) all.push_back(b.variable("v" + std::to_string(n), 8));
  const int last = b.variable("last", 1);
  for (const int v : all) b.put(v, 1);
  b.put(last, 1);
  for (const int v : all) b.operate(Code::Less, {}, b.use(v), b.use(last));
  b.code.color = {last};
  EXPECT_EQ(map(b).first_free, pfman::kSharedAt);
  EXPECT_EQ(diagnostics.text(), "");
}

TEST_F(Allocate, Dump) {
  CodeBuilder b("mapped");
  const int p = b.parameter("p", 2), x = b.variable("x", 2), c = b.variable("c", 2);
  b.operate(Code::Add, b.use(x), b.use(p), b.literal(1, 2));
  b.operate(Code::Add, b.use(c), b.use(x), b.use(p));
  b.code.color = {c};
  const pfman::MemoryMap m = map(b);
  EXPECT_EQ(pfman::dump(m, b.code),
            "memory map of mapped\n"
            "  2-3       p                         lines 4-5, retained\n"
            "  2-3       c                         lines 5-5\n"
            "  4-5       x                         lines 4-5\n"
            "  received with the pixel, bytes      4\n"
            "  most in use at once, bytes          4\n"
            "  at line                             4\n"
            "  first free byte                     6\n"
            "  first byte for lights               4\n"
            "  bytes free                          213\n"
            "  uniform variables, bytes            0\n"
            "  varying variables, bytes            0\n"
            "  these as allocated, bytes           2\n");
}

}  // namespace
}  // namespace pfman_tests
