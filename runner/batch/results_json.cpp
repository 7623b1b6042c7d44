#include "runner/batch/results_json.hpp"

#include <optional>

#include "runner/analysis/sprt_match_report.hpp"
#include "runner/io/json.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

std::string mean_json(const std::vector<double>& sample) {
  return sample.empty() ? "null" : json_number(mean(sample));
}

std::string name_json(const std::optional<std::string>& name) {
  return name ? json_text(*name) : "null";
}

std::string texts_json(const std::vector<std::string>& texts) {
  std::vector<std::string> values;
  values.reserve(texts.size());
  for (const std::string& text : texts) values.push_back(json_text(text));
  return json_list(values);
}

std::optional<std::string> winner_in(const Tie& tie) {
  return tie.is_decided() ? (tie.a_won ? tie.a : tie.b) : std::nullopt;
}

}  // namespace

std::string json_of(const std::vector<Group>& groups) {
  std::vector<std::string> all;
  all.reserve(groups.size());
  for (const Group& group : groups) {
    all.push_back(JsonObject()
                      .add("values", texts_json(group.values))
                      .add("games", std::to_string(group.goals_a.size()))
                      .add("void_games", std::to_string(group.void_games))
                      .add("mean_a", mean_json(group.goals_a))
                      .add("mean_b", mean_json(group.goals_b))
                      .add("mean_diff", mean_json(group.differences))
                      .add("wins_a", std::to_string(group.wins_a))
                      .add("draws", std::to_string(group.draws))
                      .add("wins_b", std::to_string(group.wins_b))
                      .text());
  }
  return json_list(all);
}

std::string json_of(const std::vector<Standing>& standings) {
  std::vector<std::string> all;
  all.reserve(standings.size());
  for (const Standing& standing : standings) {
    all.push_back(JsonObject()
                      .add("team", json_text(standing.team))
                      .add("points", std::to_string(standing.points()))
                      .add("games", std::to_string(standing.games()))
                      .add("wins", std::to_string(standing.wins))
                      .add("draws", std::to_string(standing.draws))
                      .add("losses", std::to_string(standing.losses))
                      .add("goals_for", json_number(standing.goals_for))
                      .add("goals_against", json_number(standing.goals_against))
                      .text());
  }
  return json_list(all);
}

std::string json_of(const SprtMatchState& state) {
  return JsonObject()
      .add("verdict", json_text(name_of(state.test.verdict)))
      .add("test_pairs", std::to_string(state.test.pairs))
      .add("log_likelihood_ratio", json_number(state.test.log_likelihood_ratio))
      .text();
}

std::string json_of(const std::vector<Tie>& ties) {
  std::vector<std::string> all;
  all.reserve(ties.size());
  for (const Tie& tie : ties) {
    all.push_back(JsonObject()
                      .add("tie", json_text(tie.name))
                      .add("team_a", name_json(tie.a))
                      .add("team_b", name_json(tie.b))
                      .add("games", std::to_string(tie.games.size()))
                      .add("decided_by", json_text(name_of(tie.decided_by)))
                      .add("winner", name_json(winner_in(tie)))
                      .text());
  }
  return json_list(all);
}

}  // namespace autoref::runner
