#include "tests/referee/rules/case_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "soccer/rules/rule_book.hpp"
#include "tests/referee/rules/case_words.hpp"
#include "tests/referee/rules/script_reader.hpp"
#include "tests/referee/rules/yaml_keys.hpp"

namespace autoref::referee {
namespace {

// The common properties of a file's cases.
struct FileHead {
  std::string file;
  std::string rule;
  std::string book;
  std::vector<Event> events;  // of the rule
};

void read_side(YamlKeys& keys, Side side, std::vector<StagedRobot>& robots) {
  const std::string name(name_of(side));
  if (!keys.has(name)) return;
  YamlKeys list(keys.child(name), keys.file());
  for (const auto& entry : list.node()) {
    const std::string number = entry.first.as<std::string>();
    YamlKeys robot(list.child(number), keys.file());
    StagedRobot staged;
    staged.id = robot_of(list, number, name + " " + number);
    if (robot.has("at_m")) staged.at_m = robot.vector("at_m");
    staged.facing_deg = robot.number(staged.at_m ? "facing_deg" : "behind_ball_facing_deg");
    robot.finish();
    robots.push_back(staged);
  }
}

Expected read_expected(YamlKeys& keys) {
  Expected expected;
  expected.event = event_of(keys, "event", keys.text("event"));
  expected.from_s = keys.number("from_s");
  expected.to_s = keys.number("to_s");
  if (keys.has("offender")) expected.offender = side_of(keys, "offender");
  if (keys.has("card")) expected.card = card_of(keys, "card");
  if (keys.has("next")) expected.next = command_of(keys, "next");
  if (keys.has("ball_m")) expected.ball_m = keys.vector("ball_m");
  if (expected.ball_m) expected.within_m = keys.number_or("within_m", expected.within_m);
  if (keys.has("robots")) {
    expected.robots.emplace();
    for (const YAML::Node& robot : keys.child("robots")) {
      expected.robots->push_back(robot_of(keys, "robots", robot.as<std::string>()));
    }
  }
  keys.finish();
  return expected;
}

PerSide<int> read_numbers(YamlKeys& keys, const std::string& key) {
  PerSide<int> numbers;
  if (!keys.has(key)) return numbers;
  YamlKeys sides(keys.child(key), keys.file());
  for (const Side side : kSides) {
    const std::string name(name_of(side));
    if (sides.has(name)) numbers[side] = sides.whole_number(name);
  }
  sides.finish();
  return numbers;
}

void read_opening(YamlKeys& keys, Case& it) {
  it.opening = word_in<Opening>(keys, "play", keys.text("play"),
                                {{"running", Opening::kRunning},
                                 {"kickoff", Opening::kKickoff},
                                 {"throw_in", Opening::kThrowIn},
                                 {"goal_kick", Opening::kGoalKick},
                                 {"corner_kick", Opening::kCornerKick},
                                 {"penalty", Opening::kPenalty}});
  if (it.opening != Opening::kRunning) {
    it.taken_by = side_of(keys, "taken_by");
    it.from_the_stop = word_in<bool>(keys, "begins_with", keys.text_or("begins_with", "start"),
                                     {{"stop", true}, {"start", false}});
  }
  if (it.from_the_stop && it.opening == Opening::kKickoff) {
    keys.refuse("begins_with", "there is no stop before the first kick-off");
  }
  if (it.opening != Opening::kKickoff) it.ball_m = keys.vector("ball_m");
}

// A case lists expected calls, forbidden calls, or both; or it has `nothing`, which forbids all
// calls.
void read_outcome(YamlKeys& keys, const FileHead& head, Case& it) {
  if (keys.has("expect")) {
    for (const YAML::Node& node : keys.child("expect")) {
      YamlKeys expected(node, keys.file());
      it.expected.push_back(read_expected(expected));
      it.until_s = std::max(it.until_s, it.expected.back().to_s);
    }
  }
  if (keys.has("never")) it.never = events_of(keys, "never");
  it.others_allowed = keys.has("never");
  const bool nothing = keys.has("nothing") && keys.yes_or_no("nothing");
  if (it.expected.empty() && it.never.empty() && !nothing) {
    keys.refuse("expect", "a case needs `expect`, `never` or `nothing: true`");
  }
  if (nothing && (it.others_allowed || !it.expected.empty())) {
    keys.refuse("nothing", "excludes `expect` and `never`");
  }
  if (it.expected.empty() || keys.has("until_s")) it.until_s = keys.number("until_s");
  if (keys.has("goals")) it.goals = read_numbers(keys, "goals");
  it.is_negative = std::none_of(it.expected.begin(), it.expected.end(), [&](const Expected& call) {
    return std::count(head.events.begin(), head.events.end(), call.event) > 0;
  });
}

void read_switches(YamlKeys& keys, Case& it) {
  if (!keys.has("switch")) return;
  YamlKeys switches(keys.child("switch"), keys.file());
  for (const auto& entry : switches.node()) {
    const std::string rule = entry.first.as<std::string>();
    if (!find_rule(rule)) switches.refuse(rule, "no such rule");
    it.switches[rule] = switches.yes_or_no(rule);
  }
}

void read_case(YamlKeys& keys, const FileHead& head, Case& it) {
  it.source = keys.text("source");
  it.book = keys.text_or("rules", head.book);
  if (!find_rule_book(it.book)) keys.refuse("rules", "no rule book " + it.book);
  read_switches(keys, it);
  it.keepers = read_numbers(keys, "keepers");
  it.score = read_numbers(keys, "score");
  read_opening(keys, it);
  for (const Side side : kSides) read_side(keys, side, it.robots);
  it.script = read_script(keys);
  it.ball_deceleration_mps2 = keys.number_or("ball_deceleration_mps2", it.ball_deceleration_mps2);
  it.placement_mps = keys.number_or("placement_mps", 0);
  if (keys.has("noise_m")) {
    it.noise_m = keys.number("noise_m");
    it.seed = static_cast<std::uint64_t>(keys.whole_number("seed"));
  }
  read_outcome(keys, head, it);
  keys.finish();
}

FileHead read_head(YamlKeys& keys) {
  FileHead head;
  head.file = keys.file();
  head.rule = keys.text("rule");
  head.book = keys.text("rules");
  if (!find_rule(head.rule)) keys.refuse("rule", "no such rule");
  head.events = events_of(keys, "events");
  return head;
}

Case unreadable(const std::string& file, const std::string& why) {
  Case broken;
  broken.name = "The file " + std::filesystem::path(file).stem().string() + " can be read";
  broken.location = file;
  broken.error = why;
  return broken;
}

}  // namespace

std::vector<Case> cases_in(const std::string& text, const std::string& file) try {
  YamlKeys keys(YAML::Load(text), file);
  const YAML::Node list = keys.child("cases");
  const FileHead head = read_head(keys);
  keys.finish();
  std::vector<Case> cases;
  for (const YAML::Node& node : list) {
    YamlKeys case_keys(node, file);
    Case& it = cases.emplace_back();
    it.name = case_keys.text("case");
    it.rule = head.rule;
    it.location = file + ":" + std::to_string(node.Mark().line + 1);
    try {
      read_case(case_keys, head, it);
    } catch (const std::exception& error) {
      it.error = error.what();
    }
  }
  return cases;
} catch (const std::exception& error) {
  return {unreadable(file, error.what())};
}

std::vector<Case> read_cases(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Case> all;
  for (const std::filesystem::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    const std::vector<Case> cases = cases_in(text.str(), file.filename().string());
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

}  // namespace autoref::referee
