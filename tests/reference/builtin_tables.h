// Parts of the table of built-in functions.
#pragma once

#include <map>
#include <string>

#include "tests/reference/builtin.h"

namespace reference {

void add_generic_functions(std::map<std::string, Builtin>& table);  ///< of floats or fixed-point numbers
void add_noise_functions(std::map<std::string, Builtin>& table);

}  // namespace reference
