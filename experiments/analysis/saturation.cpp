#include "experiments/analysis/saturation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "strategies/registry.hpp"

namespace autoref::experiments {
namespace {

constexpr int kFewestGames = 10;

struct OneSidedGames {
  int games = 0;
  int ended_by_lead = 0;
  int won = 0;  // by the teams that play the opponent
  int lost = 0;

  bool is_saturated() const {
    return games >= kFewestGames && (2 * ended_by_lead >= games || won == games || lost == games);
  }
};

OneSidedGames counted(const std::vector<const Group*>& groups) {
  OneSidedGames all;
  for (const Group* group : groups) {
    all.games += group->games();
    all.ended_by_lead += group->ended_by_lead;
    all.won += group->wins_a;
    all.lost += group->wins_b;
  }
  return all;
}

// The next team in the order of strength, if the opponent is one of the registered teams.
std::string next_team_text(std::string_view strategy, bool is_stronger) {
  const std::vector<std::string_view>& teams = strategies::teams_by_strength();
  const auto team = std::find(teams.begin(), teams.end(), strategy);
  if (team == teams.end()) return {};
  if (is_stronger) return team == teams.begin() ? "" : fmt::format(", such as {}", *(team - 1));
  return team + 1 == teams.end() ? "" : fmt::format(", such as {}", *(team + 1));
}

}  // namespace

std::string saturation_text(const std::string& opponent, const game::TeamSettings& its,
                            const std::vector<const Group*>& games) {
  const OneSidedGames counts = counted(games);
  if (!counts.is_saturated()) return {};
  const std::string what =
      2 * counts.ended_by_lead >= counts.games
          ? fmt::format("{} of {} games ended early by the lead in goals", counts.ended_by_lead,
                        counts.games)
          : fmt::format("{} all {} games", counts.won > 0 ? "it lost" : "it won", counts.games);
  const bool is_stronger = counts.won > counts.lost;
  const std::string next =
      its.program.command.empty() ? next_team_text(its.strategy, is_stronger) : std::string();
  return fmt::format(
      "{} hardly tells the teams apart: {}. To see differences, play against a {} team{}, or the "
      "teams against each other (autoref compare).",
      opponent, what, is_stronger ? "stronger" : "weaker", next);
}

}  // namespace autoref::experiments
