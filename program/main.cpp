// vsg: an executable model of Watkins's Visible Segment Generator. Parse, call, report.
#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "program/commands.h"
#include "program/exit_status.h"
#include "program/output_file.h"

namespace {

/// As a shell would take it again.
std::string quoted_command_line(int argc, char** argv) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+./,:@%";
  std::string text;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    if (i > 0) text += ' ';
    if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "vsg: Gary Watkins's Visible Segment Generator (Utah 1970), from a scene to a picture, and PixelFlow's pixel "
      "processors",
      "vsg"};
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "This text");
  app.set_version_flag("--version", VSG_VERSION);
  app.footer(
      "vsg COMMAND --help tells the options of a command.\n"
      "Exit status: 0 success, 1 a mistake in what was given, 2 golden model and RTL disagree.");
  const std::string command_line = quoted_command_line(argc, argv);
  program::add_render(app, command_line);
  program::add_frame(app);
  program::add_segments(app, command_line);
  program::add_explain(app, command_line);
  program::add_tables(app, command_line);
  program::add_shader(app);

  program::remove_partial_files_on_signals();
  try {
    app.parse(argc, argv);
    return program::kSuccess;
  } catch (const CLI::Success& request) {  // --help, --version
    return app.exit(request);
  } catch (const CLI::ParseError& mistake) {
    // CLI11 misses the command before it looks at the word that should have been one.
    const bool unknown = app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-';
    const std::string text = unknown ? "unknown command '" + std::string(argv[1]) + "'" : mistake.what();
    return program::report(text + " (see vsg --help)", program::kUserMistake);
  } catch (...) {
    return program::report_exception();
  }
}
