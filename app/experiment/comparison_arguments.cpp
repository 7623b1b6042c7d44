#include "app/experiment/comparison_arguments.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/experiment/team_argument.hpp"
#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/slurm.hpp"
#include "experiments/statistics/sample_size.hpp"
#include "game/settings/fields.hpp"
#include "io/build_id.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "io/yaml_text.hpp"

namespace autoref::app {
namespace {

using experiments::kNewTeam;
using experiments::kOldTeam;

constexpr const char* kUsualSeed = "1";

// What the arguments say: the teams with their names in the scenario, and all settings.
struct GivenComparison {
  std::string about;
  std::vector<std::string> opponents;  // names of the common opponents
  game::Assignments settings;          // with full paths
  int pairs = 0;                       // maximum number of pairs per opponent
};

// The part of the path in front of its first dot.
std::string first_part(const std::string& path) { return path.substr(0, path.find('.')); }

// Refuses a path that names teams instead of a setting of one of them.
void refuse_whole_teams(const game::Assignment& change) {
  const std::string first = first_part(change.path);
  if (first != "teams" && first != "against") return;
  const std::size_t dot = change.path.find('.');
  const std::string name = dot == std::string::npos ? "" : first_part(change.path.substr(dot + 1));
  const bool is_setting = change.path.size() > first.size() + 1 + name.size() + 1;
  const bool is_known = first == "against" || name == kOldTeam || name == kNewTeam;
  if (is_setting && is_known) return;
  throw io::InputError({change.flag}, "",
                       "expected a setting of one of the teams old and new, such as new.robots=5 "
                       "or new.strategy=cobalt");
}

// --set, where `old.` and `new.` stand for teams.old. and teams.new.
game::Assignments changes_in(const CompareArguments& arguments) {
  game::Assignments changes = game::assignments_in(arguments.sets);
  for (game::Assignment& change : changes) {
    const std::string first = first_part(change.path);
    if (first == kOldTeam || first == kNewTeam) change.path = "teams." + change.path;
    change.path = game::full_path(change.path);
    refuse_whole_teams(change);
  }
  return changes;
}

void add_team(const TeamArgument& team, const std::string& branch, GivenComparison& given) {
  for (game::Assignment setting : team.settings) {
    setting.path = branch + "." + setting.path;
    given.settings.push_back(std::move(setting));
  }
}

// "basic with params.kick_caution=0.7".
std::string description_of(const TeamArgument& team, const char* name,
                           const game::Assignments& changes) {
  const std::string branch = fmt::format("teams.{}.", name);
  std::vector<std::string> texts;
  for (const game::Assignment& change : changes) {
    if (change.path.starts_with(branch))
      texts.push_back(change.path.substr(branch.size()) + "=" + change.value);
  }
  return texts.empty() ? team.text : fmt::format("{} with {}", team.text, fmt::join(texts, ", "));
}

// The parts of a list separated by commas, except within quotes.
std::vector<std::string> listed_teams(const std::string& list) {
  std::vector<std::string> teams(1);
  char quote = 0;
  for (const char c : list) {
    if (quote == 0 && c == ',') {
      teams.emplace_back();
      continue;
    }
    if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    }
    teams.back() += c;
  }
  return teams;
}

std::vector<TeamArgument> opponents_in(const CompareArguments& arguments) {
  std::vector<TeamArgument> opponents;
  std::set<std::string> names = {kOldTeam, kNewTeam, experiments::kAllOpponents};
  for (const std::string& list : arguments.against) {
    for (const std::string& team : listed_teams(list)) {
      TeamArgument opponent = team_argument(std::string(io::trimmed(team)), "--against");
      const std::string name = opponent.name;
      for (int number = 2; !names.insert(opponent.name).second; ++number)
        opponent.name = fmt::format("{}_{}", name, number);
      opponents.push_back(std::move(opponent));
    }
  }
  return opponents;
}

void refuse_missing_team(const CompareArguments& arguments, const game::Assignments& changes) {
  const bool is_changed =
      std::any_of(changes.begin(), changes.end(),
                  [](const game::Assignment& change) { return change.path.starts_with("teams."); });
  if (!arguments.new_team.empty() || is_changed) return;
  throw io::InputError(
      {"NEW"}, "",
      "give a second team, or what changes in the first one, such as --set new.robots=5 or --set "
      "new.params.NAME=VALUE (autoref show teams OLD lists a team's parameters)");
}

int pairs_in(const CompareArguments& arguments, std::size_t opponents) {
  const int games_of_a_pair = 2 * (1 + 2 * static_cast<int>(opponents));
  const int most =
      std::min(experiments::kMostPairs, experiments::kMostScheduledGames / games_of_a_pair) *
      games_of_a_pair;
  if (arguments.games >= games_of_a_pair && arguments.games <= most)
    return arguments.games / games_of_a_pair;
  throw io::InputError(
      {"--games"}, "",
      fmt::format("expected {} games, a pair of legs in each matchup, to {}; found {}",
                  games_of_a_pair, most, arguments.games));
}

void check_least(double least) {
  const Range& range = experiments::kLeastDifference;
  if (least > range.low && least <= range.high) return;  // false for NaN
  throw io::InputError({"--least"}, "",
                       fmt::format("expected a number above {} and at most {}, found {}", range.low,
                                   range.high, least));
}

// "Is new better than old? old: basic; new: counter; both also against zone."
std::string about_text(const TeamArgument& old_team, const TeamArgument& new_team,
                       const std::vector<std::string>& opponents,
                       const game::Assignments& changes) {
  const std::string text = fmt::format("Is new better than old? old: {}; new: {}",
                                       description_of(old_team, kOldTeam, changes),
                                       description_of(new_team, kNewTeam, changes));
  return opponents.empty() ? text + "."
                           : fmt::format("{}; both also against {}.", text, io::listed(opponents));
}

void add_game_settings(const CompareArguments& arguments, GivenComparison& given) {
  given.settings.push_back({"--rules " + arguments.rules, "match.rules", arguments.rules});
  if (!arguments.camera.empty())
    given.settings.push_back({"--camera " + arguments.camera, "sim.camera", arguments.camera});
}

GivenComparison given_in(const CompareArguments& arguments) {
  check_least(arguments.least);
  const game::Assignments changes = changes_in(arguments);
  const TeamArgument old_team = team_argument(arguments.old_team, "OLD");
  refuse_missing_team(arguments, changes);
  const TeamArgument new_team =
      arguments.new_team.empty() ? old_team : team_argument(arguments.new_team, "NEW");
  GivenComparison given;
  add_game_settings(arguments, given);
  add_team(old_team, "teams.old", given);
  add_team(new_team, "teams.new", given);
  for (const TeamArgument& opponent : opponents_in(arguments)) {
    add_team(opponent, "against." + opponent.name, given);
    given.opponents.push_back(opponent.name);
  }
  given.settings.insert(given.settings.end(), changes.begin(), changes.end());
  given.about = about_text(old_team, new_team, given.opponents, changes);
  given.pairs = pairs_in(arguments, given.opponents.size());
  return given;
}

// The keys of the scenario that are not settings of games or teams.
YAML::Node scenario_node(const CompareArguments& arguments, const GivenComparison& given) {
  YAML::Node node;
  node["schema"] = "1";
  node["kind"] = std::string(experiments::Comparison::kKind.name);
  node["about"] = given.about;
  node["base"] = YAML::Node(YAML::NodeType::Map);
  for (const char* team : {kOldTeam, kNewTeam})
    node["teams"][team] = YAML::Node(YAML::NodeType::Map);
  for (const std::string& opponent : given.opponents)
    node["against"][opponent] = YAML::Node(YAML::NodeType::Map);
  node["test"]["least"] = io::text_of(arguments.least);
  node["test"]["max_pairs"] = std::to_string(given.pairs);
  node["seed"] = kUsualSeed;
  return node;
}

void set_in(YAML::Node node, const std::string& path, const std::string& value) {
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) node.reset(node[part]);
  node = value;
}

