#include "program/pixelflow_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "pixelflow/microcode/library.h"
#include "program/tables.h"

namespace program {
namespace {

using pixelflow::Code;
using pixelflow::Operation;

constexpr int kD = 16, kA = 24, kB = 40, kWork = 64;  // where operands lie in an element's memory
constexpr int kBatches = 16;                          // runs with new operands in every element

/// What a result should be, from the raw operands; the error of `raw`, the result, in units of its last place.
using Error = std::function<double(std::uint64_t raw, std::uint64_t a, std::uint64_t b)>;

struct Measured {
  std::uint64_t cycles = 0;  ///< of one run
  double error = 0;
  int workspace = 0;
};

/// A random operand of so many bytes; floats of all exponents, and every other one near one.
std::uint64_t random_operand(std::mt19937_64& random, int bytes, bool is_float) {
  std::uint64_t raw = random() >> (64 - 8 * bytes);
  if (is_float && random() % 2) raw = (raw & 0x807FFFFF) | (112 + random() % 30) << 23;
  return raw;
}

class Meter {
 public:
  explicit Meter(pixelflow::PixelArray& array) : array_(array) {
    pixelflow::Program enable;
    pixelflow::append_instructions(enable,
                                   [](pixelflow::Assembler& a) { a.flag(pixelflow::Flag::E, pixelflow::Bit::One); });
    array_.run(enable);
  }

  /// Cycles are those of one run by the array's counters; they cannot depend on the operands.
  Measured measure(Operation operation, bool floats, const Error& error) {
    operation.d.address = kD;
    operation.a.address = kA;
    operation.b.address = kB;
    operation.work = kWork;
    pixelflow::Program program;
    pixelflow::append(program, operation);
    Measured result;
    result.workspace = pixelflow::workspace_bytes(operation);
    const auto lanes = static_cast<std::size_t>(array_.lanes());
    std::vector<std::uint64_t> a(lanes), b(lanes), d(lanes);
    for (int batch = 0; batch < kBatches; ++batch) {
      for (auto& raw : a) raw = random_operand(random_, operation.a.bytes, floats);
      for (auto& raw : b) raw = random_operand(random_, operation.b.bytes, floats);
      put(kA, operation.a.bytes, a);
      put(kB, operation.b.bytes, b);
      const std::uint64_t before = array_.counters().cycles;
      array_.run(program);
      result.cycles = array_.counters().cycles - before;
      get(kD, operation.d.bytes, d);
      for (std::size_t n = 0; error && n < lanes; ++n) result.error = std::max(result.error, error(d[n], a[n], b[n]));
    }
    return result;
  }

 private:
  void put(int address, int bytes, const std::vector<std::uint64_t>& values) {
    row_.resize(values.size());
    for (int n = 0; n < bytes; ++n) {
      for (std::size_t lane = 0; lane < values.size(); ++lane)
        row_[lane] = static_cast<std::uint8_t>(values[lane] >> (8 * n));
      array_.write(address + n, row_);
    }
  }
  void get(int address, int bytes, std::vector<std::uint64_t>& values) {
    row_.resize(values.size());
    std::fill(values.begin(), values.end(), 0);
    for (int n = 0; n < bytes; ++n) {
      array_.read(address + n, row_);
      for (std::size_t lane = 0; lane < values.size(); ++lane)
        values[lane] |= static_cast<std::uint64_t>(row_[lane]) << (8 * n);
    }
  }

