#include "program/statistics_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace program {
namespace {

using vsg::Statistics;

constexpr std::array<std::string_view, Statistics::kPq + 1> kPqMeaning = {
    "",
    "segment blocks taken for the whole frame",
    "most segment blocks in use at one time",
    "segment blocks still in use at the end",
    "edge blocks of the frame",
    "edge blocks with a polygon that faces the viewer",
    "of these, the ones that are not horizontal",
    "polygon blocks of the frame",
    "polygon blocks that face the viewer",
    "point density: pixels covered by visible polygons",
    "scan lines on which something is visible",
    "memory references of scan preparation",
    "nanoseconds each of them may take at 30 frames a second",
    "memory references of depth sorting",
    "nanoseconds each of them may take at 30 frames a second",
    "memory references of both",
    "nanoseconds each of them may take at 30 frames a second",
};

// Empty where the old listing has no description and nothing counts.
constexpr std::array<std::string_view, Statistics::kQ + 1> kQMeaning = {
    "",
    "slopes calculated",
    "segments incremented to the next line",
    "sample points stored for the next line",
    "spans subdivided (intersections apart)",
    "",
    "depth tests",
    "",
    "sample points deleted",
    "steps back in the X-sort list",
    "output segments",
    "intersections calculated",
    "spans cut in the middle",
    "spans judged (pipeline overhead)",
    "waiting for the clipper",
    "reads of polygon memory",
    "writes of polygon memory",
    "reads of edge memory",
    "writes of edge memory",
    "reads of segment memory",
    "writes of segment memory",
    "",
    "",
    "blocks taken from the free list",
    "blocks returned to the free list",
    "reads of the Y-sort buckets",
    "used for shading",
};

// In the order in which people ask; numbers are columns of Statistics::q.
struct Column {
  int number;
  std::string_view title;
};
constexpr Column kColumns[] = {{1, "total"},       {4, "pre-frame"},  {9, "prepare"},   {10, "sort"},
                               {2, "most/line"},   {5, "most prep"},  {7, "most sort"}, {3, "mean/line"},
                               {8, "mean/active"}, {6, "ns at 30 Hz"}};

template <typename... Arguments>
void print(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

void print_q(std::string& text, const Statistics& s) {
  print(text, "\nQ counters\n{:>4}  {:<38}", "", "");
  for (const Column& column : kColumns) print(text, " {:>11}", column.title);
  print(text, "\n");
  for (int i = 1; i <= Statistics::kQ; ++i) {
    const auto& row = s.q[i];
    const bool empty = std::all_of(row.begin(), row.end(), [](std::int64_t count) { return count == 0; });
    if (kQMeaning[i].empty() && empty) continue;
    print(text, "{:>4}  {:<38}", i, kQMeaning[i]);
    for (const Column& column : kColumns) print(text, " {:>11}", row[column.number]);
    print(text, "\n");
  }
  print(text,
        "\n  total      the whole frame             most/line    greatest of a scan line\n"
        "  pre-frame  before the first line       most prep    greatest of a line's preparation\n"
        "  prepare    Segment Generator and       most sort    greatest of a line's depth sorting\n"
        "             Segment Eliminator          mean/line    total over all scan lines\n"
        "  sort       Depth Sorter                mean/active  total over the lines with something visible\n"
        "                                         ns at 30 Hz  time for each at 30 frames a second\n");
}

void print_adds(std::string& text, const Statistics& s) {
  print(
      text,
      "\nADDS: depth tests by their add cycles, as listed (a skipped segment counts again with the test before it)\n");
  for (int i = 1; i <= Statistics::kAdds; ++i) {
    if (s.adds[i] != 0) print(text, "{:>4}{} {:>11}\n", i, i == Statistics::kAdds ? "+" : " ", s.adds[i]);
  }
}

}  // namespace

std::string statistics_table(const vsg::FrameAnswer& answer) {
  std::string text;
  print(text, "Frame of {} x {}\n\nPQ counters\n", answer.width, answer.height);
  for (int i = 1; i <= Statistics::kPq; ++i)
    print(text, "{:>4}  {:<60} {:>11}\n", i, kPqMeaning[i], answer.statistics.pq[i]);
  print_q(text, answer.statistics);
  print_adds(text, answer.statistics);
  if (answer.cycles) {
    print(text, "\nRTL: {} clock cycles, {} accesses of the port of segment memory\n", *answer.cycles,
          answer.port_accesses);
  }
  return text;
}

}  // namespace program
