// The keys of JSON objects, nested ones as paths: "score.yellow", "robots[].number".
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <memory>
#include <set>
#include <sstream>

#include "runner/experiments/kinds/knockout/knockout.hpp"
#include "runner/game/event_log.hpp"
#include "runner/game/game_event.hpp"
#include "runner/judge/judge_report.hpp"
#include "runner/logs/log_report.hpp"
#include "tests/runner/batch/fake_games.hpp"
#include "tests/runner/batch/fake_tuning.hpp"
#include "tests/runner/cli/answer.hpp"
#include "tests/runner/experiments/kinds/situations/small_situations.hpp"
#include "tests/runner/support/written_names.hpp"

namespace autoref::runner {
namespace {

using Paths = std::set<std::string>;

// Adds the paths of all members, including objects and arrays.
void add_paths(const YAML::Node& node, const std::string& prefix, Paths& paths) {
  if (node.IsSequence()) {
    for (const auto& element : node) add_paths(element, prefix + "[]", paths);
  } else if (node.IsMap()) {
    for (const auto& member : node) {
      const std::string path =
          prefix + (prefix.empty() ? "" : ".") + member.first.as<std::string>();
      paths.insert(path);
      add_paths(member.second, path, paths);
    }
  }
}

Paths paths_in(const std::string& lines) {
  Paths paths;
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) add_paths(YAML::Load(line), "", paths);
  return paths;
}

WrittenNames sorted(const Paths& paths) { return {paths.begin(), paths.end()}; }

// The keys of an event line that has every optional object.
WrittenNames event_keys() {
  referee::Decision decision;
  const RobotId robot{Side::kWest, 1};
  decision.stage = Stage::kShootout;
  decision.shootout_kick = referee::ShootoutKick{};
  decision.finding.robots = {robot};
  decision.last_touch = {Side::kWest, robot, 1, 0, 0, robot};
  return sorted(paths_in(decision_json(decision, {})));
}

// A decision that has everything a league event may need.
referee::Decision detailed_decision(referee::Event event) {
  referee::Decision decision;
  decision.finding.event = event;
  decision.finding.robots = {{Side::kWest, 1}, {Side::kEast, 2}};
  decision.finding.position_m = Vec2(0, 0);
  decision.finding.evidence = "because";
  decision.last_touch = {Side::kWest, RobotId{Side::kWest, 1}, 1, 0, 0, std::nullopt};
  const Vec2 anywhere_m(0, 0);
  decision.finding.details = {{}, anywhere_m, anywhere_m, anywhere_m, anywhere_m, 1, 1, true,
                              1,  1,          1,          1,          1,          1, 1, 1};
  return decision;
}

// With PART for the member that belongs to the type.
WrittenNames game_event_keys() {
  Paths paths;
  for (const referee::EventEntry& entry : referee::event_table()) {
    const auto event = game_event_of(detailed_decision(entry.event));
    if (!event) continue;
    for (const std::string& path : paths_in(game_event_json(*event))) {
      const bool is_head = path == "type" || path == "origin" || path == "created_timestamp";
      const std::size_t dot = path.find('.');
      paths.insert(is_head ? path : dot == std::string::npos ? "PART" : "PART" + path.substr(dot));
    }
  }
  return sorted(paths);
}

WrittenNames referee_keys() {
  const Call call{1, 2, {}, "goal", Side::kWest};
  LogRefereeResult result;
  result.agreement.pairs = {{call, call}};
  RecordedFacts facts;
  for (const GameEventType type : {GameEventType::kPossibleGoal, GameEventType::kEmergencyStop}) {
    facts.game_events.emplace_back();
    facts.game_events.back().event.type = type;
  }
  return sorted(paths_in(referee_log_json(result, facts)));
}

WrittenNames game_keys() {
  const TemporaryFolder folder;
  const std::string file = (folder / "game.yaml").string();
  write_content(file,
                "schema: 1\nkind: game\n"
                "teams: { a: { strategy: dummy }, b: { strategy: dummy } }\n"
                "match: { half_s: 1 }\n");
  const Answer answer = answer_to({"play", file.c_str(), "--json"});
  EXPECT_EQ(answer.code, 0) << answer.err;
  Paths paths;
  for (const std::string& path : paths_in(answer.out)) {
    paths.insert(path.starts_with("calls.") ? "calls.EVENT" : path);
  }
  return sorted(paths);
}

WrittenNames judge_keys() {
  JudgeReport report;
  report.tallies.emplace_back().events["goal"] = {};
  report.seeds.emplace_back();
  return sorted(paths_in(json_of(report)));
}

std::string read_back(std::FILE* stream) {
  std::rewind(stream);
  std::string text;
  for (int c = std::fgetc(stream); c != EOF; c = std::fgetc(stream)) {
    text += static_cast<char>(c);
  }
  return text;
}

// The progress output of a run of the experiment, followed by a message.
std::string progress_lines(const Scenario& scenario) {
  const TemporaryFolder folder;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::tmpfile(), std::fclose);
  ExperimentOptions options = fake_options(folder.path());
  options.progress = stream.get();
  options.style = ProgressStyle::kJson;
  run_experiment(scenario, options);
  Progress(stream.get(), ProgressStyle::kJson).say("A message.");
  return read_back(stream.get());
}

WrittenNames progress_keys() {
  Knockout knockout;
  knockout.order = {"zone", "bold"};
  for (const std::string& team : knockout.order) knockout.teams[team] = {};
  Paths paths;
  for (const Scenario& scenario :
       {small_sweep(), small_roundrobin({6, 5}), small_sprt_match(), small_situations(),
        small_tuning("spsa"), Scenario{"A test.", knockout}}) {
    paths.merge(paths_in(progress_lines(scenario)));
  }
  return sorted(paths);
}

}  // namespace

std::vector<Artefact> written_json() {
  return {
      {"Event lines", event_keys, true},      {"Game event lines", game_event_keys, true},
      {"referee --json", referee_keys, true}, {"play --json", game_keys, true},
      {"judge --json", judge_keys, true},     {"run --progress json", progress_keys, true},
  };
}

}  // namespace autoref::runner
