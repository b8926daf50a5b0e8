#include "program/exit_status.h"

#include <cstdio>
#include <exception>
#include <new>

#include "cmodel/vsg/answer.h"
#include "scanline/error.h"

namespace program {

ExitStatus report(const std::string& text, ExitStatus status) {
  std::fprintf(stderr, "error: %s\n", text.c_str());
  return status;
}

ExitStatus report_exception() {
  try {
    throw;
  } catch (const scanline::UserError& mistake) {  // its text says "error:" behind each file and line
    std::fprintf(stderr, "%s\n", mistake.what());
    return kUserMistake;
  } catch (const Reported&) {
    return kUserMistake;
  } catch (const vsg::LockstepError& mismatch) {
    return report(mismatch.what(), kLockstepMismatch);
  } catch (const std::bad_alloc&) {
    return report("out of memory", kUserMistake);
  } catch (const std::exception& failure) {
    return report(failure.what(), kUserMistake);
  }
}

}  // namespace program
