// The answers of the 1970 program in tests/vectors, and their comparison with an answer of ours.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cmodel/vsg/answer.h"

namespace vsg_tests {

struct VectorFile {
  std::string name;
  bool keep_back_faces = false;
};

/// tests/vectors, or the folder that VSG_VECTORS names: any frames with answers of the 1970 program can be compared.
inline std::filesystem::path vector_folder() {
  if (const char* folder = std::getenv("VSG_VECTORS")) return folder;
  return std::filesystem::path(VSG_SOURCE_DIR) / "tests" / "vectors";
}

inline nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

inline std::vector<VectorFile> vector_files() {
  std::vector<VectorFile> files;
  for (const auto& entry : read_json(vector_folder() / "manifest.json")) {
    files.push_back({entry.at("name"), entry.at("keep_back_faces")});
  }
  return files;
}

inline void PrintTo(const VectorFile& file, std::ostream* out) { *out << file.name; }

/// Expects segments, counters and details to equal those of the 1970 program.
inline void expect_equal(const nlohmann::json& expected, const vsg::FrameAnswer& answer) {
  const auto& segments = expected.at("segments");
  ASSERT_EQ(segments.size(), answer.segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const vsg::VisibleSegment segment{segments[i][0], segments[i][1], segments[i][2]};
    ASSERT_EQ(segment, answer.segments[i]) << "segment " << i << " on scan line " << segment.y;
  }
  const auto& detail = expected.at("detail");
  const auto& lines = detail.at("references_by_scan_line");
  ASSERT_EQ(lines.size(), answer.lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) ASSERT_EQ(lines[i], answer.lines[i].references) << "scan line " << i + 1;

  const auto& counters = expected.at("counters");
  const vsg::Counters& c = answer.counters;
  EXPECT_EQ(counters.at("polygon_blocks"), c.polygon_blocks);
  EXPECT_EQ(counters.at("edge_blocks"), c.edge_blocks);
  EXPECT_EQ(counters.at("edge_crossings"), c.edge_crossings);
  EXPECT_EQ(counters.at("implied_edges"), c.implied_edges);
  EXPECT_EQ(counters.at("output_segments"), c.output_segments);
  EXPECT_EQ(counters.at("segment_blocks_total"), c.segment_blocks_total);
  EXPECT_EQ(counters.at("segment_blocks_max"), c.segment_blocks_max);
  EXPECT_EQ(counters.at("segment_references"), c.segment_references);
  EXPECT_EQ(counters.at("reference_ratio"), c.reference_ratio);
  EXPECT_EQ(counters.at("add_cycles"), c.add_cycles);
  EXPECT_EQ(counters.at("add_cycles_per_test"), c.add_cycles_per_test);
  EXPECT_EQ(counters.at("percent_not_at_end"), c.percent_not_at_end);
  EXPECT_EQ(counters.at("output_buffer"), c.output_buffer);
  EXPECT_EQ(counters.at("add_cycles_listed"), c.add_cycles_listed);

  EXPECT_EQ(detail.at("depth_tests"), answer.depth_tests);
  EXPECT_EQ(detail.at("samples_stored"), answer.samples_stored);
  EXPECT_EQ(detail.at("subdivisions"), answer.subdivisions);
  EXPECT_EQ(detail.at("intersections"), answer.intersections);
  EXPECT_EQ(detail.at("stale_samples"), answer.stale_samples);
  for (int i = 1; i <= vsg::Statistics::kAdds; ++i) {
    EXPECT_EQ(detail.at("adds_histogram_as_listed")[i - 1], answer.statistics.adds[i]) << "tests of " << i << " add cycles";
  }
}

}  // namespace vsg_tests
