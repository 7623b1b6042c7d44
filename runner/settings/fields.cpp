#include "runner/settings/fields.hpp"

#include "runner/settings/settings_branch.hpp"
#include "soccer/rule_table.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    names.emplace_back(entry.name);
  }
  names.emplace_back(kNetworkStrategy);
  return names;
}

// Words for the laws that a team knows: the rule books of the league, and none of them.
std::vector<std::string> laws_names() {
  std::vector<std::string> names = rule_book_names();
  std::erase_if(names, [](const std::string& name) {
    return find_rule_book(name)->edition == Edition::kPaper;
  });
  names.emplace_back(kEnforcedOnly);
  return names;
}

void list_changes(RobotChanges& changes, Branch to) {
  to.add("robot", ChangesOf{&changes, "robot"}, {}, "overrides of sim.robot");
  to.add("kicker", ChangesOf{&changes, "kicker"}, {}, "overrides of sim.kicker");
  to.add("dribbler", ChangesOf{&changes, "dribbler"}, {}, "overrides of sim.dribbler");
}

// Settings common to a team's robots and a single robot.
template <typename Of>
void list_robots(Of& of, const RobotTypes& types, Branch to) {
  to.add("type", TypeName{&of.type, &types}, {}, "robot type");
  to.number("speed_factor", of.speed_factor, positive(2), "", "scales the robots' top speed");
  to.number("acceleration_factor", of.acceleration_factor, positive(2), "",
            "scales their acceleration and braking");
  to.add("handicap", BothFactors{&of.speed_factor, &of.acceleration_factor}, positive(2),
         "sets speed_factor and acceleration_factor");
  list_changes(of.changes, to);
}

void list_types(RobotTypes& types, Branch to) {
  to.add("types", &types, {}, "robot types by name");
  for (auto& [name, changes] : types) list_changes(changes, to.below("types").below(name));
}

void list_team(TeamSettings& team, const RobotTypes& types, Branch to) {
  to.word("strategy", team.strategy, strategy_names(), "the team's strategy");
  to.word("laws", team.laws, laws_names(),
          "the laws that the team knows: it keeps to the rules in force and to these, whether or "
          "not they are in force; enforced: only to the rules in force");
  to.add("command", CommandWords{&team.command}, {},
         "the team is this program, instead of a strategy");
  to.add("directory", FreeText{&team.directory}, {}, "working directory of the program");
  to.add("environment", CommandWords{&team.environment}, {},
         "variables of the program's environment, such as [MODE=fast]");
  to.add("files", CommandWords{&team.files}, {},
         "files and folders of the program, which belong to the identity of its games; without, "
         "the command's words that are files");
  to.add("files_hash", FreeText{&team.files_hash}, {}, "what they contain, noted by AutoRef");
  to.number("answer_s", team.answer_s, positive(3600), "s",
            "how long the program may take for an answer, by the wall clock");
  to.number("memory_mb", team.memory_mb, {16, 1 << 20}, "MB", "memory of each of its processes");
  to.number("robots", team.robots, {1, kMaxRobots}, "", "number of robots on the field");
  list_robots(team, types, to);
  to.add("players", &team.players, {}, "robots that differ from the team, by number");
  for (auto& [number, player] : team.players) {
    list_robots(player, types, to.below("players").below(std::to_string(number)));
  }
  // The range depends on the strategy's parameter; check_team() checks it.
  to.add("params", &team.params, {-1e9, 1e9}, "parameters of the strategy, by name");
}

void list_match(GameSettings& game, Branch to) {
  MatchSettings& match = game.match;
  const std::vector<std::string> sides = {"west", "east"};
  to.preset(
      "rules", RulesChoice{&game}, rule_book_names(),
      "rule book; also sets switch, half_s, extra_half_s, change_ends, field, robots, kickers, "
      "dribblers and latency_error_s");
  to.number("half_s", match.half_s, positive(36000), "s", "length of a half");
  to.number("halves", match.halves, {1, 2}, "", "number of halves");
  to.number("break_s", match.break_s, {0, 3600}, "s", "break between halves");
  to.yes_or_no("knockout", match.knockout, "extra time and a shoot-out after a draw");
  to.word("after_game", match.after_game, {"halt", "new_game"},
          "what the referee does after the game; the result row covers one game only");
  to.word("on_team_fault", match.on_team_fault, {"void", "forfeit"},
          "whether a game in which a team fails has no result or is won by the other team");
  to.word("control", match.control, {"autoref", "human", "none", "game-controller"},
          "who commands the game; human and none only in recorded games, game-controller only in "
          "play");
  to.number("least_confidence", match.least_confidence, {0, 1}, "",
            "fouls of which the referee is less sure than this are not called");
  to.word("placement", match.placement, {"simulator", "teams"},
          "who places the ball for free kicks and force starts");
  to.number("extra_half_s", match.extra_half_s, positive(36000), "s",
            "length of each half of extra time");
  to.yes_or_no("change_ends", match.change_ends,
               "the teams change ends before every half after the first");
  to.word("a_plays", match.a_plays, sides, "side of team a; team b plays on the other");
  to.word("first_kickoff", match.first_kickoff, sides, "side that kicks off first");
  Branch switches = to.below("switch");
  for (const RuleEntry& entry : rule_table()) {
    switches.yes_or_no(std::string(name_of(entry.rule)), match.in_force[entry.rule], entry.about);
  }
}

