#include "runner/experiments/matchup_schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/playing_order.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

std::vector<ScheduledGame> scheduled(const NamedTeams& named, const std::vector<Matchup>& matchups,
                                     const std::vector<std::size_t>& order, int pairs) {
  refuse_too_many(2.0 * pairs * static_cast<double>(matchups.size()));
  const MatchupScheduler scheduler(named);
  std::vector<ScheduledGame> games;
  games.reserve(2 * static_cast<std::size_t>(pairs) * matchups.size());
  for (int pair = 1; pair <= pairs; ++pair) {
    for (const std::size_t i : order) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduler.game(matchups[i], pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = i;
        games.back().variants = matchups.size();
      }
    }
  }
  return games;
}

}  // namespace

void check(const GameSettings& base, const Teams& teams, std::string_view branch) {
  check_game(base);
  for (const auto& [name, team] : teams) {
    const std::string path = fmt::format("{}.{}", branch, name);
    refuse_network(team, path);
    check_team(base, team, path);
  }
  refuse_game_controller(base);
}

MatchupScheduler::MatchupScheduler(const NamedTeams& named) : base_(named.base), seed_(named.seed) {
  for (const auto& [name, team] : named.teams) {
    teams_[name] = std::make_shared<const TeamSettings>(team);
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

std::vector<ScheduledGame> scheduled_games(const RoundRobin& robin) {
  const auto teams = static_cast<double>(robin.teams.size());
  refuse_too_many(robin.pairs * teams * (teams - 1));
  check(robin.base, robin.teams);
  return scheduled(robin, matchups_of(robin), round_robin_order(robin.teams.size()), robin.pairs);
}

std::vector<ScheduledGame> scheduled_games(const SprtMatch& match) {
  check(match.base, match.teams);
  return scheduled(match, {matchup_of(match)}, {0}, match.sprt.max_pairs);
}

std::vector<ScheduledGame> scheduled_games(const Gauntlet& gauntlet) {
  refuse_too_many(2.0 * gauntlet.pairs * static_cast<double>(gauntlet.teams.size()) *
                  static_cast<double>(gauntlet.challengers.size()));
  check(gauntlet.base, gauntlet.teams);
  check(gauntlet.base, gauntlet.challengers, "challengers");
  return scheduled(everyone_in(gauntlet), matchups_of(gauntlet),
                   combinations_order({gauntlet.challengers.size(), gauntlet.teams.size()}),
                   gauntlet.pairs);
}

}  // namespace autoref::runner
