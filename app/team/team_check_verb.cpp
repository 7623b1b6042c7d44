#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/shared_options.hpp"
#include "app/team/team_game.hpp"
#include "app/verbs.hpp"
#include "game/settings/game_settings.hpp"
#include "game/team_programs/program_check.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"

namespace autoref::app {
namespace {

struct TeamCheckArguments {
  std::string command;
  std::vector<std::string> sets;  // "key=value"
  bool json = false;
};

// The quantile of the sorted values at `share`; 0 for an empty list.
double answer_quantile_ms(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto index = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  return sorted[std::min(index, sorted.size() - 1)];
}

std::string verdict_on_repeating(const game::TeamCheck& check) {
  if (!check.is_repeatable) return "not tried";
  if (*check.is_repeatable) return "yes: two runs gave the same commands";
  return "no: a second run gave other commands; does the program read a clock, or draw random "
         "numbers "
         "without the seed of START? Games are still recorded and can be played again";
}

std::string line(std::string_view name, const std::string& text) {
  return fmt::format("{:<12}{}\n", name, text);
}

std::string greeting_text(const game::TeamCheck& check) {
  if (!check.greeting) return "none";
  return fmt::format("{}, {}", league::name_of(check.greeting->encoding),
                     league::name_of(check.greeting->motion));
}

std::string answers_text(const game::TeamCheck& check) {
  const std::vector<double>& ms = check.answers_ms;
  return line("start", fmt::format("{:.0f} ms until the first answer", check.start_ms)) +
         line("answers", fmt::format("{} in {:.1f} s of the game", ms.size(), check.played_s)) +
         line("latency", fmt::format("median {:.3f} ms, 99 % {:.3f} ms, longest {:.3f} ms",
                                     answer_quantile_ms(ms, 0.5), answer_quantile_ms(ms, 0.99),
                                     answer_quantile_ms(ms, 1)));
}

// Advice based on the usual cause of a fault.
std::string advice_on(const std::string& fault) {
  static constexpr std::array<std::array<std::string_view, 2>, 5> kAdvice = {
      {{"cannot start",
        "is the program in PATH, or is its path relative to the working directory?"},
       {"did not answer", "does it flush its standard output after each answer?"},
       {"bad output",
        "only the greeting and outputs belong on its standard output; print anything else to the "
        "standard error"},
       {"ended with status", "run it by hand to see whether it starts"},
       {"instead of", "each output must repeat the number of the frame that it answers"}}};
  for (const auto& [part, advice] : kAdvice) {
    if (fault.find(part) != std::string::npos) return line("advice", std::string(advice));
  }
  return "";
}

std::string text_of(const game::TeamCheck& check) {
  std::string text = line("greeting", greeting_text(check));
  if (!check.answers_ms.empty()) text += answers_text(check);
  if (!check.fault.empty()) return text + line("fault", check.fault) + advice_on(check.fault);
  text += line("robots", fmt::format("{} were commanded", check.robots_commanded));
  text += line("keeper", check.keeper < 0 ? "unknown" : fmt::format("robot {}", check.keeper));
  if (check.asked_for_timeout) text += line("timeout", "asked for");
  text += line("repeatable", verdict_on_repeating(check));
  if (check.ending != "ended with status 0")
    text += line("after END", check.ending + "; it should exit with status 0 within a second");
  return text + line("result", "it plays");
}

std::string json_of(const game::TeamCheck& check) {
  io::Json json = {
      {"encoding",
       check.greeting ? io::Json(league::name_of(check.greeting->encoding)) : io::Json()},
      {"motion", check.greeting ? io::Json(league::name_of(check.greeting->motion)) : io::Json()},
      {"start_ms", check.start_ms},
      {"answers", check.answers_ms.size()},
      {"played_s", check.played_s},
      {"median_ms", answer_quantile_ms(check.answers_ms, 0.5)},
      {"p99_ms", answer_quantile_ms(check.answers_ms, 0.99)},
      {"longest_ms", answer_quantile_ms(check.answers_ms, 1)},
      {"robots_commanded", check.robots_commanded},
      {"keeper", check.keeper},
      {"asked_for_timeout", check.asked_for_timeout},
      {"is_repeatable", check.is_repeatable ? io::Json(*check.is_repeatable) : io::Json()},
      {"ending", check.ending},
      {"fault", check.fault.empty() ? io::Json() : io::Json(check.fault)}};
  return io::json_text(json);
}

constexpr double kCheckedHalf_s = 5;

int team_check_verb(const TeamCheckArguments& arguments) {
  const game::TeamCheck check = game::check_team(
      game::resolved(team_game(arguments.command, "basic", kCheckedHalf_s, arguments.sets)));
  fmt::print("{}{}", arguments.json ? json_of(check) : text_of(check), arguments.json ? "\n" : "");
  return check.fault.empty() ? io::kDone : io::kTooManyVoid;
}

}  // namespace

void add_team_check_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("check", "Try out a team that is a program.");
  auto arguments = std::make_shared<TeamCheckArguments>();
  add_program_argument(*verb, arguments->command);
  add_set_option(*verb, arguments->sets);
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "Plays two halves of five seconds against basic, twice with the same seed. Prints what the\n"
      "program asks for, how fast it answers, whether it repeats its commands, and what is "
      "wrong.\n\n"
      "Example:\n  autoref team check 'python3 my_team.py' --set a.directory=teams");
  choose(*verb, chosen, arguments, team_check_verb);
}

}  // namespace autoref::app