void list_field(Field& field, Branch to) {
  const std::vector<std::string> shapes = {"quarter_circles", "box"};
  to.number("length_m", field.length_m, {4, 30}, "m",
            "distance between the outer edges of the goal lines");
  to.number("width_m", field.width_m, {2, 20}, "m",
            "distance between the outer edges of the touch lines");
  to.number("run_off_m", field.run_off_m, {0.1, 5}, "m",
            "distance from the touch lines to the wall");
  to.number("goal_line_run_off_m", field.goal_line_run_off_m, {0, 5}, "m",
            "distance from the goal lines to the wall; 0: run_off_m");
  to.number(
      "goal_substitution_area_m", field.goal_substitution_area_m, {0, 5}, "m",
      "width of the areas behind the goal lines in which robots may be exchanged; 0: without; "
      "vision says so, and nothing else depends on it");
  to.number("line_width_m", field.line_width_m, {0, 0.05}, "m", "width of the lines");
  to.number("centre_circle_radius_m", field.centre_circle_radius_m, {0.1, 5}, "m",
            "radius to the outer edge of the line");
  to.number("penalty_mark_m", field.penalty_mark_m, positive(20), "m",
            "distance from the goal line of the attacked goal");
  to.word("defence_area.shape", field.defence_area.shape, shapes, "shape of the defence area");
  to.number("defence_area.depth_m", field.defence_area.depth_m, positive(5), "m",
            "radius of the quarter circles, or extent of the box along x");
  to.number("defence_area.straight_m", field.defence_area.straight_m, {0, 10}, "m",
            "length between the quarter circles, or extent of the box along y");
  to.number("goal_width_m", field.goal_width_m, {0.2, 5}, "m", "distance between the posts");
  to.number("goal_depth_m", field.goal_depth_m, {0.05, 1}, "m",
            "distance from the goal line to the back wall");
  to.number("goal_opening_height_m", field.goal_opening_height_m, positive(2), "m",
            "clear height under the bar");
  to.number("goal_bar_radius_m", field.goal_bar_radius_m, {0.001, 0.05}, "m",
            "radius of the goal's round bar");
  to.number("goal_wall_thickness_m", field.goal_wall_thickness_m, {0.01, 0.1}, "m",
            "thickness of the goal walls");
  to.yes_or_no("goal_sides_reach_wall", field.goal_sides_reach_wall,
               "the goals' side walls go on to the wall, so nothing passes behind a goal");
}

}  // namespace

std::vector<Setting> settings_of(GameSettings& game) {
  std::vector<Setting> list;
  list_types(game.types, Branch(list, ""));
  list_team(game.a, game.types, Branch(list, "teams.a."));
  list_team(game.b, game.types, Branch(list, "teams.b."));
  list_match(game, Branch(list, "match."));
  list_field(game.field, Branch(list, "field."));
  for (Setting& setting : settings_of(game.sim, game.robot)) list.push_back(std::move(setting));
  Branch(list, "").number("seed", game.seed, {0, 18446744073709551615.0}, "",
                          "the game's random seed");
  return list;
}

std::vector<Setting> settings_of(TeamSettings& team, const RobotTypes& types,
                                 const std::string& prefix) {
  std::vector<Setting> list;
  list_team(team, types, Branch(list, prefix));
  return list;
}

std::vector<Setting> settings_of(RobotChanges& changes) {
  std::vector<Setting> list;
  list_changes(changes, Branch(list, ""));
  return list;
}

}  // namespace autoref::runner