  pixelflow::PixelArray& array_;
  std::mt19937_64 random_{1998};
  std::vector<std::uint8_t> row_;
};

double as_float(std::uint64_t raw) { return std::bit_cast<float>(static_cast<std::uint32_t>(raw)); }

/// Distance of a float from a value, in units of the float's last place at that value.
double float_error(std::uint64_t raw, long double exact) {
  const double got = as_float(raw);
  if (std::isnan(exact)) return std::isnan(got) ? 0 : INFINITY;
  // Infinity stands for all that would round to 2^128.
  const long double bounded = std::isinf(got) ? std::copysign(0x1p128L, static_cast<long double>(got)) : got;
  if (std::isinf(exact)) return std::isinf(got) && std::signbit(exact) == std::signbit(got) ? 0 : INFINITY;
  if (std::isinf(got) && std::fabs(exact) >= 0x1p128L) return std::signbit(exact) == std::signbit(got) ? 0 : INFINITY;
  const int exponent = exact == 0 ? -126 : std::clamp(std::ilogb(exact), -126, 127);
  return static_cast<double>(std::fabs(bounded - exact) / std::ldexp(1.0L, exponent - 23));
}

using FloatFunction = std::function<long double(long double, long double)>;

Error float_errors(FloatFunction exact) {
  return [exact = std::move(exact)](std::uint64_t raw, std::uint64_t a, std::uint64_t b) {
    return float_error(raw, exact(as_float(a), as_float(b)));
  };
}

/// Fixed point is exact or floored: an error counts whole units.
Error fixed_errors(std::function<std::uint64_t(std::uint64_t, std::uint64_t)> exact) {
  return [exact = std::move(exact)](std::uint64_t raw, std::uint64_t a, std::uint64_t b) {
    const std::uint64_t want = exact(a, b);
    return static_cast<double>(raw > want ? raw - want : want - raw);
  };
}

std::uint64_t floor_root(std::uint64_t a, int scale) {
  __extension__ typedef unsigned __int128 Wide;
  const Wide radicand = static_cast<Wide>(a) << scale;
  std::uint64_t root = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const Wide next = root | 1ull << bit;
    if (next * next <= radicand) root = static_cast<std::uint64_t>(next);
  }
  return root;
}

/// The published figure of a row and column of tables/pixelflow.json, none where the paper has none.
Cell published(const nlohmann::json& file, const char* section, const std::string& name, const std::string& column) {
  Cell cell;
  cell.name = name;
  cell.column = column;
  const auto& table = file.at(section);
  if (!table.contains(name)) return cell;
  const auto& columns = table.at("columns");
  const auto at = std::find(columns.begin(), columns.end(), column);
  if (at == columns.end()) return cell;
  const auto& value = table.at(name).at(static_cast<std::size_t>(at - columns.begin()));
  if (!value.is_null()) cell.published = value.get<double>();
  return cell;
}

void fill(Cell& cell, const Measured& measured, bool has_error) {
  cell.measured = static_cast<double>(measured.cycles);
  cell.workspace_bytes = measured.workspace;
  if (has_error) cell.max_error_ulp = measured.error;
}

Operation operation(Code code, int bytes, int scale = 0) {
  Operation o;
  o.code = code;
  for (auto* operand : {&o.d, &o.a, &o.b}) {
    operand->bytes = static_cast<std::uint8_t>(bytes);
    operand->is_signed = false;
  }
  o.scale = scale;
  return o;
}

void add_fixed(Table& table, Meter& meter, const nlohmann::json& file, int bytes) {
  const int bits = 8 * bytes;
  const std::string column = fmt::format("fixed{}", bits);
  const std::uint64_t mask = (1ull << bits) - 1;
  const auto row = [&](const char* name, Operation o, const Error& error, const char* note = "") {
    Cell cell = published(file, "table2_operation_cycles", name, column);
    cell.note = note;
    fill(cell, meter.measure(o, false, error), static_cast<bool>(error));
    table.cells.push_back(cell);
  };
  row("add", operation(Code::Add, bytes), fixed_errors([=](auto a, auto b) { return (a + b) & mask; }));
  row("subtract", operation(Code::Sub, bytes), fixed_errors([=](auto a, auto b) { return (a - b) & mask; }));
  Operation multiply = operation(Code::Multiply, bytes);
  multiply.d.bytes = static_cast<std::uint8_t>(2 * bytes);
  row("multiply", multiply, fixed_errors([](auto a, auto b) { return a * b; }), "the whole product");
  row("divide", operation(Code::Divide, bytes), fixed_errors([](auto a, auto b) { return b ? a / b : 0; }));
  row("remainder", operation(Code::Remainder, bytes), fixed_errors([](auto a, auto b) { return b ? a % b : 0; }));
  row("sqrt", operation(Code::SquareRoot, bytes, bits), fixed_errors([=](auto a, auto) { return floor_root(a, bits); }),
      "of a pure fraction: a bit of the root for each of the operand");
  row("less", operation(Code::Less, bytes), {});
  if (bytes != 2) return;
  const char* notes[] = {"one dimension", "two dimensions", "three dimensions"};
  for (int dimensions = 1; dimensions <= 3; ++dimensions) {
    Operation noise = operation(Code::NoiseFixed, bytes, dimensions);
    noise.a.is_signed = true;
    row(dimensions == 1 ? "noise" : dimensions == 2 ? "noise_2d" : "noise_3d", noise, {}, notes[dimensions - 1]);
  }
}

void add_float(Table& table, Meter& meter, const nlohmann::json& file) {
  const auto row = [&](const char* name, const Operation& o, const Error& error, const char* note = "") {
    Cell cell = published(file, "table2_operation_cycles", name, "float32");
    cell.note = note;
    fill(cell, meter.measure(o, true, error), static_cast<bool>(error));
    table.cells.push_back(cell);
  };
  const auto plain = [](Code code) { return operation(code, 4); };
  const auto flushing = [](Code code) {
    Operation o = operation(code, 4);
    o.flush = true;
    return o;
  };
  row("add", plain(Code::FloatAdd), float_errors([](auto a, auto b) { return a + b; }));
  row("subtract", plain(Code::FloatSub), float_errors([](auto a, auto b) { return a - b; }));
  row("multiply", plain(Code::FloatMultiply), float_errors([](auto a, auto b) { return a * b; }));
  row("divide", plain(Code::FloatDivide), float_errors([](auto a, auto b) { return a / b; }));
  row("sqrt", plain(Code::FloatSquareRoot), float_errors([](auto a, auto) { return std::sqrt(a); }));
  row("less", plain(Code::FloatLess), {});
  row("add_flush", flushing(Code::FloatAdd), {}, "subnormal numbers as zeros");
  row("multiply_flush", flushing(Code::FloatMultiply), {}, "subnormal numbers as zeros");
  row("divide_flush", flushing(Code::FloatDivide), {}, "subnormal numbers as zeros");
  row("sqrt_flush", flushing(Code::FloatSquareRoot), {}, "subnormal numbers as zeros");
  const char* notes[] = {"one dimension", "two dimensions", "three dimensions"};
  for (int dimensions = 1; dimensions <= 3; ++dimensions) {
    row(dimensions == 1   ? "noise"
        : dimensions == 2 ? "noise_2d"
                          : "noise_3d",
        operation(Code::NoiseFloat, 4, dimensions), {}, notes[dimensions - 1]);
  }
  // Conversions of 32-bit fixed point with 16 fraction bits.
  Operation to_float = operation(Code::FixedToFloat, 4, 16), to_fixed = operation(Code::FloatToFixed, 4, 16);
  to_float.a.is_signed = to_fixed.d.is_signed = true;
  row("fixed_to_float", to_float, [](std::uint64_t raw, std::uint64_t a, std::uint64_t) {
    return float_error(raw, std::ldexp(static_cast<long double>(static_cast<std::int32_t>(a)), -16));
  });
  row("float_to_fixed", to_fixed, [](std::uint64_t raw, std::uint64_t a, std::uint64_t) {
    const double value = as_float(a);
    const double floored = std::isnan(value) ? 0 : std::clamp(std::floor(value * 65536), -0x1p31, 0x1p31 - 1);
    return std::fabs(static_cast<double>(static_cast<std::int32_t>(raw)) - floored);
  });
}

struct Function {
  const char* name;
  Code exact, fast;
  long double (*value)(long double, long double);
};

constexpr Code kNone = Code::Count;

const Function kFunctions[] = {
    {"sin", Code::Sin, Code::FastSin, [](long double a, long double) { return std::sin(a); }},
    {"cos", Code::Cos, Code::FastCos, [](long double a, long double) { return std::cos(a); }},
    {"tan", Code::Tan, Code::FastTan, [](long double a, long double) { return std::tan(a); }},
    {"asin", Code::Asin, Code::FastAsin, [](long double a, long double) { return std::asin(a); }},
    {"acos", Code::Acos, Code::FastAcos, [](long double a, long double) { return std::acos(a); }},
    {"atan", Code::Atan, Code::FastAtan, [](long double a, long double) { return std::atan(a); }},
    {"atan2", Code::Atan2, Code::FastAtan2, [](long double a, long double b) { return std::atan2(a, b); }},
    {"exp", Code::Exp, Code::FastExp, [](long double a, long double) { return std::exp(a); }},
    {"exp2", Code::Exp2, Code::FastExp2, [](long double a, long double) { return std::exp2(a); }},
    {"log", Code::Log, Code::FastLog, [](long double a, long double) { return std::log(a); }},
    {"log2", Code::Log2, Code::FastLog2, [](long double a, long double) { return std::log2(a); }},
    {"inversesqrt", Code::InverseSquareRoot, kNone, [](long double a, long double) { return 1 / std::sqrt(a); }},
    {"pow", Code::Pow, kNone, [](long double a, long double b) { return std::pow(a, b); }},
};

}  // namespace

