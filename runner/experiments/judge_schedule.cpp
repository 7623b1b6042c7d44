#include "runner/experiments/judge_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/experiments/cells.hpp"
#include "runner/experiments/dealt_matchups.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

using Matchups = std::vector<std::array<std::string, 2>>;

// A rule book with a camera.
struct JudgeCell {
  std::string rules;
  std::string camera;
  GameSettings configuration;
};

std::vector<JudgeCell> cells_of(const JudgeSchedule& schedule) {
  std::vector<JudgeCell> cells;
  for (const std::string& rules : schedule.rules) {
    for (const std::string& camera : schedule.cameras) {
      cells.push_back({rules, camera, configured(schedule, rules, camera)});
    }
  }
  return cells;
}

// The matchups that the pairs of legs cycle through; empty if the base's teams play.
Matchups matchups_of(const JudgeSchedule& schedule, const NamedSeed& seed) {
  if (schedule.teams.empty()) return schedule.matchups;
  return dealt_matchups(schedule.teams, seed.value,
                        static_cast<std::size_t>(schedule.games + 1) / 2);
}

JudgeGame game_of(const JudgeCell& cell, const Matchups& matchups, const NamedSeed& seed,
                  int number) {
  const int pair = (number + 1) / 2;
  const int leg = 2 - number % 2;
  JudgeGame game{"", seed.name, cell.rules, cell.camera, cell.configuration};
  if (!matchups.empty()) {
    const auto& matchup = matchups[static_cast<std::size_t>(pair - 1) % matchups.size()];
    game.configuration.a.strategy = matchup[0];
    game.configuration.b.strategy = matchup[1];
    game.configuration.a.command.clear();
    game.configuration.b.command.clear();
  }
  set_leg(game.configuration, seed.value, pair, leg);
  std::vector<std::string> names = {
      cell.rules, cell.camera,
      name_of({name_of(game.configuration.a), name_of(game.configuration.b)})};
  if (!seed.name.empty()) names.insert(names.begin(), seed.name);
  game.id = fmt::format("{} {}", fmt::join(names, " "), number);
  game.game_id = game_id(fmt::format("{}", fmt::join(names, "+")), pair, leg);
  game.pair = pair;
  game.leg = leg;
  check_game(game.configuration);
  return game;
}

}  // namespace

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
  return listed(texts);
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
        fmt::format("expected one of the file's seeds, {}, found '{}'", listed(known), name));
  }
  std::erase_if(schedule.seeds, [&name](const NamedSeed& seed) { return seed.name != name; });
}

std::vector<JudgeGame> games_of(const JudgeSchedule& schedule) {
  refuse_too_many(static_cast<double>(schedule.rules.size()) *
                      static_cast<double>(schedule.cameras.size()) *
                      static_cast<double>(schedule.seeds.size()) * schedule.games,
                  "games");
  const std::vector<JudgeCell> cells = cells_of(schedule);
  std::vector<Matchups> matchups;
  matchups.reserve(schedule.seeds.size());
  for (const NamedSeed& seed : schedule.seeds) matchups.push_back(matchups_of(schedule, seed));
  std::vector<JudgeGame> games;
  for (int number = 1; number <= schedule.games; ++number) {
    for (std::size_t i = 0; i < schedule.seeds.size(); ++i) {
      for (const JudgeCell& cell : cells) {
        games.push_back(game_of(cell, matchups[i], schedule.seeds[i], number));
      }
    }
  }
  return games;
}

std::vector<ScheduledGame> scheduled_games(const JudgeSchedule& schedule) {
  std::vector<ScheduledGame> games;
  for (const JudgeGame& game : games_of(schedule)) {
    const GameSettings& c = game.configuration;
    games.push_back({game.game_id,
                     {game.seeds, game.rules, game.camera},
                     game.pair,
                     game.leg,
                     c,
                     name_of(c.a),
                     name_of(c.b),
                     static_cast<std::size_t>(game.pair - 1)});
  }
  return games;
}

}  // namespace autoref::runner
