#include "tests/random_shaders/runner.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/language/parser.h"
#include "pixelflow/shading/shading_node.h"

namespace random_shaders {
namespace {

using pixelflow::PixelArray;
using reference::Raw;
using reference::RawValues;

/// What both sides are given.
struct Values {
  reference::Input input;
  reference::ParameterValues alone;  ///< uniform parameters of a light that is tested alone
  std::uint64_t rubbish = 0;         ///< what memory holds before
};

/// The images that shaders look up: pictures of random texels, shared by both sides.
class Pictures : public reference::Textures {
 public:
  Pictures() {
    Random random(1);
    for (int number = 0; number < 2; ++number) {
      pfman::TextureMemory::Image texture{4 << number, 4, {}};
      for (int n = 0; n < 4 * texture.width * texture.height; ++n) {
        texture.rgba.push_back(static_cast<std::uint8_t>(random.bits() >> 32));
      }
      memory_.set(number, std::move(texture));
    }
  }
  std::array<std::uint8_t, 4> look_up(std::int64_t number, float s, float t) const override {
    return memory_.lookup(number, s, t);
  }
  std::array<std::uint8_t, 4> environment(std::int64_t number, std::array<float, 3> direction) const override {
    return memory_.environment(number, direction);
  }
  const pfman::TextureMemory& memory() const { return memory_; }

