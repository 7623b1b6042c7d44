#include "runner/experiments/knockout_schedule.hpp"

#include "runner/experiments/matchup_schedule.hpp"

namespace autoref::runner {

std::vector<ScheduledGame> scheduled_games(const Knockout& knockout) {
  check(knockout.base, knockout.teams);
  const std::vector<Tie> ties = bracket_of(knockout, [](Tie& tie) {
    tie.games = {game_id(matchup_name({*tie.a, *tie.b}), tie.number, 1)};
    tie.decided_by = DecidedBy::kGoals;
    tie.a_won = true;
  });
  return games_of(knockout, ties);
}

std::vector<ScheduledGame> games_of(const Knockout& knockout, const std::vector<Tie>& ties) {
  const MatchupScheduler scheduler(knockout);
  std::vector<ScheduledGame> games;
  for (const Tie& tie : ties) {
    if (!tie.is_known()) continue;
    const auto played = static_cast<int>(tie.games.size());
    const int attempts = tie.is_decided() ? played : played + 1;
    for (int attempt = 1; attempt <= attempts; ++attempt) {
      games.push_back(scheduler.game({*tie.a, *tie.b}, tie.number, attempt));
      games.back().unit = static_cast<std::size_t>(tie.number - 1);
    }
  }
  return games;
}

}  // namespace autoref::runner
