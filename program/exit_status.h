// How the program ends: what was thrown becomes a message and an exit status.
#pragma once

#include <exception>
#include <string>

namespace program {

enum ExitStatus { kSuccess = 0, kUserMistake = 1, kLockstepMismatch = 2 };

/// Prints "error: TEXT" on standard error.
ExitStatus report(const std::string& text, ExitStatus status);

/// A user's mistake of which everything has been said on standard error.
struct Reported : std::exception {};

/// For a catch block: prints what was thrown on standard error and tells the exit status that belongs to it.
ExitStatus report_exception();

}  // namespace program
