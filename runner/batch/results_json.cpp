#include "runner/batch/results_json.hpp"

#include <nlohmann/json.hpp>
#include <optional>

#include "runner/analysis/sprt_match_report.hpp"
#include "runner/analysis/tuning_report.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

Json mean_json(const std::vector<double>& sample) {
  return sample.empty() ? Json() : Json(mean(sample));
}

Json number_json(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json name_json(const std::optional<std::string>& name) { return name ? Json(*name) : Json(); }

std::optional<std::string> winner_in(const Tie& tie) {
  return tie.is_decided() ? (tie.a_won ? tie.a : tie.b) : std::nullopt;
}

}  // namespace

Json json_of(const SprtMatchState& state) {
  return {{"verdict", name_of(state.test.verdict)},
          {"test_pairs", state.test.pairs},
          {"log_likelihood_ratio", state.test.log_likelihood_ratio}};
}

Json json_of(const Tuning& tuning, const TuningState& state) {
  Json parameters = Json::array();
  for (std::size_t i = 0; i < tuning.parameters.size(); ++i) {
    const TunedParameter& parameter = tuning.parameters[i];
    parameters.push_back(
        {{"name", parameter.name}, {"start", parameter.start}, {"best", state.best[i]}});
  }
  const auto& [low, high] = bounds_of(state.test.interval);
  return {{"iteration", state.path.size()},
          {"iterations", tuning.iterations},
          {"parameters", parameters},
          {"verdict", name_of(state.test.state.verdict)},
          {"gain", number_json(state.test.gain)},
          {"low95", number_json(low)},
          {"high95", number_json(high)},
          {"pairs", state.test.state.pairs}};
}

Json json_of(const std::vector<Tie>& ties) {
  Json all = Json::array();
  for (const Tie& tie : ties) {
    all.push_back({{"tie", tie.name},
                   {"team_a", name_json(tie.a)},
                   {"team_b", name_json(tie.b)},
                   {"games", tie.games.size()},
                   {"decided_by", name_of(tie.decided_by)},
                   {"winner", name_json(winner_in(tie))}});
  }
  return all;
}

Json json_of(const std::vector<SceneGroup>& groups) {
  Json all = Json::array();
  for (const SceneGroup& group : groups) {
    all.push_back({{"situation", group.matchup.situation},
                   {"attackers", group.matchup.attackers},
                   {"defenders", group.matchup.defenders},
                   {"scenes", group.scores.size()},
                   {"void_scenes", group.void_scenes},
                   {"goals", group.goals},
                   {"mean_score", mean_json(group.scores)}});
  }
  return all;
}

}  // namespace autoref::runner
