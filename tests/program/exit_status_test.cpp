// What is thrown becomes an exit status and a message.
#include "program/exit_status.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>

#include "cmodel/vsg/answer.h"
#include "scanline/error.h"

namespace vsg_tests {
namespace {

struct Ending {
  int status = -1;
  std::string err;
};

template <typename Thrown>
Ending ending(const Thrown& thrown) {
  Ending result;
  testing::internal::CaptureStderr();
  try {
    throw thrown;
  } catch (...) {
    result.status = program::report_exception();
  }
  result.err = testing::internal::GetCapturedStderr();
  return result;
}

TEST(ExitStatus, AMismatchOfModelAndRtlIsTwo) {
  const Ending mismatch = ending(vsg::LockstepError("scan line 7: field 'x_end'\n  golden 12\n  RTL    13"));
  EXPECT_EQ(mismatch.status, 2);
  EXPECT_EQ(mismatch.err, "error: scan line 7: field 'x_end'\n  golden 12\n  RTL    13\n");
}

TEST(ExitStatus, AMistakeOfTheUserIsOneAndNamesTheFile) {
  const Ending mistake = ending(scanline::UserError({"a.frame", 3, 0, "what is this"}));
  EXPECT_EQ(mistake.status, 1);
  EXPECT_EQ(mistake.err, "a.frame:3: error: what is this\n");
}

TEST(ExitStatus, WhateverElseStopsTheProgramIsOne) {
  EXPECT_EQ(ending(std::bad_alloc()).status, 1);
  EXPECT_EQ(ending(std::bad_alloc()).err, "error: out of memory\n");
  EXPECT_EQ(ending(std::runtime_error("the disk is gone")).status, 1);
  EXPECT_EQ(ending(std::runtime_error("the disk is gone")).err, "error: the disk is gone\n");
}

}  // namespace
}  // namespace vsg_tests
