#include "experiments/schedule/matchup_schedule.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

bool is_letter_of_names(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

}  // namespace

std::string matchup_name(const Matchup& matchup) { return matchup.team_a + "~" + matchup.team_b; }

void check_team_name(std::string_view name) {
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), is_letter_of_names);
  if (is_word && name.find("-p") == std::string_view::npos) return;
  throw std::invalid_argument(
      fmt::format("a team's name must consist of letters, digits, - and _, without '-p', which "
                  "marks the pair in a game's id (write _p); found '{}'",
                  name));
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

}  // namespace autoref::experiments
