#include "runner/batch/rehearsal.hpp"

#include <algorithm>
#include <chrono>
#include <map>

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

// The id without pair and leg: "b.handicap=0.8" of "b.handicap=0.8-p0007-2".
std::string played_in(const ScheduledGame& game) {
  const std::string ending = game_id("", game.pair, game.leg);
  return game.id.substr(0, game.id.size() - ending.size());
}

double regular_s(const MatchConfiguration& match) { return match.half_s * match.halves; }

Rehearsal rehearsed(const ScheduledGame& game,
                    const std::function<GameRecord(const GameConfiguration&)>& play) {
  GameConfiguration shortened = game.configuration;
  shortened.match.half_s = std::min(shortened.match.half_s, kRehearsedHalf_s);
  Rehearsal rehearsal{played_in(game), 0, {}, 0};
  const auto start = Clock::now();
  try {
    const GameRecord record = play(shortened);
    const double wall_s = std::chrono::duration<double>(Clock::now() - start).count();
    rehearsal.void_reason = record.void_reason;
    if (record.sim_s > 0)
      rehearsal.wall_s_a_game = wall_s / record.sim_s * regular_s(game.configuration.match);
  } catch (const std::exception& error) {
    rehearsal.void_reason = error.what();
  }
  return rehearsal;
}

}  // namespace

std::vector<Rehearsal> rehearse(const std::vector<ScheduledGame>& games,
                                const std::function<GameRecord(const GameConfiguration&)>& play) {
  std::vector<Rehearsal> rehearsals;
  std::map<std::string, std::size_t> entries;
  for (const ScheduledGame& game : games) {
    const auto [entry, is_new] = entries.try_emplace(played_in(game), rehearsals.size());
    if (is_new) rehearsals.push_back(rehearsed(game, play));
    ++rehearsals[entry->second].games;
  }
  return rehearsals;
}

double duration_s(const std::vector<Rehearsal>& rehearsals, int workers) {
  double all_s = 0;
  for (const Rehearsal& rehearsal : rehearsals) all_s += rehearsal.games * rehearsal.wall_s_a_game;
  return all_s / workers;
}

}  // namespace autoref::runner
