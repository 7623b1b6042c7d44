#include "experiments/analysis/saturation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "strategies/registry.hpp"

namespace autoref::experiments {
namespace {

constexpr int kFewestGames = 10;

// The games of a group from the point of view of one side.
struct SideOfGroup {
  int games = 0;
  int won = 0;
  int won_by_lead = 0;  // number of games that the side's lead in goals ended early

  bool is_ended_by_lead() const { return 2 * won_by_lead >= games; }
  bool is_one_sided() const {
    return games >= kFewestGames && (is_ended_by_lead() || won == games);
  }
};

std::vector<SideOfGroup> sides_of(const std::vector<const Group*>& groups, bool is_of_opponent) {
  std::vector<SideOfGroup> sides;
  for (const Group* group : groups) {
    if (is_of_opponent) {
      sides.push_back({group->games(), group->wins_b, group->lead_ends_b});
    } else {
      sides.push_back({group->games(), group->wins_a, group->lead_ends_a});
    }
  }
  return sides;
}

bool are_one_sided(const std::vector<SideOfGroup>& sides) {
  return !sides.empty() && std::all_of(sides.begin(), sides.end(),
                                       [](const SideOfGroup& side) { return side.is_one_sided(); });
}

// ", such as zone": the next team in the order of strength, if the opponent is a registered team.
std::string next_team_text(const game::TeamSettings& opponent, bool is_stronger) {
  if (!opponent.program.command.empty()) return {};
  const std::vector<std::string_view>& teams = strategies::teams_by_strength();
  const auto team = std::find(teams.begin(), teams.end(), opponent.strategy);
  if (team == teams.end()) return {};
  if (is_stronger) return team == teams.begin() ? "" : fmt::format(", such as {}", *(team - 1));
  return team + 1 == teams.end() ? "" : fmt::format(", such as {}", *(team + 1));
}

// "31 of 40 games ended early because of the lead in goals" or "it won all 40 games".
std::string one_sided_text(const std::vector<SideOfGroup>& sides, bool has_opponent_won) {
  SideOfGroup all;
  bool is_by_lead = true;
  for (const SideOfGroup& side : sides) {
    all.games += side.games;
    all.won += side.won;
    all.won_by_lead += side.won_by_lead;
    is_by_lead = is_by_lead && side.is_ended_by_lead();
  }
  if (is_by_lead) {
    return fmt::format("{} of {} games ended early because of the lead in goals", all.won_by_lead,
                       all.games);
  }
  return fmt::format("it {} {} {} games", has_opponent_won ? "won" : "lost",
                     all.won == all.games ? "all" : fmt::format("{} of", all.won), all.games);
}

}  // namespace

std::string saturation_text(const std::string& opponent, const game::TeamSettings& team,
                            const std::vector<const Group*>& groups, std::string_view otherwise) {
  for (const bool has_opponent_won : {false, true}) {
    const std::vector<SideOfGroup> sides = sides_of(groups, has_opponent_won);
    if (!are_one_sided(sides)) continue;
    return fmt::format(
        "{} is too {} for a comparison of these teams: {}. Play against a {} team{}, {}.", opponent,
        has_opponent_won ? "strong" : "weak", one_sided_text(sides, has_opponent_won),
        has_opponent_won ? "weaker" : "stronger", next_team_text(team, !has_opponent_won),
        otherwise);
  }
  return {};
}

}  // namespace autoref::experiments
