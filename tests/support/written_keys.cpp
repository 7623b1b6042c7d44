// The keys of JSON objects, nested ones as paths: "score.yellow", "robots[].number".
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/game/continuations.hpp"
#include "experiments/kinds/knockout/knockout.hpp"
#include "experiments/scenes/continuation.hpp"
#include "game/loop/event_log.hpp"
#include "game/loop/game_event_fields.hpp"
#include "game/play_counts/play_counts.hpp"
#include "judge/judge_report.hpp"
#include "logs/compare/distance_report.hpp"
#include "logs/fit/fit_report.hpp"
#include "logs/log_report.hpp"
#include "tests/app/answer.hpp"
#include "tests/experiments/kinds/rules/small_rules.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/experiments/kinds/weakness/small_weakness.hpp"
#include "tests/experiments/run/fake_games.hpp"
#include "tests/experiments/run/fake_tuning.hpp"
#include "tests/experiments/run/fake_versions.hpp"
#include "tests/support/written_names.hpp"

namespace autoref {
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
  return sorted(paths_in(game::decision_json(decision, {})));
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
    const auto event = game::game_event_of(detailed_decision(entry.event));
    if (!event) continue;
    for (const std::string& path : paths_in(game::game_event_json(*event))) {
      const bool is_head = path == "type" || path == "origin" || path == "created_timestamp";
      const std::size_t dot = path.find('.');
      paths.insert(is_head ? path : dot == std::string::npos ? "PART" : "PART" + path.substr(dot));
    }
  }
  return sorted(paths);
}

WrittenNames referee_keys() {
  const logs::Call call{1, 2, {}, "goal", Side::kWest};
  logs::LogRefereeResult result;
  result.agreement.pairs = {{call, call}};
  logs::RecordedFacts facts;
  for (const GameEventType type : {GameEventType::kPossibleGoal, GameEventType::kEmergencyStop}) {
    facts.game_events.emplace_back();
    facts.game_events.back().event.type = type;
  }
  return sorted(paths_in(logs::referee_log_json(result, facts)));
}

WrittenNames fit_keys() {
  const logs::FittedNumber number{"ball", "roll_mps2", {}};
  logs::LogFit fit;
  fit.ball = {number};
  fit.teams = {{"yellow", {number}}};
  fit.cameras[0] = {};
  fit.ball_seen.emplace_back();
  fit.roll_prediction = logs::RollPrediction{};
  return sorted(paths_in(logs::fit_json(fit)));
}

WrittenNames comparison_keys() {
  logs::GameComparison comparison;
  comparison.measures.emplace_back();
  return sorted(paths_in(logs::comparison_json(comparison, {})));
}

WrittenNames game_keys() {
  const TemporaryFolder folder;
  const std::string file = (folder / "game.yaml").string();
  write_content(file,
                "schema: 1\nkind: game\n"
                "teams: { a: { strategy: dummy }, b: { strategy: dummy } }\n"
                "match: { half_s: 1 }\n");
  const app::Answer answer = app::answer_to({"play", file.c_str(), "--json"});
  EXPECT_EQ(answer.code, 0) << answer.err;
  Paths paths;
  for (const std::string& path : paths_in(answer.out))
    paths.insert(path.starts_with("calls.") ? "calls.EVENT" : with_general_name(path, ".", ""));
  return sorted(paths);
}

WrittenNames continuation_keys() {
  const experiments::FollowingEvent goal{1.5, game::SceneEnd::kGoal, Side::kWest};
  io::Json json = experiments::continuations_json({{1, "", goal, goal, {{1, 0}}, Side::kWest}},
                                                  {{"basic (yellow)", "zone (blue)"}}, false);
  json["log"] = app::json_of(app::RecordedSequel{2.5, Side::kWest});
  return sorted(paths_in(io::json_text(json)));
}

WrittenNames judge_keys() {
  judge::JudgeReport report;
  report.tallies.emplace_back().events["goal"] = {};
  report.seeds.emplace_back();
  return sorted(paths_in(judge::json_of(report)));
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
std::string progress_lines(const experiments::Scenario& scenario) {
  const TemporaryFolder folder;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::tmpfile(), std::fclose);
  experiments::ExperimentOptions options = experiments::fake_options(folder.path());
  options.progress = stream.get();
  options.style = io::ProgressStyle::kJson;
  experiments::run_experiment(scenario, options);
  io::Progress(stream.get(), io::ProgressStyle::kJson).say("A message.");
  return read_back(stream.get());
}

WrittenNames progress_keys() {
  experiments::Knockout knockout;
  knockout.order = {"zone", "bold"};
  for (const std::string& team : knockout.order) knockout.teams[team] = {};
  experiments::Scenario versions = experiments::versioned_robin();
  versions.as<experiments::RoundRobin>()->versions.taken_over = experiments::TakenOver{"1.0", {}};
  Paths paths;
  for (const experiments::Scenario& scenario :
       {versions, experiments::small_sweep(), experiments::small_roundrobin({6, 5}),
        experiments::small_sprt_match(), experiments::small_comparison(),
        experiments::small_situations(), experiments::small_rules(),
        experiments::read_scenario_text(experiments::weakness_text("searches: 1\niterations: 1\n"),
                                        "x.yaml"),
        experiments::small_tuning("spsa"), experiments::Scenario{"A test.", knockout}}) {
    paths.merge(paths_in(progress_lines(scenario)));
  }
  return sorted(paths);
}

}  // namespace

std::vector<Artefact> written_json() {
  return {
      {"Event lines", event_keys, true},
      {"Game event lines", game_event_keys, true},
      {"referee log --json", referee_keys, true},
      {"log fit --json", fit_keys, true},
      {"log compare --json", comparison_keys, true},
      {"play --json", game_keys, true},
      {"play --games --json", continuation_keys, true},
      {"judge --json", judge_keys, true},
      {"run --progress json", progress_keys, true},
  };
}

}  // namespace autoref
