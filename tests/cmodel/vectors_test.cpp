// The golden model against the 1970 program: the same segments in the same order, the same counters.
#include <gtest/gtest.h>

#include "scanline/frame.h"
#include "scanline/golden_generator.h"
#include "tests/cmodel/vector_files.h"

namespace vsg_tests {
namespace {

class GoldenModelVectors : public testing::TestWithParam<VectorFile> {};

TEST_P(GoldenModelVectors, AnswersAsTheProgramOf1970) {
  const VectorFile& file = GetParam();
  const auto frame = scanline::read_frame_file(vector_folder() / (file.name + ".frame"));
  scanline::GoldenGenerator generator;
  const auto answer = generator.generate(scanline::make_blocks(frame, generator.parameters(), file.keep_back_faces));
  expect_equal(read_json(vector_folder() / (file.name + ".json")), answer);
}

INSTANTIATE_TEST_SUITE_P(Vectors, GoldenModelVectors, testing::ValuesIn(vector_files()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace vsg_tests
