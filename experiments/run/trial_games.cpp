#include "experiments/run/trial_games.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <queue>

#include "experiments/run/program_versions.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostWholeGames = 6;  // maximum number of whole games per combination
constexpr double kShareOfFirst = 0.5;       // fraction of the time for each game's first seconds
constexpr double kShareOfSecond = 0.9;      // fraction of the remaining time for longer parts
constexpr double kGrace_s = 2;              // extra time for running games to finish
constexpr std::size_t kMostPrograms = 5;    // maximum number of programs named with their costs
constexpr int kMostRounds = 3;              // maximum number of rounds with longer and longer parts
constexpr double kLeastLimit_s = 0.02;      // wall time that every part may take at least

// The id without pair and leg: "b.handicap=0.8" for "b.handicap=0.8-p0007-2".
std::string played_in(const ScheduledGame& game) {
  const std::string ending = game_id("", game.pair, game.leg);
  return game.id.substr(0, game.id.size() - ending.size());
}

// Shortens the halves to `share` of their length. Only whole games have extra time and shoot-outs.
game::GameSettings part_of(const game::GameSettings& game, double share) {
  game::GameSettings part = game;
  if (share >= 1) return part;
  part.match.half_s *= share;
  part.match.knockout = false;
  return part;
}

double whole_length_s(const game::GameSettings& game) {
  return game.scene ? game.scene->lasts_s : game.match.half_s * game.match.halves;
}

// A worker's answer, as text.
std::string answer_with(const PlayedPart& part) {
  return io::json_text(io::Json::array({part.share, part.start_s, part.team_s, part.void_reason}));
}

PlayedPart played_part_of(const std::string& text) {
  const io::Json json = io::Json::parse(text);
  return {json.at(0).get<double>(), json.at(1).get<double>(),
          json.at(2).get<std::array<double, 2>>(), json.at(3).get<std::string>()};
}

struct Entry {
  Trial trial;
  std::vector<const ScheduledGame*> games;  // the first kMostWholeGames
  // Times of parts that were not void, in order of playing.
  std::vector<PartTime> samples;

  // Scenes are short enough to be played whole.
  double first_share() const {
    const game::GameSettings game = games.front()->settings.combined();
    if (game.scene) return 1;
    return std::min(1.0, kTrialHalf_s / game.match.half_s);
  }
  bool plays() const { return !samples.empty() && trial.void_reason.empty(); }

  // Whether playing such a part adds information: whether it is longer than the parts already
  // played, or one of the first whole games after the first part.
  bool is_to_play(double share) const {
    if (!plays()) return false;
    return share > 2 * longest().share || (share >= 1 && samples.size() == 1);
  }

  const PartTime& longest() const {
    return *std::max_element(
        samples.begin(), samples.end(),
        [](const PartTime& one, const PartTime& other) { return one.share < other.share; });
  }

  // The time to restart programs and to replay the first seconds.
  double repetition_s(double game_s) const {
    const game::GameSettings game = games.front()->settings.combined();
    if (game.a.program.command.empty() && game.b.program.command.empty()) return 0;
    const double start_s = longest().start_s;
    return start_s + (game_s - start_s) * std::min(1.0, kRepeated_s / whole_length_s(game));
  }

  void estimate() {
    const double game_s = estimated_game_s(samples);
    trial.wall_s_a_game = game_s + repetition_s(game_s);
    trial.share = std::min(1.0, longest().share);
    const ScheduledGame& game = *games.front();
    trial.teams = {TrialTeam{game.team_a, !game.settings.a().program.command.empty(), team_s(0)},
                   TrialTeam{game.team_b, !game.settings.b().program.command.empty(), team_s(1)}};
  }

  // A team's share of the estimate.
  double team_s(std::size_t team) const {
    const PartTime& part = longest();
    return trial.wall_s_a_game * std::min(1.0, part.team_s[team] / part.wall_s);
  }
};

