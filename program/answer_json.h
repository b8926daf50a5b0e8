// The answer for a frame as JSON (docs/formats.md).
#pragma once

#include <nlohmann/json.hpp>

#include "cmodel/vsg/answer.h"

namespace program {

/// The rows of figure 33, in order; row 10 as the old listing counted it comes last.
nlohmann::ordered_json counters_json(const vsg::Counters& counters);

/// Clock cycles and port accesses, which only RTL has, are added to `object`.
void add_rtl_counts(nlohmann::ordered_json& object, const vsg::FrameAnswer& answer);

/// What `vsg segments` prints.
std::string segments_json(const vsg::FrameAnswer& answer);

}  // namespace program
