// The project's shaders through compiler and processors against the reference interpreter: every bit of the colours.
#include <gtest/gtest.h>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/language/parser.h"
#include "pixelflow/shading/test_textures.h"
#include "tests/reference/interpreter.h"
#include "tests/shaders/scenes.h"

namespace shader_tests {
namespace {

class TestTextures : public reference::Textures {
 public:
  std::array<std::uint8_t, 4> look_up(std::int64_t number, float s, float t) const override {
    return memory_.lookup(number, s, t);
  }
  std::array<std::uint8_t, 4> environment(std::int64_t number, std::array<float, 3> direction) const override {
    return memory_.environment(number, direction);
  }

 private:
  pfman::TextureMemory memory_ = pfman::test_textures();
};

/// Numbers of `bytes` bytes in all elements' memory, extended by their sign.
class Memory {
 public:
  explicit Memory(const pixelflow::PixelArray& array) : lanes_(static_cast<std::size_t>(array.lanes())) {
    for (int address = 0; address < pixelflow::kMemoryBytes; ++address) {
      bytes_.emplace_back(lanes_);
      array.read(address, bytes_.back());
    }
  }

  void append(int address, const pfman::Scalar& scalar, reference::RawValues& values) const {
    const int bytes = scalar.bytes();
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      std::uint64_t raw = 0;
      for (int n = 0; n < bytes; ++n)
        raw |= static_cast<std::uint64_t>(bytes_[static_cast<std::size_t>(address + n)][lane]) << (8 * n);
      if (scalar.is_signed && !scalar.is_float && bytes < 8 && raw >> (8 * bytes - 1) != 0) raw |= ~0ull << (8 * bytes);
      values.push_back(raw);
    }
  }

 private:
  std::size_t lanes_;
  std::vector<std::vector<std::uint8_t>> bytes_;
};

reference::ParameterValues values_of(const std::map<std::string, pfman::Raw>& raw) { return {raw.begin(), raw.end()}; }

class Reference : public testing::TestWithParam<std::string> {};

TEST_P(Reference, ColoursAreEqualToTheLastBit) {
  const Scene scene = make_scene(GetParam());
  std::string text = "#include \"" + GetParam() + ".pfman\"\n";
  for (const Compiled& unit : scene.light_units) text += "#include \"" + unit.shader().shader->name + ".pfman\"\n";
  pfman::Diagnostics diagnostics;
  const pfman::ast::Unit unit = pfman::parse_text(text, std::string(PFMAN_SHADERS) + "/all.pfman", {}, diagnostics);
  ASSERT_EQ(diagnostics.text(), "");

  const pfman::TestSurface surface(scene.view);
  pfman::Instance placed = scene.instance.front();
  surface.place(placed);
  const TestTextures textures;
  reference::Input input;
  input.textures = &textures;
  input.uniform = values_of(placed.uniforms());
  input.varying = values_of(placed.bound());
  if (const auto time = input.uniform.find("px_shader_time"); time != input.uniform.end()) input.time = 1.25f;
  for (const pfman::Instance& light : scene.lights)
    input.lights.push_back({light.shader().shader->name, values_of(light.uniforms())});

  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, pixelflow::kElements);
  int compared = 0;
  for (const int row : {120, 250, 380}) {
    surface.fill(placed, 192, row, *array);
    const Memory memory(*array);
    input.lanes = array->lanes();
    input.position.clear();
    for (int n = 0; n < 3; ++n) memory.append(pfman::kPositionAt + 4 * n, pfman::Scalar::floating(), input.position);
    for (const pfman::TransferEntry& entry : pfman::transfer_map(placed.shader()).entries) {
      if (!placed.is_ordinary(entry.name)) continue;
      reference::RawValues& values = input.varying[entry.name];
      values.clear();
      for (int n = 0; n < entry.type.count(); ++n)
        memory.append(entry.address + n * entry.type.scalar.bytes(), entry.type.scalar, values);
    }
    const reference::SurfaceResult expected = reference::Interpreter(unit).surface(GetParam(), input);
    const Shaded shaded = shade(surface, scene.instance.front(), scene.lights, 192, row, *array);
    const std::size_t lanes = shaded.ids.size();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (shaded.ids[lane] == 0) continue;
      ++compared;
      for (std::size_t n = 0; n < 3; ++n) {
        ASSERT_EQ(shaded.color[n * lanes + lane], expected.color[n * lanes + lane])
            << "row " << row << ", element " << lane << ", component " << n;
      }
    }
  }
  EXPECT_GT(compared, 200);
}

INSTANTIATE_TEST_SUITE_P(Project, Reference, testing::ValuesIn(surface_files()),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace shader_tests
