// What tests of meshes and scenes share.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "scanline/error.h"
#include "scanline/mesh.h"

namespace scanline_tests {

/// Directed edges that have no partner in the other direction, or more of one direction than of the other.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> open_edges(const scanline::PolygonList& polygons) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& p : polygons) {
    for (std::size_t k = 0; k < p.size(); ++k) {
      const std::uint32_t a = p[k], b = p[(k + 1) % p.size()];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const auto& [edge, count] : balance) {
    if (count != 0) open.push_back(edge);
  }
  return open;
}

/// Positive for a closed mesh whose polygons run counter-clockwise seen from outside.
inline double volume(const scanline::Mesh& mesh) {
  double sum = 0;
  for (const auto& p : mesh.polygons) {
    for (std::size_t k = 1; k + 1 < p.size(); ++k) {
      sum += glm::dot(mesh.positions[p[0]], glm::cross(mesh.positions[p[k]], mesh.positions[p[k + 1]])) / 6;
    }
  }
  return sum;
}

/// Polygons by their number of vertices.
inline std::map<std::size_t, int> sizes(const scanline::PolygonList& polygons) {
  std::map<std::size_t, int> count;
  for (const auto& p : polygons) ++count[p.size()];
  return count;
}

/// What a user is told; an empty text when nothing is thrown.
inline std::string mistake(const std::function<void()>& action) {
  try {
    action();
  } catch (const scanline::UserError& e) {
    return e.what();
  }
  return {};
}

/// A folder that lives as long as the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(test->test_suite_name()) + "." + test->name();
    path_ = std::filesystem::temp_directory_path() / ("vsg_" + name + "_" + std::to_string(std::random_device{}()));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::filesystem::path scenes_folder() { return std::filesystem::path(VSG_SOURCE_DIR) / "scenes"; }

}  // namespace scanline_tests
