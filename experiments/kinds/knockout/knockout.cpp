#include "experiments/kinds/knockout/knockout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/kinds/knockout/bracket.hpp"
#include "experiments/kinds/knockout/knockout_report.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

// The key `base`, which turns match.knockout on by default unless the rule book is the paper's, the
// only one without extra time and shoot-outs.
Key base_with_extra_time_key(Knockout& knockout) {
  Key key = base_key(knockout);
  key.read = [&base = knockout.base, read_base = key.read](TopReader& top) {
    read_base(top);
    if (!base.given.contains("match.knockout"))
      base.match.knockout = base.match.rules.name != "paper";
  };
  return key;
}

// Reads `order`, the teams from best to worst seed; if it is missing, sorts them by name.
void read_bracket_order(TopReader& top, Knockout& knockout) {
  for (const auto& [name, team] : knockout.teams) knockout.order.push_back(name);
  const game::YamlEntry* entry = top.find("order");
  if (entry == nullptr) return;
  const auto refuse = [&](const game::YamlLocation& location, const std::string& message) {
    top.file().refuse(location, "order", message);
  };
  const std::string expected =
      "expected every team once, the best first: " + io::listed(knockout.order);
  if (!entry->value.IsSequence()) refuse(game::value_location(*entry), expected);
  std::vector<std::string> order;
  for (const YAML::Node& node : entry->value) {
    const std::string name = node.IsScalar() ? node.Scalar() : "";
    if (!knockout.teams.contains(name))
      refuse(game::location_of(node),
             fmt::format("{}; found '{}', which is not a team", expected, name));
    if (std::find(order.begin(), order.end(), name) != order.end())
      refuse(game::location_of(node), fmt::format("{}; found '{}' twice", expected, name));
    order.push_back(name);
  }
  for (const std::string& name : knockout.order) {
    if (std::find(order.begin(), order.end(), name) == order.end())
      refuse(game::value_location(*entry), fmt::format("{}; '{}' is missing", expected, name));
  }
  knockout.order = order;
}

// The order of the seeds decides which teams play each other in which tie.
Key order_key(Knockout& knockout) {
  Key key{
      "order", "list of names",
      "all teams from the best seed to the worst; in alphabetical order if this key is missing"};
  key.read = [&knockout](TopReader& top) { read_bracket_order(top, knockout); };
  key.text = [&knockout] {
    return fmt::format("order: [{}]  # the best seed first\n", io::listed(knockout.order));
  };
  key.values = [&knockout] { return TextByPath{{"order", io::listed(knockout.order)}}; };
  return key;
}

void read_third_place(TopReader& top, Knockout& knockout) {
  const game::YamlEntry* entry = top.find("third_place");
  if (entry == nullptr) return;
  knockout.third_place = top.word(*entry, "third_place", {game::kYes, game::kNo}) == game::kYes;
  if (!knockout.third_place || knockout.teams.size() >= 4) return;
  top.file().refuse(
      game::value_location(*entry), "third_place",
      fmt::format("a third-place match needs at least 4 teams, found {}; leave this key out",
                  knockout.teams.size()));
}

Key third_place_key(Knockout& knockout) {
  Key key{"third_place", "true or false; false",
          "whether the losers of the semi-finals play for third place"};
  key.read = [&knockout](TopReader& top) { read_third_place(top, knockout); };
  key.text = [&knockout] { return fmt::format("third_place: {}\n", knockout.third_place); };
  return key;
}

// Drops the rows of the ties before the first undecided one.
std::vector<io::Cells> rows_from_first_open_tie(const std::vector<Tie>& ties,
                                                std::vector<io::Cells> rows) {
  const auto open =
      std::find_if(ties.begin(), ties.end(), [](const Tie& tie) { return !tie.is_decided(); });
  if (open != ties.end()) rows.erase(rows.begin() + 1, rows.begin() + 1 + (open - ties.begin()));
  return rows;
}

}  // namespace

constinit const Kind Knockout::kKind = {"knockout", "Single elimination.", make};

std::vector<Key> Knockout::keys() {
  return {base_with_extra_time_key(*this), teams_key(*this, "who takes part", {2, kMostInKnockout}),
          order_key(*this), third_place_key(*this), seed_key(seed)};
}

std::vector<ScheduledGame> Knockout::games() const {
  check(base, teams);
  const std::vector<Tie> ties = bracket_of(*this, [](Tie& tie) {
    tie.games = {game_id(matchup_name({*tie.a, *tie.b}), tie.number, 1)};
    tie.decided_by = DecidedBy::kGoals;
    tie.a_won = true;
  });
  return games_of(*this, ties);
}

std::string Knockout::caveat() const {
  return "assuming that the better seed wins every tie; drawn ties are replayed";
}

Schedule Knockout::schedule(const RowsById& rows) const {
  const std::vector<Tie> ties = bracket_of(*this, rows);
  std::vector<ScheduledGame> known = games_of(*this, ties);
  const auto unknown =
      std::count_if(ties.begin(), ties.end(), [](const Tie& tie) { return !tie.is_known(); });
  const std::size_t needed = known.size() + static_cast<std::size_t>(unknown);
  return {std::move(known), needed};
}

std::string Knockout::why_no_pairs() const {
  return "each tie is one game, replayed if it is drawn";
}

ExperimentResults Knockout::results(const RowsById& rows) const {
  const std::vector<Tie> ties = bracket_of(*this, rows);
  ExperimentResults results;
  results.files = {{"summary.csv", "a row per tie", ties_csv(ties, rows)}};
  results.ties = tie_results(ties, rows);
  results.table = bracket_table(ties, rows);
  results.shown = {
      {rows_from_first_open_tie(ties, bracket_rows(ties, rows)), kBracketColumns, "ties"}};
  results.json = std::make_shared<io::Json>(io::Json{{"ties", json_of(ties)}});
  return results;
}

}  // namespace autoref::experiments
