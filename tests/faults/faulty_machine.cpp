#include "tests/faults/faulty_machine.h"

#include "Vvsg_faulty.h"
#include "tb/vsg/rtl_driver.h"

namespace {
int g_fault = 0;
}

extern "C" int chosen_fault() { return g_fault; }

namespace vsg_tests {

std::unique_ptr<tb::RtlMachine> make_faulty_machine(int fault) {
  // A faulty machine may lose its way in a list and never finish a line.
  constexpr std::int64_t kMostCyclesOfLine = 100'000;
  g_fault = fault;
  return std::make_unique<tb::RtlDriver<Vvsg_faulty>>(std::filesystem::path(), kMostCyclesOfLine);
}

}  // namespace vsg_tests
