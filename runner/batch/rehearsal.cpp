#include "runner/batch/rehearsal.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>

#include "runner/io/errors.hpp"
#include "runner/processes/workers.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWholeGames = 6;  // per combination
constexpr double kShareOfFirst = 0.5;   // fraction of the time spent on the first seconds of each
constexpr double kShareOfSecond = 0.9;  // fraction of the remaining time spent on longer parts
constexpr double kGrace_s = 2;          // for running games to end
constexpr const char* kWell = "well";

// The id without pair and leg: "b.handicap=0.8" for "b.handicap=0.8-p0007-2".
std::string played_in(const ScheduledGame& game) {
  const std::string ending = game_id("", game.pair, game.leg);
  return game.id.substr(0, game.id.size() - ending.size());
}

// Shortens the halves to `share` of their length. Only whole games have extra time and shoot-outs.
GameSettings part_of(const GameSettings& game, double share) {
  GameSettings part = game;
  if (share >= 1) return part;
  part.match.half_s *= share;
  part.match.knockout = false;
  return part;
}

struct Entry {
  Rehearsal rehearsal;
  std::vector<const ScheduledGame*> games;  // the first kMostWholeGames
  std::vector<RehearsedPart> samples;       // of parts that were not void, the shortest first

  // Scenes are short enough to be played whole.
  double first_share() const {
    const GameSettings game = games.front()->settings.whole();
    if (game.scene) return 1;
    return std::min(1.0, kRehearsedHalf_s / game.match.half_s);
  }
  bool plays() const { return !samples.empty() && rehearsal.void_reason.empty(); }
  double first_estimate_s() const { return samples.front().wall_s / samples.front().share; }
};

std::vector<Entry> entries_of(const std::vector<ScheduledGame>& games) {
  std::vector<Entry> entries;
  std::map<std::string, std::size_t> numbers;
  for (const ScheduledGame& game : games) {
    const auto [number, is_new] = numbers.try_emplace(played_in(game), entries.size());
    if (is_new) {
      entries.emplace_back();
      entries.back().rehearsal.played = number->first;
    }
    Entry& entry = entries[number->second];
    ++entry.rehearsal.games;
    if (entry.games.size() < kMostWholeGames) entry.games.push_back(&game);
  }
  return entries;
}

// A part of an entry's game.
struct Part {
  std::size_t entry = 0;
  const ScheduledGame* game = nullptr;
  double share = 1;
};

class Rehearsals {
 public:
  Rehearsals(const std::vector<ScheduledGame>& games, const RehearsalOptions& options)
      : options_(options), entries_(entries_of(games)) {}

  std::vector<Rehearsal> run() {
    play(first_parts(), kShareOfFirst * options_.longest_s);
    play(longer_parts(), options_.longest_s);
    return estimates();
  }

