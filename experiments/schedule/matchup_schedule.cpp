#include "experiments/schedule/matchup_schedule.hpp"

#include <fmt/format.h>
#include <iterator>

#include "game/settings/fields.hpp"

namespace autoref::experiments {
std::string matchup_name(const Matchup& matchup) { return matchup.team_a + "~" + matchup.team_b; }

std::vector<Matchup> matchups_among(const Teams& teams) {
  std::vector<Matchup> matchups;
  for (auto a = teams.begin(); a != teams.end(); ++a) {
    for (auto b = std::next(a); b != teams.end(); ++b) matchups.push_back({a->first, b->first});
  }
  return matchups;
}

void check(const game::GameSettings& base, const Teams& teams, std::string_view branch) {
  game::check_game(base);
  for (const auto& [name, team] : teams) {
    const std::string path = fmt::format("{}.{}", branch, name);
    refuse_network(team, path);
    game::check_team(base, team, path);
  }
  refuse_game_controller(base);
}

MatchupScheduler::MatchupScheduler(const NamedTeams& named) : base_(named.base), seed_(named.seed) {
  for (const auto& [name, team] : named.teams) {
    teams_[name] = std::make_shared<const game::TeamSettings>(team);
  }
}

ScheduledGame MatchupScheduler::game(const Matchup& matchup, int pair, int leg) const {
  const SharedSettings settings =
      base_.between(teams_.at(matchup.team_a), teams_.at(matchup.team_b));
  return {game_id(matchup_name(matchup), pair, leg),
          {},
          pair,
          leg,
          settings.with(leg_of(seed_, pair, leg)),
          matchup.team_a,
          matchup.team_b};
}

std::vector<ScheduledGame> games_of(const NamedTeams& named, const std::vector<Matchup>& matchups,
                                    const std::vector<std::size_t>& order, int pairs) {
  refuse_too_many(2.0 * pairs * static_cast<double>(matchups.size()));
  const MatchupScheduler scheduler(named);
  return games_in_turns(order, pairs, [&](std::size_t i, int pair, int leg) {
    return scheduler.game(matchups[i], pair, leg);
  });
}

}  // namespace autoref::experiments
