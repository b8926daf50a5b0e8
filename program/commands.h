// The commands of the program, one file each. Every add_ function registers a subcommand with its options; the work
// is done when CLI11 has read the whole command line, which those that may compare two machines repeat in their
// messages.
#pragma once

#include <CLI/CLI.hpp>

namespace program {

void add_render(CLI::App& app, const std::string& command_line);
void add_frame(CLI::App& app);
void add_segments(CLI::App& app, const std::string& command_line);
void add_explain(CLI::App& app, const std::string& command_line);
void add_tables(CLI::App& app, const std::string& command_line);
void add_shader(CLI::App& app);

}  // namespace program
