#include "Vvsg_small.h"
#include "tb/vsg/rtl_driver.h"
#include "tb/vsg/rtl_machine.h"

namespace tb {

std::unique_ptr<RtlMachine> make_small_rtl_machine(const std::filesystem::path& trace) {
  return std::make_unique<RtlDriver<Vvsg_small>>(trace);
}

}  // namespace tb
