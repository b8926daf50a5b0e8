// Who may do a frame's work, and what of a run must not depend on it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/run_program.h"

namespace render_levels {

/// Options of a run: levels of modelling, threads.
using Machine = std::vector<std::string>;

/// The golden models: every other machine is compared with this one.
extern const Machine kReference;

/// All levels of both machines, the verilated ones in lock-step too, with 1, 2 and 5 threads for either generator.
/// Without RTL in the program, those that do without it.
std::vector<Machine> all_machines();
/// Both machines at their lowest level.
Machine lowest_machine();
/// The golden generator, pixel processors at their lowest level: where the generator's RTL would say nothing new.
Machine lowest_pixels();

std::string text(const Machine& machine);

/// Statistics without what may differ: clock cycles and port accesses of the generator's RTL, and times.
nlohmann::json comparable(nlohmann::json statistics);
/// The places where two differ, one a line; empty when they are equal.
std::string differences(const nlohmann::json& is, const nlohmann::json& should);

struct Pictures {
  /// Bytes of the files, frame by frame: EXR with its channels, then PNG where asked for.
  std::vector<std::string> pictures;
  nlohmann::json statistics;  ///< what of them can be compared
};

/// Runs the program in the folder of its test.
class LevelsTest : public vsg_tests::ProgramTest {
 protected:
  /// `arguments`: scene and size; `frames`: A-B, or empty for one picture; `png`: once more as PNG, which holds nothing
  /// that EXR does not.
  Pictures render(const std::vector<std::string>& arguments, const std::string& frames, const Machine& machine,
                  bool png = false) const;
  /// Expects that both are the same, and says where they differ.
  static void expect_same(const Pictures& is, const Pictures& should, const std::string& what);
};

}  // namespace render_levels
