#include "experiments/kinds/judge/judge_schedule.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "io/words.hpp"
#include "soccer/random.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::experiments {
namespace {

using Indices = std::vector<std::size_t>;

// Fisher-Yates shuffle; std::shuffle differs between standard libraries.
template <typename Values>
void shuffle(Values& values, RandomStream& random) {
  for (std::size_t left = values.size(); left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(values[left - 1], values[chosen]);
  }
}

Indices shuffled(std::size_t count, RandomStream& random) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  shuffle(indices, random);
  return indices;
}

class Deal {
 public:
  Deal(const std::vector<std::string>& teams, std::uint64_t seed) : teams_(teams), random_(seed) {
    const std::size_t n = teams.size();
    swaps_.reserve(n * n);
    for (std::size_t i = 0; i < n * n; ++i) swaps_.push_back(random_.uniform() < 0.5);
  }

  // Appends every pair once.
  void add_cycle(std::vector<std::array<std::string, 2>>& dealt) {
    const std::size_t n = teams_.size();
    const Indices labels = shuffled(n, random_);
    for (const std::size_t round : shuffled(n, random_)) {
      for (const auto& [i, j] : pairs_of_round(round)) add(labels[i], labels[j], dealt);
    }
    is_odd_cycle_ = !is_odd_cycle_;
  }

 private:
  // All i <= j with i + j = round (mod n): every team plays one opponent or itself, and over all n
  // rounds each pair occurs once.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_of_round(std::size_t round) {
    const std::size_t n = teams_.size();
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    pairs.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (round + n - i) % n;
      if (i <= j) pairs.emplace_back(i, j);
    }
    shuffle(pairs, random_);
    return pairs;
  }

  void add(std::size_t i, std::size_t j, std::vector<std::array<std::string, 2>>& dealt) const {
    const auto [low, high] = std::minmax(i, j);
    const bool is_swapped = swaps_[low * teams_.size() + high] != is_odd_cycle_;
    dealt.push_back({teams_[is_swapped ? high : low], teams_[is_swapped ? low : high]});
  }

  const std::vector<std::string>& teams_;
  RandomStream random_;
  std::vector<bool> swaps_;  // by pair: whether its teams are swapped in even cycles
  bool is_odd_cycle_ = false;
};

using Matchups = std::vector<std::array<std::string, 2>>;

SharedSettings checked(const game::GameSettings& game) {
  refuse_network(game.a, "teams.a");
  refuse_network(game.b, "teams.b");
  refuse_game_controller(game);
  game::check_game(game);
  return SharedSettings(game);
}

// A combination of a rule book and a camera.
class JudgeCell {
 public:
  JudgeCell(const JudgeSchedule& schedule, std::string its_rules, std::string its_camera)
      : rules(std::move(its_rules)), camera(std::move(its_camera)), base_(schedule.base) {
    game::set_value_at(base_, kRuleBookPath, rules);
    game::set_value_at(base_, kCameraPath, camera);
  }

  // The settings of a pair of legs. Without matchups, the teams of the base play.
  const SharedSettings& settings(const Matchups& matchups, int pair) {
    const std::array<std::string, 2> matchup =
        matchups.empty() ? std::array<std::string, 2>()
                         : matchups[static_cast<std::size_t>(pair - 1) % matchups.size()];
    const auto entry = settings_.find(matchup);
    if (entry != settings_.end()) return entry->second;
    return settings_.emplace(matchup, checked(matchups.empty() ? base_ : played_by(matchup)))
        .first->second;
  }

  const std::string rules;
  const std::string camera;

 private:
  game::GameSettings played_by(const std::array<std::string, 2>& matchup) const {
    game::GameSettings game = base_;
    game.a.strategy = matchup[0];
    game.b.strategy = matchup[1];
    game.a.program.command.clear();
    game.b.program.command.clear();
    return game;
  }

  game::GameSettings base_;
  std::map<std::array<std::string, 2>, SharedSettings> settings_;
};

std::vector<JudgeCell> cells_of(const JudgeSchedule& schedule) {
  std::vector<JudgeCell> cells;
  for (const std::string& rules : schedule.rules) {
    for (const std::string& camera : schedule.cameras) cells.emplace_back(schedule, rules, camera);
  }
  return cells;
}

// The matchups that the pairs of legs cycle through; empty if the base's teams play.
Matchups matchups_of(const JudgeSchedule& schedule, const NamedSeed& seed) {
  if (schedule.teams.empty()) return schedule.matchups;
  return dealt_matchups(schedule.teams, seed.value,
                        static_cast<std::size_t>(schedule.games_each + 1) / 2);
}