std::string text_of(const YAML::Node& node) {
  YAML::Emitter text;
  text << node;
  return std::string(text.c_str()) + "\n";
}

}  // namespace

std::string scenario_text(const CompareArguments& arguments) {
  const GivenComparison given = given_in(arguments);
  YAML::Node node = scenario_node(arguments, given);
  if (!arguments.seed.empty()) node["seed"] = arguments.seed;
  for (const game::Assignment& setting : given.settings) {
    const std::string branch = setting.path.substr(0, setting.path.find('.'));
    const bool is_of_team = branch == "teams" || branch == "against";
    set_in(node, (is_of_team ? "" : "base.") + setting.path, setting.value);
  }
  return text_of(node);
}

std::string command_text(const CompareArguments& arguments) {
  const CompareArguments usual;
  std::string text = "autoref compare " + experiments::plain_shell_word(arguments.old_team);
  const auto add = [&text](const std::string& option, const std::string& value) {
    text += (option.empty() ? "" : " " + option) + " " + experiments::plain_shell_word(value);
  };
  if (!arguments.new_team.empty()) add("", arguments.new_team);
  for (const std::string& list : arguments.against) add("--against", list);
  if (arguments.least != usual.least) add("--least", io::text_of(arguments.least));
  if (arguments.games != usual.games) add("--games", std::to_string(arguments.games));
  if (arguments.rules != usual.rules) add("--rules", arguments.rules);
  if (!arguments.camera.empty()) add("--camera", arguments.camera);
  if (!arguments.seed.empty()) add("--seed", arguments.seed);
  for (const std::string& change : arguments.sets) add("--set", change);
  return text;
}

experiments::Scenario comparison_in(const CompareArguments& arguments) {
  const GivenComparison given = given_in(arguments);
  experiments::Scenario scenario = experiments::read_scenario_text(
      text_of(scenario_node(arguments, given)), "the comparison", given.settings);
  override_seed(arguments.seed, scenario);
  experiments::note_program_versions(scenario);
  return scenario;
}

std::string results_name(const CompareArguments& arguments, const experiments::Scenario& scenario) {
  experiments::Scenario games = scenario;
  games.about.clear();
  games.as<experiments::Comparison>()->test = {};  // decides only how many games are played
  io::ByteHash hash;
  hash.add(experiments::effective_text(games));
  hash.add(io::build_id());
  const std::string old_team = team_argument(arguments.old_team, "OLD").name;
  const std::string new_team =
      arguments.new_team.empty() ? old_team : team_argument(arguments.new_team, "NEW").name;
  return fmt::format("compare-{}-{}-{}", old_team, new_team,
                     io::hash_text(hash.value()).substr(0, 8));
}

}  // namespace autoref::app