 private:
  pfman::TextureMemory memory_;
};

const Pictures& pictures() {
  static const Pictures kPictures;
  return kPictures;
}

Values random_input(const reference::Interpreter& interpreter, const Program& program, std::uint64_t seed) {
  Random random(seed ^ 0x9E3779B97F4A7C15u);
  Values values;
  reference::Input& input = values.input;
  input.lanes = kLanes;
  input.textures = &pictures();
  input.position = random_values(random, reference::kFloat, 3 * kLanes);
  const auto uniform_of = [&](const std::string& shader) {
    reference::ParameterValues given;
    for (const reference::ParameterInfo& parameter : interpreter.parameters(shader)) {
      if (parameter.uniform && (parameter.name.starts_with("px_") || !random.one_in(4)))
        given[parameter.name] = random_values(random, parameter.number, parameter.elements);
    }
    return given;
  };
  if (!program.surface.empty()) {
    input.uniform = uniform_of(program.surface);
    for (const reference::ParameterInfo& parameter : interpreter.parameters(program.surface)) {
      if (parameter.uniform || parameter.output) continue;
      if (parameter.name == "px_shader_position" || parameter.name == "px_shader_view") continue;
      // Most come with the pixels, some are bound, some keep their default.
      const int kind = parameter.name.starts_with("px_") ? 2 : random.below(8);
      if (kind == 0) continue;
      input.varying[parameter.name] =
          random_values(random, parameter.number, parameter.elements * (kind == 1 ? 1 : kLanes));
    }
  }
  for (const std::string& light : program.lights) input.lights.push_back({light, uniform_of(light)});
  if (program.surface.empty()) values.alone = input.lights.front().uniform;
  values.rubbish = random.bits();
  return values;
}

/// Bytes of an array's memory, lane by lane.
void put(PixelArray& array, int address, int bytes, const Raw* raw) {
  std::vector<std::uint8_t> column(kLanes);
  for (int n = 0; n < bytes; ++n) {
    for (int lane = 0; lane < kLanes; ++lane) {
      column[static_cast<std::size_t>(lane)] = static_cast<std::uint8_t>(raw[lane] >> (8 * n));
    }
    array.write(address + n, column);
  }
}

std::vector<std::uint8_t> get(const PixelArray& array, int address, int bytes) {
  std::vector<std::uint8_t> all(static_cast<std::size_t>(bytes * kLanes));
  for (int n = 0; n < bytes; ++n) {
    array.read(address + n, std::span(all).subspan(static_cast<std::size_t>(n * kLanes), kLanes));
  }
  return all;
}

std::unique_ptr<PixelArray> filled_array(const Way& way, const Values& values) {
  std::unique_ptr<PixelArray> array = way.make_array();
  Random random(values.rubbish);
  std::vector<std::uint8_t> column(kLanes);
  for (int address = 0; address < 256; ++address) {
    for (std::uint8_t& byte : column) byte = static_cast<std::uint8_t>(random.bits() >> 32);
    array->write(address, column);
  }
  for (int n = 0; n < 3; ++n) put(*array, pfman::kPositionAt + 4 * n, 4, values.input.position.data() + n * kLanes);
  return array;
}

void set_uniforms(pfman::Instance& instance, const reference::ParameterValues& given) {
  for (const auto& [name, raw] : given) instance.set_raw(name, raw);
}

/// The picture's colour: three bytes a lane, component by component.
std::vector<std::uint8_t> shade(const pfman::CompiledUnit& unit, const Program& program, const Values& values,
                                const Way& way) {
  pfman::Instance surface(*unit.find(program.surface), 1);
  set_uniforms(surface, values.input.uniform);
  for (const auto& [name, raw] : values.input.varying) {
    if (raw.size() % kLanes == 0) {
      surface.make_ordinary(name);
    } else {
      surface.set_raw(name, raw);
    }
  }
  std::vector<pfman::Instance> lights;
  for (const reference::LightInput& light : values.input.lights) {
    lights.emplace_back(*unit.find(light.shader), static_cast<int>(lights.size()));
    set_uniforms(lights.back(), light.uniform);
  }
  const std::unique_ptr<PixelArray> array = filled_array(way, values);
  const std::vector<Raw> ids(kLanes, 1);
  put(*array, pfman::kShaderIdAt, pfman::kShaderIdBytes, ids.data());
  for (const pfman::TransferEntry& entry : pfman::transfer_map(*unit.find(program.surface)).entries) {
    const auto given = values.input.varying.find(entry.name);
    if (given == values.input.varying.end() || given->second.size() % kLanes != 0) continue;
    const int bytes = entry.type.scalar.bytes();
    for (int n = 0; n < entry.type.count(); ++n) {
      put(*array, entry.address + n * bytes, bytes, given->second.data() + n * kLanes);
    }
  }
  std::vector<pfman::Instance> surfaces{surface};
  pfman::ShadingNode node(std::move(surfaces), std::move(lights), &pictures().memory());
  node.shade(*array);
  return get(*array, pfman::kColorAt, 3);
}

/// The communication area after a light.
std::vector<std::uint8_t> light(const pfman::CompiledUnit& unit, const Program& program, const Values& values,
                                const Way& way) {
  pfman::Instance instance(*unit.find(program.lights.front()), 0);
  set_uniforms(instance, values.alone);
  const pfman::Streams streams = pfman::generate(
      instance.shader(),
      {.uniforms = instance.uniforms(), .bound_varying = instance.bound(), .shader_ids = {}, .lights = 1});
  const std::unique_ptr<PixelArray> array = filled_array(way, values);
  array->write(pfman::kMaskAt, std::vector<std::uint8_t>(kLanes));
  for (const pfman::Stream::Part& part : streams.pre.parts) array->run(part.program);
  return get(*array, pfman::kLightDirectionAt, 24);
}

struct Expected {
  std::vector<std::uint8_t> bytes;  ///< byte by byte of all lanes
  int refused = -1;                 ///< an error's code
  std::string text;
};

void append_bytes(std::vector<std::uint8_t>& bytes, const RawValues& raw) {
  for (std::size_t n = 0; n < raw.size() / kLanes; ++n) {
    for (int shift = 0; shift < 16; shift += 8) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        bytes.push_back(static_cast<std::uint8_t>(raw[n * kLanes + lane] >> shift));
      }
    }
  }
}

