#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/log/judged_log.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "io/table_columns.hpp"
#include "io/terminal.hpp"
#include "logs/log_report.hpp"
#include "logs/log_tables.hpp"
#include "logs/speeds.hpp"
#include "logs/user_log.hpp"

namespace autoref::app {
namespace {

struct InfoArguments {
  std::vector<std::string> logs;
  std::string rules;  // empty: guessed
  bool commands = false;
  bool json = false;
};

int show_log(const std::string& log, const InfoArguments& arguments) {
  const logs::RecordedFacts facts = logs::read_facts(log, logs::seekable_log(log));
  fmt::print("{}\n",
             arguments.json ? logs::info_json(facts) : logs::info_text(facts, arguments.commands));
  io::write_message(stderr, logs::damage_text(log, facts));
  return facts.log.damage ? io::kBadInput : io::kDone;
}

// A row of the table, for people.
io::Cells summary_cells(const logs::SummaryRow& row) {
  io::Cells cells;
  for (const auto& column : logs::summary_columns()) {
    const io::ColumnValue value = column.value(row);
    const auto* number = std::get_if<std::optional<double>>(&value);
    cells.push_back(number != nullptr && *number ? fmt::format("{:.2f}", **number)
                                                 : io::cell_of(value));
  }
  return cells;
}

// A row for each log and team. The logs are judged one after the other, and only their rows kept.
int show_logs(const std::vector<std::string>& paths, const InfoArguments& arguments) {
  io::TextTable table{{io::heads_of(logs::summary_columns())},
                      {io::Align::kLeft, io::Align::kLeft, io::Align::kLeft},
                      2};
  table.columns.resize(table.rows.front().size(), io::Align::kRight);
  io::Json rows = io::Json::array();
  const int code = for_each_log(paths, [&](const std::string& path) {
    logs::SpeedCollector speeds;
    const JudgedLog judged = judged_log(
        path, arguments.rules, [&](const logs::LogReferee& referee) { speeds.add(referee); });
    for (const Side side : kSides) {
      const logs::SummaryRow row{path, &judged.facts, &judged.result, &speeds.speeds()[side], side};
      table.rows.push_back(summary_cells(row));
      io::add_members(rows.emplace_back(io::Json::object()), logs::summary_columns(), row);
    }
    return !judged.facts.log.damage;
  });
  fmt::print("{}\n",
             arguments.json ? io::json_text(rows) : io::table_text(table, io::text_width(stdout)));
  return code;
}

int info_verb(const InfoArguments& arguments) {
  const std::vector<std::string> paths = logs::logs_in(arguments.logs);
  if (paths.size() == 1 && paths.front() == arguments.logs.front())
    return show_log(paths.front(), arguments);
  if (arguments.commands)
    throw io::InputError({"--commands"}, "", "lists the commands of one log, not of several");
  return show_logs(paths, arguments);
}

}  // namespace

void add_info_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("info", "Summarise an SSL log, or compare the teams in several.");
  auto arguments = std::make_shared<InfoArguments>();
  add_logs_argument(*verb, arguments->logs);
  verb->add_flag("--commands", arguments->commands, "List every command with its time.");
  verb->add_option("--rules", arguments->rules,
                   "Rule book for several logs; guessed from each log by default.")
      ->type_name("BOOK");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "With several logs or a folder, AutoRef referees each of them; one table has a row per log\n"
      "and team: goals (as recorded), AutoRef's calls against the team, possession chains, shots,\n"
      "expected goals, passes, and speeds while the ball is in play (mean and 99th percentile).\n\n"
      "If the log is damaged, summarises the part before the damage, prints its position on\n"
      "stderr and exits with code 2.\n\n"
      "Example:\n  autoref log info game.log.gz --commands\n"
      "  autoref log info recordings/");
  choose(*verb, chosen, arguments, info_verb);
}

}  // namespace autoref::app
