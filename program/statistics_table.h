// The full statistics of the 1970 program (its PQ, Q and ADDS counters) as a table for people.
#pragma once

#include <string>

#include "cmodel/vsg/answer.h"

namespace program {

std::string statistics_table(const vsg::FrameAnswer& answer);

}  // namespace program
