// Prints by how many pixels the golden model's answer differs from the exact one: a row of a Markdown table a frame
// file, then one a set of random frames. docs/accuracy.md is made from it by scripts/accuracy.
//
//   truth_report FRAME... [--random COUNT [FIRST_SEED]]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "scanline/golden_generator.h"
#include "tests/truth/comparison.h"
#include "tests/truth/random_frames.h"

namespace {

using truth::Comparison;

Comparison compare(const scanline::Frame& frame, const truth::ExactFrame& exact, bool keep_back_faces) {
  scanline::GoldenGenerator generator;
  const auto answer = generator.generate(scanline::make_blocks(frame, generator.parameters(), keep_back_faces));
  return truth::compare(exact, keep_back_faces, answer.segments);
}

void print_heading() {
  std::printf("| frame | covered pixels | ties | wrong | a million |");
  for (const auto& name : truth::kDifferenceNames) std::printf(" %s |", std::string(name).c_str());
  std::printf(" longest run |\n|---|---|---|---|---|");
  for (std::size_t i = 0; i < truth::kDifferenceNames.size(); ++i) std::printf("---|");
  std::printf("---|\n");
}

void print_row(const std::string& name, const Comparison& c) {
  const double million = c.covered ? 1e6 * static_cast<double>(c.wrong_total()) / static_cast<double>(c.covered) : 0;
  std::printf("| %s | %lld | %lld | %lld | %.0f |", name.c_str(), static_cast<long long>(c.covered),
              static_cast<long long>(c.ties), static_cast<long long>(c.wrong_total()), million);
  for (const auto count : c.wrong) std::printf(" %lld |", static_cast<long long>(count));
  std::printf(" %d |\n", c.longest_run);
  std::fflush(stdout);
}

Comparison report_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  const truth::ExactFrame exact = truth::read_exact_frame(in);
  const Comparison c = compare(scanline::read_frame_file(path), exact, false);
  print_row(path.stem().string(), c);
  return c;
}

Comparison report_random(int count, std::uint64_t first_seed) {
  const struct {
    truth::FrameKind kind;
    const char* name;
    int polygons;
  } kSets[] = {{truth::FrameKind::kTriangles, "triangles", 20},
               {truth::FrameKind::kBoxes, "boxes", 36},
               {truth::FrameKind::kSheets, "sheets", 200},
               {truth::FrameKind::kStars, "stars", 12}};
  Comparison total;
  for (const auto& set : kSets) {
    Comparison sum;
    for (int i = 0; i < count; ++i) {
      const scanline::Frame frame = truth::random_frame(set.kind, first_seed + i, 128, set.polygons);
      std::stringstream text;
      scanline::write_frame(text, frame);
      sum += compare(frame, truth::read_exact_frame(text), truth::keeps_back_faces(set.kind));
    }
    print_row(std::to_string(count) + " random frames of " + set.name + ", seeds from " + std::to_string(first_seed),
              sum);
    total += sum;
  }
  return total;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    print_heading();
    Comparison total;
    for (int i = 1; i < argc; ++i) {
      if (std::string(argv[i]) == "--random") {
        total += report_random(i + 1 < argc ? std::atoi(argv[i + 1]) : 50,
                               i + 2 < argc ? std::strtoull(argv[i + 2], nullptr, 10) : 1);
        break;
      }
      total += report_file(argv[i]);
    }
    print_row("all", total);
    return 0;
  } catch (const std::exception& mistake) {
    std::fprintf(stderr, "%s\n", mistake.what());
    return 1;
  }
}
