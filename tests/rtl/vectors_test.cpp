// The verilated RTL, in lock-step with the golden model, against the 1970 program.
#include <gtest/gtest.h>

#include "scanline/frame.h"
#include "tb/verilated_generator.h"
#include "tests/cmodel/vector_files.h"

namespace vsg_tests {
namespace {

class RtlVectors : public testing::TestWithParam<VectorFile> {};

TEST_P(RtlVectors, AnswersAsTheProgramOf1970InLockstep) {
  const VectorFile& file = GetParam();
  const auto frame = scanline::read_frame_file(vector_folder() / (file.name + ".frame"));
  tb::VerilatedGenerator generator({.lockstep = true, .trace = {}, .replay = {}});
  const auto answer = generator.generate(scanline::make_blocks(frame, generator.parameters(), file.keep_back_faces));
  expect_equal(read_json(vector_folder() / (file.name + ".json")), answer);
  EXPECT_GT(generator.matched(), 0);
  RecordProperty("transactions", std::to_string(generator.matched()));
}

INSTANTIATE_TEST_SUITE_P(Vectors, RtlVectors, testing::ValuesIn(vector_files()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace vsg_tests
