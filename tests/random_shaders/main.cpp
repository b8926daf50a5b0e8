// Random shaders, compiled and run, against the reference interpreter.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

#include "tests/random_shaders/runner.h"
#ifdef PIXELFLOW_HAS_RTL
#include "tb/pixelflow/rtl_array.h"
#endif

namespace {

using namespace random_shaders;

struct Arguments {
  std::uint64_t seed = 1;
  int count = 1000;
  int model_every = 1, rtl_every = 0;
  int tries = 2000;
  bool print = false;
  Settings settings;
};

/// Every choice of optimisations in its turn, none of them the most often.
pfman::Options less(std::uint64_t number) {
  pfman::Options options;
  const auto kept = number / 2 % 2 == 0 ? 0 : number / 4;
  options.fuse = kept & 1;
  options.drop_unused = kept & 2;
  options.join_copies = kept & 4;
  options.share_memory = kept & 8;
  return options;
}

std::vector<Way> ways_of(const Arguments& arguments, std::uint64_t number) {
  const auto golden = [](pixelflow::Level level) {
    return [level] { return pixelflow::make_golden_array(level, kLanes); };
  };
  const auto chosen = [&](int every) { return every > 0 && number % static_cast<std::uint64_t>(every) == 0; };
  std::vector<Way> ways{{"macro", {}, golden(pixelflow::Level::Macro)},
                        {"macro, less optimised", less(number), golden(pixelflow::Level::Macro)}};
  if (chosen(arguments.model_every)) ways.push_back({"model", {}, golden(pixelflow::Level::Model)});
#ifdef PIXELFLOW_HAS_RTL
  if (chosen(arguments.rtl_every)) ways.push_back({"rtl", {}, [] { return tb::make_rtl_array(kLanes); }});
#endif
  return ways;
}

void report(const Program& program, std::uint64_t seed, const Outcome& outcome, const Arguments& arguments,
            const std::vector<Way>& ways) {
  fmt::print("seed {}: {}\n", seed, outcome.text);
  Program reduced = program;
  Outcome last = outcome;
  // A smaller program fails alike where the same is said of it, up to numbers and places.
  const auto kind = [](const std::string& text) {
    std::string letters = text.substr(0, text.find('\n', text.find('\n') + 1));  // a message is the second line
    std::erase_if(letters, [](char letter) { return letter >= '0' && letter <= '9'; });
    return letters.substr(0, letters.find(" (and"));
  };
  reduced.text = reduce(
      program.text,
      [&](const Piece& piece) {
        Program candidate = program;
        candidate.text = piece;
        const Outcome found = check(candidate, seed, ways);
        const bool alike = found.kind == Outcome::Kind::Differs && kind(found.text) == kind(outcome.text);
        if (alike) last = found;
        return alike;
      },
      arguments.tries);
  fmt::print("reduced to\n{}{}\nagain: pfman_random_shaders --seed {} --count 1 --statements {}{}\n",
             render(reduced.text), last.text, seed, arguments.settings.statements,
             arguments.rtl_every > 0 ? " --rtl-every 1" : "");
}

int run(const Arguments& arguments) {
  std::map<Outcome::Kind, int> outcomes;
  int failures = 0, runs = 0;
  // A program that is refused is drawn again: the count is of those that run.
  std::uint64_t seed = arguments.seed;
  for (int compared = 0; compared < arguments.count && failures < 5; ++seed) {
    const Program program = random_program(seed, arguments.settings);
    if (arguments.print) fmt::print("{}\n", render(program.text));
    const std::vector<Way> ways = ways_of(arguments, seed - arguments.seed);
    const Outcome outcome = check(program, seed, ways);
    ++outcomes[outcome.kind];
    runs += outcome.runs;
    if (outcome.kind == Outcome::Kind::Agrees) ++compared;
    if (outcome.kind == Outcome::Kind::Differs) {
      ++failures;
      report(program, seed, outcome, arguments, ways);
    }
    if (arguments.count == 1) break;
  }
  using Kind = Outcome::Kind;
  const int refused = outcomes[Kind::TooWide] + outcomes[Kind::TooLarge] + outcomes[Kind::RunTime];
  fmt::print("seeds {} to {}: {} programs agree in {} runs; {} differ; {} too wide, {} too large, {} stopped\n",
             arguments.seed, seed, outcomes[Kind::Agrees], runs, failures, outcomes[Kind::TooWide],
             outcomes[Kind::TooLarge], outcomes[Kind::RunTime]);
  if (arguments.count > 100 && 3 * refused > outcomes[Kind::Agrees]) {
    fmt::print("too many programs are refused\n");
    return 1;
  }
  return failures > 0 || (outcomes[Kind::Agrees] == 0 && arguments.count > 1) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"Random shaders, compiled and run on the pixel processors, against the reference interpreter."};
  app.add_option("--seed", arguments.seed, "of the first program; the next ones count up")->capture_default_str();
  app.add_option("--count", arguments.count, "programs that run")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--statements", arguments.settings.statements, "of a body, at most")->capture_default_str();
  app.add_option("--depth", arguments.settings.depth, "of an expression, at most")->capture_default_str();
  app.add_option("--model-every", arguments.model_every, "at the model's level; 0: never")->capture_default_str();
#ifdef PIXELFLOW_HAS_RTL
  app.add_option("--rtl-every", arguments.rtl_every, "at the level of the RTL; 0: never")->capture_default_str();
#endif
  app.add_option("--tries", arguments.tries, "to make a failing program smaller")->capture_default_str();
  app.add_flag("--print", arguments.print, "every program's text");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
}