std::vector<Entry> entries_of(const std::vector<ScheduledGame>& games) {
  std::vector<Entry> entries;
  std::map<std::string, std::size_t> numbers;
  for (const ScheduledGame& game : games) {
    const auto [number, is_new] = numbers.try_emplace(played_in(game), entries.size());
    if (is_new) {
      entries.emplace_back();
      entries.back().trial.played = number->first;
      entries.back().trial.variant = game.variant;
    }
    Entry& entry = entries[number->second];
    ++entry.trial.games;
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

class TrialRun {
 public:
  TrialRun(const std::vector<ScheduledGame>& games, const TrialOptions& options)
      : options_(options), entries_(entries_of(games)) {}

  std::vector<Trial> run() {
    play(first_parts(), kShareOfFirst * options_.longest_s, Limit::kEqualShare);
    for (int round = 0; round < kMostRounds; ++round) {
      play(longer_parts(), options_.longest_s, Limit::kTimeLeft);
    }
    return estimates();
  }

 private:
  // How long a part may take: an equal share of the available time, or all the time that is left.
  enum class Limit { kEqualShare, kTimeLeft };

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
    for (const Entry& entry : entries_)
      whole_s += entry.plays() ? estimated_game_s(entry.samples) : 0;
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
        if (entry.is_to_play(share) && k < entry.games.size())
          parts.push_back({i, entry.games[k], share});
      }
    }
    return parts;
  }

  std::string played(const Part& part, double most_wall_s) const {
    try {
      return answer_with(
          options_.play(game::resolved(part_of(part.game->settings.combined(), part.share)),
                        std::max(kLeastLimit_s, most_wall_s)));
    } catch (const std::exception& error) {
      if (io::environment_failure(error)) throw;
      return answer_with({.void_reason = error.what()});
    }
  }

  // `others` is the number of parts that have not begun yet.
  double limit_s(Limit limit, double until_s, std::size_t others) const {
    const double left_s = until_s - elapsed_s();
    if (limit == Limit::kTimeLeft) return left_s;
    return std::min(left_s, left_s * options_.workers / static_cast<double>(others + 1));
  }

  void play(const std::vector<Part>& parts, double until_s, Limit limit) {
    std::vector<std::size_t> jobs(parts.size());
    std::iota(jobs.begin(), jobs.end(), std::size_t{0});
    const io::WorkerOptions workers{
        options_.workers, 1, std::max(kGrace_s, options_.longest_s + kGrace_s - elapsed_s())};
    const io::Ending ending = io::do_jobs(
        jobs, workers,
        {[&](const io::Job& job) {
           return played(parts[job.number], limit_s(limit, until_s, parts.size() - job.number - 1));
         },
         [&](const io::JobResult& result) { note(parts[result.job], result); },
         {},
         [&] { return elapsed_s() > options_.longest_s; }});
    if (ending == io::Ending::kInterrupted) throw io::Interrupted();
  }

  void note(const Part& part, const io::JobResult& result) {
    Entry& entry = entries_[part.entry];
    if (!result.payload.empty()) {
      const PlayedPart played = played_part_of(result.payload);
      if (played.void_reason.empty()) {
        entry.samples.push_back(
            {part.share * played.share, result.wall_s, played.start_s, played.team_s});
      } else if (entry.trial.void_reason.empty()) {
        entry.trial.void_reason = played.void_reason;
      }
    } else if (entry.samples.empty() || !result.is_late) {
      entry.trial.void_reason = result.failure;
    }  // otherwise, a longer part ran out of time
  }

  std::vector<Trial> estimates() {
    double sum_s = 0;
    int tried = 0;
    for (Entry& entry : entries_) {
      if (!entry.plays()) continue;
      entry.estimate();
      sum_s += entry.trial.wall_s_a_game;
      ++tried;
    }
    std::vector<Trial> trials;
    for (const Entry& entry : entries_) {
      trials.push_back(entry.trial);
      Trial& trial = trials.back();
      trial.was_tried = !entry.samples.empty() || !trial.void_reason.empty();
      if (!trial.was_tried && tried > 0) trial.wall_s_a_game = sum_s / tried;
    }
    return trials;
  }

  const TrialOptions& options_;
  std::vector<Entry> entries_;
  const Clock::time_point began_ = Clock::now();
};

