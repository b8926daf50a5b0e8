// The machine with planted faults, one of which may be chosen.
#pragma once

#include <memory>

#include "tb/vsg/rtl_machine.h"

namespace vsg_tests {

/// `fault`: number in faults.json from 1; 0 is the true machine. One machine at a time.
std::unique_ptr<tb::RtlMachine> make_faulty_machine(int fault);

}  // namespace vsg_tests
