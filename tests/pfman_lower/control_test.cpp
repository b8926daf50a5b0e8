// Statements, arrays and calls.
#include <gtest/gtest.h>

#include "tests/pfman_lower/agreement.h"
#include "tests/pixelflow_model/seed.h"

namespace lower_tests {
namespace {

const std::string kParameters =
    "varying signed fixed<16,4> a = 0, varying signed fixed<16,4> b = 0, varying float f = 0, varying float g = 0, "
    "varying fixed<8,0> v[4] = {0,0,0,0}, uniform fixed<4,0> u = 3, uniform int k_n = 5, uniform int k_i = 1, "
    "uniform int k_j = 2, uniform float k_m[2][3] = {{1,2,3},{4,5,6}}";

void try_bodies(const std::string& result, const std::vector<std::string>& bodies, const std::string& functions = "") {
  const std::uint64_t seed = pixelflow_tests::seed_or(1);
  for (const std::string& body : bodies) {
    for (std::uint64_t repeat = 0; repeat < 3; ++repeat) {
      EXPECT_TRUE(agrees(surface(result, kParameters, {"r", "r2", "r3"},
                                 result + " r = 0, r2 = 0, r3 = 0;\n" + body + "\n", functions),
                         seed + repeat));
    }
  }
}

TEST(LowerStatements, branches) {
  try_bodies(
      "signed fixed<24,4>",
      {"if (a < b) r = a; else r = b; r2 = r + 1;",
       "if (a < b) { r = a; if (b > 0) r2 = b; else r2 = a; } else if (a == b) r3 = 7; else { r3 = a + b; }",
       "if (a) r = 1; if (a < 0 || b < 0) r2 = a; else r2 = b; if (u > 3) r3 = a; else r3 = 2;",
       "if (u % 2 == 0) { if (a < 3) r = a; r2 = 5; } else { r3 = b; if (!(f < g)) r = 9; }",
       "bool c = a < b, d = f <= g; if (c && !d) r = 1; if (c || d) r2 = a; if (c == d) r3 = b;",
       "if (a < b) if (b < 5) if (a < -5) if (f < g) if (g < 1.0) if (v[0] < 100) if (v[1] < 200) r = 1; else r = "
       "2; else r = 3; else r = 4; else r = 5; else r = 6; else r = 7; else r = 8; r2 = r * 2;",
       "r = f < g ? a : b; r2 = u > 2 ? a : b; r3 = (a < b ? a : b) * (f == g ? 2 : 3);"});
}

TEST(LowerStatements, numbers_shifted_within_themselves) {
  try_bodies("signed fixed<24,4>",
             {"signed fixed<19,-2> w = 0; if (u > 5) r2 = 1; else w *= signed fixed<9,9>(0.00390625); if (w) r = 1;",
              "signed fixed<40,8> w = a; if (a < b) w *= fixed<9,9>(0.00390625); r = w; if (w < 0) r2 = 1;",
              "fixed<32,16> w = v[0]; uniform int i; for (i = 0; i < k_i; i++) { if (v[1] > 9) w = w >> 8; } r = w;"});
}

TEST(LowerStatements, loops) {
  try_bodies(
      "signed fixed<24,4>",
      {"uniform int i; for (i = 0; i < k_n; i++) { r += a; r2 = r2 + i; }",
       "uniform int i = 0; while (i < u) { i += 1; if (i == 3) continue; if (i > 6) break; r += b; } r2 = i;",
       "uniform int i = 0; do { r += a; i++; } while (i < u); r3 = i;",
       "uniform int i, j; for (i = 0; i < 4; i++) for (j = 0; j <= i; j++) { r += i * a; if (j == 2) break; r2 += b; }",
       "uniform int i; for (i = 0; i < k_n; i++) { if (r > a) break; r += 8; } r2 = r + 1;",
       "uniform int i; for (i = 0; i < k_n; i++) { if (v[0] > i * 40) continue; r += 1; if (b < r) break; r2 += 2; }",
       "uniform int i; for (i = 0; i < 4; i++) { uniform int j; for (j = 0; j < 3; j++) { if (a < j) break; r += 1; if "
       "(b > j) "
       "continue; r2 += 1; } if (r > 5) continue; r3 += 1; if (r2 > 3) break; r3 += b; }",
       "uniform int i; for (i = 0; i < 6; i++) { if (a < 0) { r += 1; if (r > 3) break; r2 += b; } else { r2 -= 1; if "
       "(f < g) continue; r3 += a; } r3 += 1; }",
       "uniform int i; for (i = 0; i < 3; i++) do { if (v[1] > 100) break; r += 1; if (a > i) continue; r2 += 1; } "
       "while (false); r3 = r;"});
}

TEST(LowerStatements, deep_masks) {
  std::string body;
  for (int n = 0; n < 7; ++n) {
    const std::string i = "i" + std::to_string(n);
    body += "uniform int " + i + "; for (" + i + " = 0; " + i + " < 2; " + i + "++) { if (a < " +
            std::to_string(n * 5 - 20) + ") { r += 1; continue; } else { r2 += b; } if (b > " +
            std::to_string(60 - n * 9) + ") break;\n";
  }
  body += "r3 += 1;";
  for (int n = 0; n < 7; ++n) body += "}";
  try_bodies("signed fixed<24,4>", {body});
}

TEST(LowerArrays, elements) {
  try_bodies(
      "signed fixed<24,4>",
      {"r = v[0]; r2 = v[k_i]; r3 = v[k_i + k_j];",
       "fixed<8,0> w[4] = v; w[k_i] = 7; w[0] = v[3]; w[k_j] += 3; r = w[0]; r2 = w[1] + w[k_j]; r3 = w[3];",
       "fixed<8,0> w[4] = { v[3], v[2], v[1], v[0] }; w = { w[1], w[2], w[3], w[0] }; r = w[0]; r2 = w[1]; r3 = w[3];",
       "fixed<8,0> w[4] = v; uniform int i; for (i = 0; i < 4; i++) { if (w[i] > 100) w[i] = 0; else w[i] += i; r += "
       "w[i]; }",
       "fixed<8,0> w[4] = v + v; w = w * 2 - v; r = w == v; r2 = v != v; r3 = (v == { v[0], v[1], 3, 4 });",
       "fixed<8,0> w[4] = a < b ? v : { 1, 2, 3, 4 }; r = w[0] + w[3]; r2 = w[k_j];"});
  try_bodies(
      "float",
      {"float m[2][3] = k_m; m[1][2] = f; m[k_i][k_i] = g; m[0] = { g, f, 2 }; r = m[k_i][k_j]; r2 = m[1][1]; r3 = "
       "m[0][k_j] + m[k_i][0];",
       "float m[2][3] = { { f, g, 1 }, { 2, 3, f } }; float row[3] = m[k_i]; r = row[2]; r2 = m[0][0] + m[1][0]; m = "
       "k_m; r3 = m[k_i][k_j];",
       "float p[3] = { f, g, 1 }; p = p * 2.0; p = p + { 1, 2, 3 }; p = -p; r = p[0]; r2 = p[1]; r3 = p[2];",
       "float p[3] = { f, g, 1 }; p = { p[2], p[0], p[1] }; r = p[0]; r2 = p[1] * k_m[k_i][k_j]; r3 = p[2];"});
}

TEST(LowerArrays, a_position_in_another_type) {
  // It is a variable of its own; the position as it lies in memory is still what the view is made of.
  const std::string parameters =
      "varying signed fixed<20,8> px_shader_position[3], varying float px_shader_view[3], uniform int k_i = 2";
  const std::vector<std::string> results{"px_shader_position[k_i]", "px_shader_view[k_i]", "px_shader_position[0]"};
  EXPECT_TRUE(agrees(surface("float", parameters, results), pixelflow_tests::seed_or(1)));
  EXPECT_TRUE(agrees(surface("float", "varying float px_shader_position[3], uniform int k_i = 2",
                             {"px_shader_position[k_i]", "px_shader_position[1]", "length(px_shader_position)"}),
                     pixelflow_tests::seed_or(2)));
}

TEST(LowerExpressions, assignments_as_values) {
  try_bodies("signed fixed<24,4>",
             {"r = r2 = a; r3 = (r2 = b) + 1;", "r = a; r2 = r++; r3 = r--; r += r2;",
              "r = a; r += b; r -= 3; r *= 2; r /= 3; r2 = a; r2 %= 7; r3 = a; r3 <<= 2; r3 >>= 1;",
              "uniform int i = 3; r = i++ + a; r2 = i; uniform int j = i++ * 2; r3 = i + j;"});
}

TEST(LowerCalls, functions) {
  const std::string functions =
      "float square(float x) { return x * x; }\n"
      "float twice(float x) { x += x; return x; }\n"
      "void swap(output float x, output float y) { float t = x; x = y; y = t; }\n"
      "uniform int count(uniform int n) { uniform int i, s = 0; for (i = 0; i < n; i++) s += i; return s; }\n"
      "float pick(float p[3], uniform int n) { return p[n]; }\n"
      "void fill(output float p[3], float x) { p = { x, x + 1.0, square(x) }; }\n"
      "void split(float x, output float whole, output float rest) { whole = floor(x); rest = x - whole; }\n"
      "void scale(float x, output float y) { y = y + 1.0; y = y * x; }\n"
      "void count_up(uniform int n, output uniform int m) { m = m + 1; m = m * n; }\n"
      "float limited(float x, float most) { float r = x; if (x > most) r = most; return r; }\n"
      "fixed<8,4> quarter(fixed<8,4> x) { return x / 4; }\n"
      "uniform float table(uniform int n)[1];\n";
  const std::string used = functions.substr(0, functions.rfind("uniform float table"));
  try_bodies(
      "float",
      {"r = square(f); r2 = square(square(g)) + twice(f); r3 = twice(twice(g)) - f;",
       "r = f; r2 = g; swap(r, r2); r3 = r - r2;", "r = f; if (f < g) swap(r, r2); r3 = r2;",
       "r = count(k_n) + f; r2 = count(count(3) + 1); r3 = k_n > 2 && count(k_n) > 5 ? 1.0f : f;",
       "float p[3] = { f, g, 3 }; r = pick(p, 1); r2 = pick({ g, f, 2 }, k_j); r3 = pick(p, k_i);",
       "float p[3]; fill(p, f); r = p[0] + p[1]; r2 = p[2]; float q[3]; if (g > 0) fill(q, g); else fill(q, 1); r3 = "
       "q[2];",
       "split(f, r, r2); float s[2] = { 0, 0 }; split(g, s[1], s[0]); r3 = s[1] * 2.0 + s[0];",
       "r = f; scale(r, r); r2 = g; scale(r2 + f, r2); uniform int i = 3; count_up(i, i); r3 = i;",
       "float s[2] = { f, g }; scale(s[1], s[0]); scale(s[1], s[1]); r = s[0]; r2 = s[1];",
       "r = limited(f, 1.0); r2 = limited(g, f); uniform int i; for (i = 0; i < 3; i++) r3 += limited(f, i);",
       "r = quarter(a); r2 = quarter(f); r3 = quarter(quarter(u));",
       "float s[2] = { f, g }; uniform int i; for (i = 0; i < 2; i++) split(s[i], s[i], r); r2 = s[0]; r3 = s[1];"},
      used);
}

/// Fixed point on the host: signs, and quotients and remainders that are no whole numbers.
TEST(LowerUniform, arithmetic) {
  const std::string parameters =
      "uniform signed fixed<16,4> a = 0, uniform signed fixed<16,6> b = 0, uniform fixed<8,4> c = 0, "
      "uniform fixed<8,0> d = 0";
  const std::vector<std::string> expressions = {"a / b",        "a % b",      "a / c",    "c / b",     "c / d",
                                                "a % c",        "c % b",      "-a",       "a - b * c", "a * b >> 3",
                                                "floor(a) - d", "ceil(b)",    "round(a)", "abs(b)",    "sign(a) * d",
                                                "min(a, b, c)", "sqrt(c) / a"};
  const std::uint64_t seed = pixelflow_tests::seed_or(21);
  for (std::size_t n = 0; n < expressions.size(); ++n) {
    for (std::uint64_t repeat = 0; repeat < 12; ++repeat) {
      const std::string other = expressions[(n + repeat) % expressions.size()];
      EXPECT_TRUE(agrees(surface("signed fixed<24,5>", parameters, {"r", "r2", "r"},
                                 "  uniform signed fixed<24,5> r = " + expressions[n] + ", r2 = " + other + ";\n"),
                         seed + 100 * n + repeat));
    }
  }
}

TEST(LowerUniform, literals) {
  try_bodies("signed fixed<24,4>",
             {"r = -7 % 3; r2 = 7 % -3; r3 = -7.5 % 2;", "r = (1 << 62) >> 60; r2 = (6 & 3) | (8 ^ 1); r3 = 7 / 2;",
              "r = a * (1 / 3); r2 = (2 < 3) + a; r3 = !0 + b;"});
}

TEST(LowerUniform, run_time_errors) {
  const auto kind = [](const std::string& body) {
    const Agreement agreement = compare(surface("float", kParameters, {"r", "r", "r"}, "float r = 0;\n" + body), 1);
    EXPECT_EQ(agreement.text, "");
    return agreement.kind;
  };
  using Kind = Agreement::Kind;
  EXPECT_EQ(kind("r = v[k_n];"), Kind::Refused);
  EXPECT_EQ(kind("float m[2][3] = k_m; r = m[0][k_n - 2];"), Kind::Refused);
  EXPECT_EQ(kind("float m[2][3] = k_m; m[k_j][0] = 1; r = m[0][0];"), Kind::Refused);
  EXPECT_EQ(kind("float m[2][3] = k_m; m[k_i - 1][k_n - 2] = 1; r = m[0][0];"), Kind::Refused);
  EXPECT_EQ(kind("r = a >> (k_n - 6);"), Kind::Refused);
  EXPECT_EQ(kind("uniform int i = 0; while (i < 1) r += 1;"), Kind::Refused);
  EXPECT_EQ(kind("r = k_m[k_i][k_j] + v[k_n - 2];"), Kind::Agrees);
  // What is not needed is not evaluated.
  EXPECT_EQ(kind("uniform bool c = k_n < 2 && k_m[k_n][0] > 1; r = c;"), Kind::Agrees);
  EXPECT_EQ(kind("uniform bool c = k_n > 2 || k_m[k_n][0] > 1; r = c;"), Kind::Agrees);
  EXPECT_EQ(kind("uniform float c = k_n < 2 ? k_m[k_n][0] : 2; r = c;"), Kind::Agrees);
  EXPECT_EQ(kind("uniform bool c = k_n > 2 && k_m[k_n][0] > 1; r = c;"), Kind::Refused);
}

}  // namespace
}  // namespace lower_tests