using CostShares = std::vector<std::pair<double, std::string>>;  // costs by name, the largest first

void merge_least(CostShares& shares) {
  double others = 0;
  for (std::size_t i = kMostPrograms; i < shares.size(); ++i) others += shares[i].first;
  const std::string name = fmt::format("{} others", shares.size() - kMostPrograms);
  shares.resize(kMostPrograms);
  shares.emplace_back(others, name);
}

// `all_s` is the sum of the times of all workers, like the programs' times. `duration_s` is the
// time for which the user waits.
std::string text_of_costs(const std::map<std::string, double>& programs_s, double all_s,
                          double duration_s) {
  CostShares shares;
  double of_all = 0;
  for (const auto& [name, wall_s] : programs_s) {
    shares.emplace_back(wall_s / all_s, name);
    of_all += wall_s / all_s;
  }
  std::sort(shares.begin(), shares.end(), std::greater<>());
  if (shares.size() > kMostPrograms) merge_least(shares);
  std::vector<std::string> costs;
  costs.reserve(shares.size());
  for (const auto& [share, name] : shares) {
    costs.push_back(
        fmt::format("{} {} ({:.0f} %)", name, io::duration_text(share * duration_s), 100 * share));
  }
  return fmt::format("of that, the teams' programs take: {}; everything else takes about {}",
                     fmt::join(costs, ", "), io::duration_text((1 - of_all) * duration_s));
}

}  // namespace

// Extrapolates linearly through the first part and the mean of the longest ones.
double estimated_game_s(const std::vector<PartTime>& parts) {
  const PartTime& first = parts.front();
  double longest = 0;
  for (const PartTime& part : parts) longest = std::max(longest, part.share);
  PartTime longer;
  double count = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].share < longest / 2) continue;
    longer.share += parts[i].share;
    longer.wall_s += parts[i].wall_s;
    ++count;
  }
  if (count == 0) return first.start_s + (first.wall_s - first.start_s) / first.share;
  longer.share /= count;
  longer.wall_s /= count;
  if (longer.share >= 1 || longer.share <= first.share) return longer.wall_s / longer.share;
  const double slope = std::max(0.0, (longer.wall_s - first.wall_s) / (longer.share - first.share));
  return longer.wall_s + slope * (1 - longer.share);
}

std::vector<Trial> play_trials(const std::vector<ScheduledGame>& games,
                               const TrialOptions& options) {
  return TrialRun(games, options).run();
}

// List scheduling: each game goes to the worker that becomes free first.
double duration_s(const std::vector<Trial>& trials, int workers) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free_s;
  for (int i = 0; i < workers; ++i) free_s.push(0);
  double end_s = 0;
  for (const Trial& trial : trials) {
    for (int game = 0; game < trial.games; ++game) {
      const double done_s = free_s.top() + trial.wall_s_a_game;
      free_s.pop();
      free_s.push(done_s);
      end_s = std::max(end_s, done_s);
    }
  }
  return end_s;
}

std::string cost_of_programs(const std::vector<Trial>& trials, int workers) {
  double all_s = 0;
  std::map<std::string, double> programs_s;
  for (const Trial& trial : trials) {
    all_s += trial.games * trial.wall_s_a_game;
    for (const TrialTeam& team : trial.teams) {
      if (team.is_program) programs_s[team.name] += trial.games * team.wall_s_a_game;
    }
  }
  if (programs_s.empty() || all_s <= 0) return "";
  return text_of_costs(programs_s, all_s, duration_s(trials, workers));
}

}  // namespace autoref::experiments