 private:
  double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  std::vector<Part> first_parts() const {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      parts.push_back({i, entries_[i].games.front(), entries_[i].first_share()});
    }
    return parts;
  }

  // Plays whole games, several of each if there is time; otherwise one game of each, all shortened
  // to the same fraction.
  std::vector<Part> longer_parts() const {
    double whole_s = 0;
    for (const Entry& entry : entries_) whole_s += entry.plays() ? entry.first_estimate_s() : 0;
    if (whole_s <= 0) return {};
    const double room_s =
        kShareOfSecond * std::max(0.0, options_.longest_s - elapsed_s()) * options_.workers;
    const double share = std::min(1.0, room_s / whole_s);
    const auto times = static_cast<std::size_t>(
        std::clamp(std::floor(room_s / whole_s), 1.0, static_cast<double>(kMostWholeGames)));
    std::vector<Part> parts;
    for (std::size_t k = 0; k < times; ++k) {
      for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        const bool is_longer = share > 2 * entry.first_share() || share >= 1;
        if (entry.plays() && is_longer && k < entry.games.size())
          parts.push_back({i, entry.games[k], share});
      }
    }
    return parts;
  }

  std::string played(const Part& part) const {
    try {
      const GameRecord record =
          options_.play(resolved(part_of(part.game->settings.whole(), part.share)));
      return record.void_reason.empty() ? kWell : "void: " + record.void_reason;
    } catch (const std::exception& error) {
      if (environment_failure(error)) throw;
      return std::string("void: ") + error.what();
    }
  }

  void play(const std::vector<Part>& parts, double until_s) {
    std::vector<std::size_t> jobs(parts.size());
    std::iota(jobs.begin(), jobs.end(), std::size_t{0});
    const WorkerOptions workers{options_.workers, 1,
                                std::max(kGrace_s, options_.longest_s + kGrace_s - elapsed_s())};
    const Ending ending =
        do_jobs(jobs, workers,
                {[&](std::size_t i) { return played(parts[i]); },
                 [&](const JobResult& result) { note(parts[result.job], result); },
                 {},
                 [&] { return elapsed_s() > until_s; }});
    if (ending == Ending::kInterrupted) throw Interrupted();
  }

  void note(const Part& part, const JobResult& result) {
    Entry& entry = entries_[part.entry];
    if (result.payload == kWell) {
      entry.samples.push_back({part.share, result.wall_s});
    } else if (!result.payload.empty()) {
      entry.rehearsal.void_reason = result.payload.substr(std::string("void: ").size());
    } else if (entry.samples.empty() || !result.is_late) {
      entry.rehearsal.void_reason = result.failure;
    }  // otherwise, a longer part ran out of time
  }

  std::vector<Rehearsal> estimates() const {
    double sum_s = 0;
    int tried = 0;
    for (const Entry& entry : entries_) {
      if (!entry.plays()) continue;
      sum_s += whole_game_s(entry.samples);
      ++tried;
    }
    std::vector<Rehearsal> rehearsals;
    for (const Entry& entry : entries_) {
      rehearsals.push_back(entry.rehearsal);
      Rehearsal& rehearsal = rehearsals.back();
      rehearsal.was_tried = !entry.samples.empty() || !rehearsal.void_reason.empty();
      if (entry.plays()) rehearsal.wall_s_a_game = whole_game_s(entry.samples);
      if (!rehearsal.was_tried && tried > 0) rehearsal.wall_s_a_game = sum_s / tried;
    }
    return rehearsals;
  }

  const RehearsalOptions& options_;
  std::vector<Entry> entries_;
  const Clock::time_point began_ = Clock::now();
};

}  // namespace

// Extrapolates linearly, through the first part and the mean of the others.
double whole_game_s(const std::vector<RehearsedPart>& parts) {
  const RehearsedPart& first = parts.front();
  if (parts.size() == 1) return first.wall_s / first.share;
  RehearsedPart longer;
  const auto count = static_cast<double>(parts.size() - 1);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    longer.share += parts[i].share / count;
    longer.wall_s += parts[i].wall_s / count;
  }
  if (longer.share >= 1 || longer.share <= first.share) return longer.wall_s / longer.share;
  const double slope = std::max(0.0, (longer.wall_s - first.wall_s) / (longer.share - first.share));
  return longer.wall_s + slope * (1 - longer.share);
}

std::vector<Rehearsal> rehearse(const std::vector<ScheduledGame>& games,
                                const RehearsalOptions& options) {
  return Rehearsals(games, options).run();
}

// List scheduling: each game goes to the worker that becomes free first.
double duration_s(const std::vector<Rehearsal>& rehearsals, int workers) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free_s;
  for (int i = 0; i < workers; ++i) free_s.push(0);
  double end_s = 0;
  for (const Rehearsal& rehearsal : rehearsals) {
    for (int game = 0; game < rehearsal.games; ++game) {
      const double done_s = free_s.top() + rehearsal.wall_s_a_game;
      free_s.pop();
      free_s.push(done_s);
      end_s = std::max(end_s, done_s);
    }
  }
  return end_s;
}

}  // namespace autoref::runner
