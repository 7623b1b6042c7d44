#include "experiments/kinds/tune/tuning_schedule.hpp"

#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "experiments/schedule/sequential_settings.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// Seed streams derived from the master seed; the search uses another one (tuning.cpp).
constexpr std::uint64_t kIterationStream = 2;
constexpr std::uint64_t kTestStream = 3;

std::uint64_t seed_in(const Tuning& tuning, std::uint64_t stream, int iteration,
                      std::size_t opponent) {
  const std::uint64_t of_stream = mix_bits(mix_bits(tuning.seed) + stream);
  return mix_bits(mix_bits(of_stream + static_cast<std::uint64_t>(iteration)) + opponent);
}

ScheduledGame scheduled(const TuningMatchup& matchup, const SharedSettings& settings, int pair,
                        int leg) {
  return {game_id(matchup.played, pair, leg),
          spelt(matchup.a_values),
          pair,
          leg,
          settings.with(leg_of(matchup.seed, pair, leg)),
          matchup.names.team_a,
          matchup.names.team_b};
}

std::vector<TuningMatchup> matchups_between(const Tuning& tuning, const std::string& name,
                                            const std::vector<Candidate>& candidates,
                                            const Candidate& other, std::uint64_t seed) {
  std::vector<TuningMatchup> matchups;
  matchups.reserve(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Matchup names = {candidates[i].name, other.name};
    matchups.push_back({names, fmt::format("{}-{}", name, matchup_name(names)),
                        values_at(tuning, candidates[i].point),
                        team_with(tuning, values_at(tuning, other.point)), i, "", seed});
  }
  return matchups;
}

void refuse_too_many_games(const Tuning& tuning) {
  refuse_too_many(static_cast<double>(games_of_search(tuning)) +
                      static_cast<double>(games_of_test_pair(tuning)) * tuning.test.max_pairs,
                  "iterations");
}

}  // namespace

std::vector<TuningMatchup> matchups_of(const Tuning& tuning, int number,
                                       const std::vector<Candidate>& candidates,
                                       const Point& centre) {
  const std::string name = fmt::format("k{:04}", number);
  if (tuning.is_against_itself()) {
    const std::uint64_t seed = seed_in(tuning, kIterationStream, number, 0);
    if (tuning.method == kSpsaName) {
      return matchups_between(tuning, name, {candidates[0]}, candidates[1], seed);
    }
    return matchups_between(tuning, name, candidates, {"centre", centre}, seed);
  }
  std::vector<TuningMatchup> matchups;
  std::size_t opponents = 0;
  for (const auto& [opponent, team] : tuning.opponents) {
    const std::uint64_t seed = seed_in(tuning, kIterationStream, number, opponents++);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Matchup names = {candidates[i].name, opponent};
      matchups.push_back({names, fmt::format("{}-{}", name, matchup_name(names)),
                          values_at(tuning, candidates[i].point), team, i, opponent, seed});
    }
  }
  return matchups;
}

std::vector<TuningMatchup> test_matchups_of(const Tuning& tuning, const ParamValues& result) {
  const auto matchup = [](const Matchup& names, const ParamValues& a, const game::TeamSettings& b,
                          std::size_t candidate, const std::string& opponent, std::uint64_t seed) {
    return TuningMatchup{names, "test-" + matchup_name(names), a, b, candidate, opponent, seed};
  };
  const ParamValues start = start_values(tuning);
  if (tuning.is_against_itself()) {
    return {matchup({"result", "start"}, result, team_with(tuning, start), 0, "",
                    seed_in(tuning, kTestStream, 0, 0))};
  }
  std::vector<TuningMatchup> matchups;
  std::size_t opponents = 0;
  for (const auto& [opponent, team] : tuning.opponents) {
    const std::uint64_t seed = seed_in(tuning, kTestStream, 0, opponents++);
    matchups.push_back(matchup({"result", opponent}, result, team, 0, opponent, seed));
    matchups.push_back(matchup({"start", opponent}, start, team, 1, opponent, seed));
  }
  return matchups;
}

std::vector<ScheduledGame> games_of(const Tuning& tuning,
                                    const std::vector<TuningMatchup>& matchups, int pairs) {
  const SharedSettings base(tuning.base);
  std::vector<SharedSettings> settings;
  settings.reserve(matchups.size());
  for (const TuningMatchup& matchup : matchups) {
    settings.push_back(base.between(
        std::make_shared<const game::TeamSettings>(team_with(tuning, matchup.a_values)),
        std::make_shared<const game::TeamSettings>(matchup.b)));
  }
  std::vector<ScheduledGame> games;
  games.reserve(2 * matchups.size() * static_cast<std::size_t>(pairs));
  for (int pair = 1; pair <= pairs; ++pair) {
    for (std::size_t i = 0; i < matchups.size(); ++i) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(matchups[i], settings[i], pair, leg));
        games.back().unit = (games.size() - 1) / 2;
      }
    }
  }
  return games;
}

void append(std::vector<ScheduledGame>& games, std::vector<ScheduledGame> more) {
  const std::size_t units = games.empty() ? 0 : games.back().unit + 1;
  for (ScheduledGame& game : more) game.unit += units;
  games.insert(games.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

int games_of_search(const Tuning& tuning) {
  const auto optimiser = optimiser_of(tuning);
  const std::size_t matchups = matchups_of(tuning, 1, optimiser->ask(), optimiser->centre()).size();
  const double games = 2.0 * tuning.iterations * tuning.pairs * static_cast<double>(matchups);
  refuse_too_many(games, "iterations");
  return static_cast<int>(games);
}

int games_of_test_pair(const Tuning& tuning) {
  return tuning.is_against_itself() ? 2 : 4 * static_cast<int>(tuning.opponents.size());
}

std::vector<ScheduledGame> games_if_drawn(const Tuning& tuning) {
  check(tuning);
  check_test(tuning.test, kTestKey);
  refuse_too_many_games(tuning);
  std::vector<ScheduledGame> games;
  const auto optimiser = optimiser_of(tuning);
  for (int number = 1; number <= tuning.iterations; ++number) {
    const std::vector<Candidate> candidates = optimiser->ask();
    append(games, games_of(tuning, matchups_of(tuning, number, candidates, optimiser->centre()),
                           tuning.pairs));
    optimiser->tell(std::vector<Score>(candidates.size(), 0));
  }
  append(games,
         games_of(tuning, test_matchups_of(tuning, start_values(tuning)), tuning.test.max_pairs));
  return games;
}

}  // namespace autoref::experiments