Table pixelflow2(pixelflow::PixelArray& array, const std::filesystem::path& tables) {
  const nlohmann::json file = read_table_file(tables / "pixelflow.json");
  Table table{"pixelflow2", "Olano and Lastra 1998, table 2: cycles of fixed and floating point operations", {}};
  Meter meter(array);
  add_fixed(table, meter, file, 2);
  add_fixed(table, meter, file, 4);
  add_float(table, meter, file);
  return table;
}

Table pixelflow3(pixelflow::PixelArray& array, const std::filesystem::path& tables) {
  const nlohmann::json file = read_table_file(tables / "pixelflow.json");
  const nlohmann::json accuracy = read_table_file(tables / "pixelflow_accuracy.json");
  Table table{"pixelflow3", "Olano and Lastra 1998, table 3: cycles of floating point functions", {}};
  Meter meter(array);
  for (const Function& function : kFunctions) {
    for (const auto& [column, code] : {std::pair("exact", function.exact), std::pair("fast", function.fast)}) {
      if (code == kNone) continue;
      Cell cell = published(file, "table3_float_function_cycles", function.name, column);
      const Measured measured = meter.measure(operation(code, 4), true, float_errors(function.value));
      fill(cell, measured, true);
      const std::string recorded = (column == std::string("fast") ? "fast_" : "") + std::string(function.name);
      if (accuracy.contains(recorded)) {
        cell.max_error_ulp = std::max(measured.error, accuracy.at(recorded).at("max_error_ulp").get<double>());
        cell.note = accuracy.at(recorded).value("inputs", "");
      }
      table.cells.push_back(cell);
    }
  }
  return table;
}

std::string pixelflow_text(const Table& table) {
  std::string text = table.source + "\n\n";
  text += fmt::format("{:16}{:9}{:>10}{:>10}{:>7}{:>12}{:>11}  {}\n", "name", "column", "published", "measured",
                      "ratio", "error, ulp", "workspace", "");
  for (const Cell& cell : table.cells) {
    const auto ratio = cell.ratio();
    const std::string error = !cell.max_error_ulp          ? "-"
                              : *cell.max_error_ulp < 1000 ? fmt::format("{:.4g}", *cell.max_error_ulp)
                                                           : fmt::format("{:.2e}", *cell.max_error_ulp);
    text +=
        fmt::format("{:16}{:9}{:>10}{:>10}{:>7}{:>12}{:>11}  {}\n", cell.name, cell.column, number_text(cell.published),
                    number_text(cell.measured), ratio ? fmt::format("{:.2f}", *ratio) : "-", error,
                    cell.workspace_bytes ? std::to_string(*cell.workspace_bytes) : "-", cell.note);
  }
  return text;
}

}  // namespace program