Expected expected_of(const reference::Interpreter& interpreter, const Program& program, std::uint64_t seed,
                     Values& values) {
  Expected expected;
  try {
    interpreter.resolve_all();
    values = random_input(interpreter, program, seed);
    if (!program.surface.empty()) {
      expected.bytes = interpreter.surface(program.surface, values.input).color;
    } else {
      const auto lit = interpreter.light(program.lights.front(), values.alone, values.input);
      for (const RawValues* part : {&lit.direction, &lit.color, &lit.ambient, &lit.specular}) {
        append_bytes(expected.bytes, *part);
      }
    }
  } catch (const reference::Error& error) {
    expected.refused = error.code;
    expected.text = error.what();
  }
  return expected;
}

bool has_code(const pfman::Diagnostics& diagnostics, int code) {
  return std::any_of(diagnostics.all().begin(), diagnostics.all().end(),
                     [&](const pfman::Diagnostic& one) { return one.code == code; });
}

std::string errors_of(const pfman::Diagnostics& diagnostics) {
  std::string all;
  for (const pfman::Diagnostic& one : diagnostics.all()) {
    if (one.is_error()) all += diagnostics.text(one) + "\n";
  }
  return all;
}

std::string difference(const std::vector<std::uint8_t>& found, const std::vector<std::uint8_t>& expected) {
  std::ostringstream out;
  int wrong = 0;
  for (std::size_t n = 0; n < expected.size(); ++n) {
    if (found[n] == expected[n]) continue;
    if (wrong++ == 0) {
      out << "byte " << n / kLanes << " of lane " << n % kLanes << " is " << int{found[n]} << ", expected "
          << int{expected[n]};
    }
  }
  if (wrong > 1) out << " (and " << wrong - 1 << " more)";
  return out.str();
}

}  // namespace

Outcome check(const Program& program, std::uint64_t seed, const std::vector<Way>& ways) {
  using Kind = Outcome::Kind;
  const std::string text = render(program.text);
  pfman::Diagnostics parsed;
  const pfman::ast::Unit unit = pfman::parse_text(text, "random.pfman", {}, parsed);
  if (parsed.has_errors()) return {Kind::Differs, "syntax: " + errors_of(parsed), 0};
  const reference::Interpreter interpreter(unit);
  Values values;
  const Expected expected = expected_of(interpreter, program, seed, values);
  Outcome outcome;
  for (const Way& way : ways) {
    pfman::Diagnostics diagnostics;
    const auto compiled = pfman::compile_text(text, "random.pfman", way.options, diagnostics);
    if (diagnostics.has_errors()) {
      if (has_code(diagnostics, 501) || has_code(diagnostics, 502)) {
        if (&way == &ways.front()) return {Kind::TooLarge, "", 0};
        continue;  // it needs an optimisation
      }
      if (has_code(diagnostics, expected.refused)) return {Kind::TooWide, "", outcome.runs};
      return {Kind::Differs, way.name + ": the compiler refuses it\n" + errors_of(diagnostics) + expected.text, 0};
    }
    if (expected.refused > 0)
      return {Kind::Differs, way.name + ": the compiler takes what is refused: " + expected.text, 0};
    std::vector<std::uint8_t> found;
    try {
      found = program.surface.empty() ? light(*compiled, program, values, way) : shade(*compiled, program, values, way);
    } catch (const pfman::UniformError& error) {
      if (expected.refused == 0) return {Kind::RunTime, "", outcome.runs};
      return {Kind::Differs, way.name + ": " + diagnostics.place(error.where) + ": " + error.what(), 0};
    } catch (const std::invalid_argument& error) {
      if (std::string(error.what()).find("the light needs memory") != std::string::npos) {
        if (&way == &ways.front()) return {Kind::TooLarge, "", 0};
        continue;
      }
      return {Kind::Differs, way.name + ": " + error.what(), 0};
    }
    if (expected.refused == 0) return {Kind::Differs, way.name + ": it runs, expected " + expected.text, 0};
    ++outcome.runs;
    if (found != expected.bytes) {
      outcome.kind = Kind::Differs;
      outcome.text = way.name + ": " + difference(found, expected.bytes);
      return outcome;
    }
  }
  return outcome;
}

}  // namespace random_shaders
