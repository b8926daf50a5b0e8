#include "tests/pfman_lower/agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cmodel/pixelflow/pixel_array.h"
#include "pixelflow/compiler/generate.h"
#include "pixelflow/compiler/memory_layout.h"
#include "tests/pixelflow_model/seed.h"
#include "tests/reference/interpreter.h"

namespace lower_tests {
namespace {

using reference::Number;
using reference::Raw;
using reference::RawValues;

constexpr int kLanes = 192;

Raw random_raw(Random& random, const Number& number) {
  if (number.floating) {
    static const std::vector<Raw> hard{0x00000000, 0x80000000, 0x00000001, 0x80000001, 0x007FFFFF, 0x00800000,
                                       0x3F800000, 0xBF800000, 0x3F000000, 0xBF000000, 0x3EFFFFFF, 0x3F7FFFFF,
                                       0x40490FDB, 0x4B000000, 0xCB000000, 0x4AFFFFFF, 0xCAFFFFFF, 0x4B7FFFFF,
                                       0x7F7FFFFF, 0xFF7FFFFF, 0x7F800000, 0xFF800000, 0x7FC00000, 0x41200000};
    switch (between(random, 0, 3)) {
      case 0: return one_of(random, hard);
      case 1: return reference::float_bits(reference::as_float(random() & 0xFFFFFFFF));
      case 2: return reference::float_bits(static_cast<float>(between(random, -4000, 4000)) / 256.0f);
      default: return reference::float_bits(static_cast<float>(between(random, -1000000, 1000000)) / 1000000.0f);
    }
  }
  const Raw all = ~Raw{0} >> (64 - number.size);
  Raw raw = 0;
  switch (between(random, 0, 3)) {
    case 0: raw = static_cast<Raw>(between(random, -2, 2)); break;
    case 1: raw = (all >> (number.is_signed ? 1 : 0)) + static_cast<Raw>(between(random, -1, 1)); break;
    case 2: raw = random() >> between(random, 0, 63); break;
    default: raw = random();
  }
  return reference::wrapped(raw, number);
}

RawValues random_values(Random& random, const Number& number, int count) {
  RawValues values;
  for (int n = 0; n < count; ++n) values.push_back(random_raw(random, number));
  return values;
}

std::string errors_of(const pfman::Diagnostics& diagnostics) {
  std::string all;
  for (const pfman::Diagnostic& one : diagnostics.all()) {
    if (one.is_error()) all += diagnostics.text(one) + "\n";
  }
  return all;
}

bool has_code(const pfman::Diagnostics& diagnostics, int code) {
  return std::any_of(diagnostics.all().begin(), diagnostics.all().end(),
                     [&](const pfman::Diagnostic& one) { return one.code == code; });
}

struct Inputs {
  reference::Input input;
  pfman::GenerateInput given;
};

Inputs random_inputs(const reference::Interpreter& interpreter, Random& random) {
  Inputs inputs;
  inputs.input.lanes = kLanes;
  inputs.input.position = random_values(random, reference::kFloat, 3 * kLanes);
  for (const reference::ParameterInfo& parameter : interpreter.parameters("s")) {
    if (parameter.output || parameter.name.starts_with("px_")) continue;
    if (!parameter.uniform) {
      inputs.input.varying[parameter.name] = random_values(random, parameter.number, parameter.elements * kLanes);
    } else if (!parameter.name.starts_with("k_")) {  // those have their defaults
      const RawValues values = random_values(random, parameter.number, parameter.elements);
      inputs.input.uniform[parameter.name] = inputs.given.uniforms[parameter.name] = values;
    }
  }
  return inputs;
}

void put(pixelflow::PixelArray& array, int address, int bytes, const Raw* raw) {
  std::vector<std::uint8_t> row(kLanes);
  for (int byte = 0; byte < bytes; ++byte) {
    for (int lane = 0; lane < kLanes; ++lane) {
      row[static_cast<std::size_t>(lane)] = static_cast<std::uint8_t>(raw[lane] >> (8 * byte));
    }
    array.write(address + byte, row);
  }
}

/// px_shader_color, component after component.
RawValues processors_result(const pfman::CompiledShader& shader, const Inputs& inputs) {
  const pfman::Streams streams = pfman::generate(shader, inputs.given);
  const auto array = pixelflow::make_golden_array(pixelflow::Level::Macro, kLanes);
  int address = pfman::kParametersAt;
  for (const pfman::ShaderParameter& parameter : shader.shader->parameters) {
    const pfman::Variable& variable = *parameter.variable;
    const auto values = inputs.input.varying.find(variable.name);
    if (values == inputs.input.varying.end()) continue;
    for (int n = 0; n < variable.type.count(); ++n) {
      const int bytes = variable.type.scalar.bytes();
      put(*array, address, bytes, values->second.data() + n * kLanes);
      address += bytes;
    }
  }
  for (int n = 0; n < 3; ++n) put(*array, pfman::kPositionAt + 4 * n, 4, inputs.input.position.data() + n * kLanes);
  for (const pfman::Stream::Part& part : streams.pre.parts) array->run(part.program);
  RawValues result;
  for (const int color : shader.code.color) {
    const pfman::Scalar& scalar = shader.code.variables[static_cast<std::size_t>(color)].scalar;
    RawValues raw(kLanes);
    std::vector<std::uint8_t> row(kLanes);
    for (int byte = 0; byte < scalar.bytes(); ++byte) {
      array->read(shader.map.address[static_cast<std::size_t>(color)] + byte, row);
      for (std::size_t lane = 0; lane < kLanes; ++lane) raw[lane] |= Raw{row[lane]} << (8 * byte);
    }
    // The stored bytes are compared with what their type's numbers look like in memory.
    const int unused = 64 - 8 * scalar.bytes();
    for (Raw& value : raw) {
      if (scalar.is_signed && !scalar.is_float) {
        value = static_cast<Raw>(static_cast<std::int64_t>(value << unused) >> unused);
      }
      result.push_back(value);
    }
  }
  return result;
}

std::string hex(Raw value) {
  std::ostringstream out;
  out << "0x" << std::hex << value;
  return out.str();
}

std::string difference(const RawValues& found, const RawValues& expected, const Inputs& inputs) {
  for (std::size_t n = 0; n < expected.size(); ++n) {
    if (found[n] == expected[n]) continue;
    const std::size_t lane = n % kLanes;
    std::string text = "component " + std::to_string(n / kLanes) + " of lane " + std::to_string(lane) + " is " +
                       hex(found[n]) + ", expected " + hex(expected[n]) + ";";
    for (const auto& [name, values] : inputs.input.varying) {
      for (std::size_t at = lane; at < values.size(); at += kLanes) text += " " + name + " = " + hex(values[at]);
    }
    for (const auto& [name, values] : inputs.input.uniform) {
      for (const Raw value : values) text += " " + name + " = " + hex(value);
    }
    return text;
  }
  return "";
}

}  // namespace

Agreement compare(const std::string& text, std::uint64_t seed) {
  using Kind = Agreement::Kind;
  pfman::Diagnostics parsed;
  const pfman::ast::Unit unit = pfman::parse_text(text, "test.pfman", {}, parsed);
  if (parsed.has_errors()) return {Kind::Differs, errors_of(parsed)};
  const reference::Interpreter interpreter(unit);
  Random random(seed);
  Inputs inputs;
  RawValues expected;
  int refused = -1;
  std::string reason;
  try {
    inputs = random_inputs(interpreter, random);
    expected = interpreter.surface("s", inputs.input).raw;
  } catch (const reference::Error& error) {
    refused = error.code;
    reason = error.what();
  }
  for (const bool fuse : {true, false}) {
    pfman::Options options;
    options.fuse = options.drop_unused = options.join_copies = fuse;
    const std::string way = fuse ? "" : "not fused: ";
    pfman::Diagnostics diagnostics;
    const auto compiled = pfman::compile_text(text, "test.pfman", options, diagnostics);
    if (diagnostics.has_errors()) {
      if (has_code(diagnostics, 501) || has_code(diagnostics, 502)) return {Kind::TooLarge, ""};
      if (refused > 0 && has_code(diagnostics, refused)) return {Kind::Refused, ""};
      return {Kind::Differs, way + errors_of(diagnostics) + reason};
    }
    try {
      const RawValues found = processors_result(*compiled->find("s"), inputs);
      if (refused >= 0) return {Kind::Differs, way + "it runs, expected " + reason};
      const std::string wrong = difference(found, expected, inputs);
      if (!wrong.empty()) return {Kind::Differs, way + wrong};
    } catch (const pfman::UniformError& error) {
      if (refused >= 0) return {Kind::Refused, ""};
      return {Kind::Differs, way + diagnostics.place(error.where) + ": " + error.what()};
    }
  }
  return {};
}

bool agrees(const std::string& text, std::uint64_t seed) {
  const Agreement agreement = compare(text, seed);
  EXPECT_NE(agreement.kind, Agreement::Kind::Differs) << agreement.text << "\n"
                                                      << text << "\n"
                                                      << pixelflow_tests::replay(seed);
  return agreement.kind == Agreement::Kind::Agrees;
}

std::string surface(const std::string& result, const std::string& parameters, const std::vector<std::string>& results,
                    const std::string& before, const std::string& functions) {
  std::string text =
      functions + "surface s(output varying " + result + " px_shader_color[3], " + parameters + ") {\n" + before;
  for (std::size_t n = 0; n < 3; ++n) {
    text += "  px_shader_color[" + std::to_string(n) + "] = " + results[std::min(n, results.size() - 1)] + ";\n";
  }
  return text + "}\n";
}

int between(Random& random, int first, int last) {
  return first + static_cast<int>(random() % static_cast<std::uint64_t>(last - first + 1));
}

Number random_fixed(Random& random, int most_bits) {
  const bool is_signed = between(random, 0, 1) == 1;
  int size = between(random, is_signed ? 2 : 1, most_bits);
  if (between(random, 0, 3) == 0) size = std::max(most_bits - between(random, 0, 2), 2);
  if (between(random, 0, 3) == 0) size = std::min(8 * between(random, 1, 8), most_bits);
  int exponent = between(random, 0, size);
  if (between(random, 0, 2) == 0) exponent = between(random, -12, size + 12);
  return {false, is_signed, size, exponent};
}

std::string declared(const Number& number) {
  if (number.floating) return "float";
  return std::string(number.is_signed ? "signed " : "") + "fixed<" + std::to_string(number.size) + "," +
         std::to_string(number.exponent) + ">";
}

}  // namespace lower_tests