ScheduledJudgeGame game_of(JudgeCell& cell, const Matchups& matchups, const NamedSeed& seed,
                           int number) {
  const int pair = (number + 1) / 2;
  const int leg = 2 - number % 2;
  const SharedSettings& settings = cell.settings(matchups, pair);
  ScheduledJudgeGame game{"", seed.name, cell.rules, cell.camera,
                          settings.with(leg_of(seed.value, pair, leg))};
  std::vector<std::string> names = {
      cell.rules, cell.camera, name_of({game::name_of(settings.a()), game::name_of(settings.b())})};
  if (!seed.name.empty()) names.insert(names.begin(), seed.name);
  game.id = fmt::format("{} {}", fmt::join(names, " "), number);
  game.game_id = game_id(fmt::format("{}", fmt::join(names, "+")), pair, leg);
  game.pair = pair;
  game.leg = leg;
  return game;
}

}  // namespace

std::vector<std::array<std::string, 2>> dealt_matchups(const std::vector<std::string>& teams,
                                                       std::uint64_t seed, std::size_t count) {
  assert(!teams.empty());
  std::vector<std::array<std::string, 2>> dealt;
  Deal deal(teams, seed);
  while (dealt.size() < count) deal.add_cycle(dealt);
  dealt.resize(count);
  return dealt;
}

constinit const Kind JudgeSchedule::kKind = {
    "judge", "The referee's calls against ground truth, for the verb `judge`.", make, "judge"};

std::string name_of(const std::array<std::string, 2>& matchup) {
  return matchup[0] + "~" + matchup[1];
}

std::string text_of(const std::vector<NamedSeed>& seeds) {
  std::vector<std::string> texts;
  texts.reserve(seeds.size());
  for (const NamedSeed& seed : seeds) {
    const std::string number = std::to_string(seed.value);
    texts.push_back(fmt::format("{}{}{}{}", seed.name, seed.name.empty() ? "" : " ", seed.text,
                                seed.text == number ? "" : fmt::format(" ({})", number)));
  }
  return io::listed(texts);
}

void keep_seed(JudgeSchedule& schedule, const std::string& name) {
  std::vector<std::string> known;
  for (const NamedSeed& seed : schedule.seeds) {
    if (!seed.name.empty()) known.push_back(seed.name);
  }
  if (known.empty()) {
    throw std::invalid_argument("the file has a single `seed`; give it `seeds` with names");
  }
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw std::invalid_argument(
        fmt::format("expected one of the file's seeds, {}, found '{}'", io::listed(known), name));
  }
  std::erase_if(schedule.seeds, [&name](const NamedSeed& seed) { return seed.name != name; });
}

std::vector<ScheduledJudgeGame> games_of(const JudgeSchedule& schedule) {
  refuse_too_many(static_cast<double>(schedule.rules.size()) *
                      static_cast<double>(schedule.cameras.size()) *
                      static_cast<double>(schedule.seeds.size()) * schedule.games_each,
                  "games");
  std::vector<JudgeCell> cells = cells_of(schedule);
  std::vector<Matchups> matchups;
  matchups.reserve(schedule.seeds.size());
  for (const NamedSeed& seed : schedule.seeds) matchups.push_back(matchups_of(schedule, seed));
  std::vector<ScheduledJudgeGame> games;
  for (int number = 1; number <= schedule.games_each; ++number) {
    for (std::size_t i = 0; i < schedule.seeds.size(); ++i) {
      for (JudgeCell& cell : cells) {
        games.push_back(game_of(cell, matchups[i], schedule.seeds[i], number));
      }
    }
  }
  return games;
}

std::vector<Factor> JudgeSchedule::varied_settings() const {
  return {{kRuleBookPath, {rules.begin(), rules.end()}},
          {kCameraPath, {cameras.begin(), cameras.end()}}};
}

std::vector<ScheduledGame> JudgeSchedule::games() const {
  std::vector<ScheduledGame> games;
  for (const ScheduledJudgeGame& game : games_of(*this)) {
    games.push_back({game.game_id,
                     {game.seeds, game.rules, game.camera},
                     game.pair,
                     game.leg,
                     game.settings,
                     game::name_of(game.settings.a()),
                     game::name_of(game.settings.b()),
                     static_cast<std::size_t>(game.pair - 1)});
  }
  return games;
}

ExperimentResults JudgeSchedule::results(const RowsById& /*rows*/) const {
  throw std::logic_error("the calls of judged games are summed up in judge/");
}

}  // namespace autoref::experiments
