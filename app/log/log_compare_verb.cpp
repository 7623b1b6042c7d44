#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/log/comparison_page.hpp"
#include "app/log/judged_log.hpp"
#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"
#include "logs/compare/distance_report.hpp"
#include "logs/compare/game_comparison.hpp"
#include "logs/compare/measured_log.hpp"
#include "logs/compare/measures.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {
namespace {

constexpr std::size_t kHelpWidth = 92;

struct LogCompareArguments {
  std::vector<std::string> recorded;
  std::vector<std::string> simulated;
  std::string rules;   // empty: guessed
  std::string output;  // path of the page; empty: none
  bool json = false;
};

// Measures the logs; `code` becomes kBadInput if one cannot be judged or is damaged.
void measure(const std::vector<std::string>& paths, const std::string& rules,
             logs::GamesMeasurer& measurer, int& code) {
  const int measured = for_each_log(paths, [&](const std::string& path) {
    measurer.start_log();
    const JudgedLog judged =
        judged_log(path, rules, [&](const logs::LogReferee& referee) { measurer.note(referee); });
    measurer.finish_log(judged.log, judged.result.play);
    return !judged.facts.log.damage;
  });
  if (measured != io::kDone) code = measured;
}

int log_compare_verb(const LogCompareArguments& arguments) {
  const std::vector<std::string> recorded_paths = logs::logs_in(arguments.recorded);
  const std::vector<std::string> simulated_paths = logs::logs_in(arguments.simulated);
  std::vector<std::string> inputs = recorded_paths;
  inputs.insert(inputs.end(), simulated_paths.begin(), simulated_paths.end());
  check_outputs({{"-o", arguments.output}}, inputs);
  std::optional<io::PendingFile> file;
  open_output(file, "-o", arguments.output);

  int code = io::kDone;
  logs::GamesMeasurer recorded;
  logs::GamesMeasurer simulated;
  measure(recorded_paths, arguments.rules, recorded, code);
  measure(simulated_paths, arguments.rules, simulated, code);
  if (recorded.logs() == 0 || simulated.logs() == 0) return code;
  const logs::MeasuredGames& recorded_games = recorded.finish();
  const logs::MeasuredGames& simulated_games = simulated.finish();
  const logs::GameComparison comparison = logs::comparison_of(recorded_games, simulated_games);
  const logs::ComparedTimes times{{recorded.logs(), recorded.running_s()},
                                  {simulated.logs(), simulated.running_s()}};
  fmt::print("{}\n", arguments.json ? logs::comparison_json(comparison, times)
                                    : io::text_of(logs::comparison_text(comparison, times),
                                                  io::text_width(stdout)));
  if (file) {
    const ComparisonPage page =
        comparison_page(comparison, times, recorded_games.total(), simulated_games.total());
    file->commit(page.html);
    if (!page.trouble.empty()) io::write_message(stderr, "autoref: " + page.trouble + "\n");
    if (!arguments.json) fmt::print("{}\n", arguments.output);
  }
  return code;
}

std::string measures_text() {
  std::string text;
  for (const logs::MeasureEntry& entry : logs::kMeasures)
    text += io::wrapped(fmt::format("{}: {}", entry.name, entry.about), kHelpWidth) + "\n";
  return text;
}

}  // namespace

void add_log_compare_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("compare", "Compare simulated games with recorded ones, by their logs.");
  auto arguments = std::make_shared<LogCompareArguments>();
  add_logs_argument(*verb, arguments->recorded);
  verb->add_option("--with", arguments->simulated, "Logs of simulated games, or folders.")
      ->type_name("LOG")
      ->required();
  verb->add_option("--rules", arguments->rules, "Rule book; guessed from each log by default.")
      ->type_name("BOOK");
  verb->add_option("-o,--output", arguments->output, "A page with plots, an HTML file.")
      ->type_name("FILE");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "AutoRef referees all logs. Each measure has a distance, from 0 (alike) to 1, with its 95 %\n"
      "interval; what chance contributes in short logs is subtracted. The mean over the measures\n"
      "says how far the simulated games are from the recorded ones.\n\nMeasures:\n" +
      measures_text() +
      "\nExample:\n  autoref log compare recordings/ --with simulated/ -o comparison.html");
  choose(*verb, chosen, arguments, log_compare_verb);
}

}  // namespace autoref::app
