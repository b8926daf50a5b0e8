#include "tb/vsg/rtl_machine.h"

#include "Vvsg.h"
#include "tb/vsg/rtl_driver.h"

namespace tb {

std::unique_ptr<RtlMachine> make_rtl_machine(const std::filesystem::path& trace) {
  return std::make_unique<RtlDriver<Vvsg>>(trace);
}

}  // namespace tb
