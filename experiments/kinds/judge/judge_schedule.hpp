// The games played to evaluate the referee, and how pairs of teams are dealt to them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

// The first `count` matchups (team a, team b) of an endless sequence that deals all pairs of teams
// again and again. There are n (n + 1) / 2 pairs for n teams, since each team also plays itself.
//
// Every pair is dealt once before any pair is dealt again, so after any number of matchups, two
// pairs differ by at most one in how often they have been dealt. Such a cycle contains n rounds in
// which every team plays, so the numbers of games per team also stay close. Teams a and b of a pair
// swap from one cycle to the next. The rest of the order is random and depends only on `seed`.
// There must be at least one team.
std::vector<std::array<std::string, 2>> dealt_matchups(const std::vector<std::string>& teams,
                                                       std::uint64_t seed, std::size_t count);

// A master seed, with a name for the purpose of its games.
struct NamedSeed {
  std::string name;        // "tuning" or "test"; empty if the file has a single seed
  std::string text = "1";  // seed as written in the file: "2016", or digits of a commit: "1c9f03ae"
  std::uint64_t value = 1;
  bool operator==(const NamedSeed&) const = default;
};

struct JudgeSchedule : ExperimentOf<JudgeSchedule> {
  static const Kind kKind;

  // Settings of all games, except those that vary: each rule book also sets the field, and each
  // camera also sets radio and latency.
  game::GameSettings base;
  std::vector<std::string> rules = {"paper"};
  std::vector<std::string> cameras;
  // Strategies, whose pairs are dealt evenly over the games. If empty, the games cycle through
  // `matchups`, the pairs of strategies for teams a and b. If that is empty as well, the teams of
  // `base` play.
  std::vector<std::string> teams;
  std::vector<std::array<std::string, 2>> matchups;
  int games_each = 2;  // number of games per seed, rule book and camera, 1 to 9999
  // The master seeds. Never empty. All games are played with every seed.
  std::vector<NamedSeed> seeds = std::vector<NamedSeed>(1);

  std::vector<Key> keys() override;
  // The experiment varies the rule book and the camera.
  std::vector<Factor> varied_settings() const override;
  // Returns the games of games_of().
  std::vector<ScheduledGame> games() const override;
  std::string why_no_pairs() const override {
    return "its size is set by a number of games, not of pairs";
  }
  RowKind row_kind() const override { return RowKind::kJudged; }
  std::vector<std::string> value_columns() const override { return {"seeds", "rules", "camera"}; }
  // Throws std::logic_error: judge/ evaluates the calls of judged games.
  ExperimentResults results(const RowsById& rows) const override;
};

// The setting that varies between the games of a JudgeSchedule, besides the rule book.
inline constexpr const char* kCameraPath = "sim.camera";

struct ScheduledJudgeGame {
  // Id for display: "test 2014 realistic basic~basic 3", or "2014 realistic basic~basic 3" if the
  // seed has no name.
  std::string id;
  std::string seeds;  // name of the game's master seed
  std::string rules;
  std::string camera;
  SharedSettings settings;
  std::string game_id = {};  // id of the game's row: "test+2014+realistic+basic~basic-p0002-1"
  int pair = 1;
  int leg = 1;
};

// "a~b", as written in scenario files.
std::string name_of(const std::array<std::string, 2>& matchup);

// "tuning 2016, test 1c9f03ae (480183214)": with the numeric value after each seed that is written
// as a word.
std::string text_of(const std::vector<NamedSeed>& seeds);

// Keeps only the games of the seed with this name. Throws std::invalid_argument, naming the known
// seeds, if there is none.
void keep_seed(JudgeSchedule& schedule, const std::string& name);

// Returns a game for every combination of game number, master seed, rule book and camera. Games
// with the same number and master seed have the same teams and the same seed under all rule books
// and cameras. The teams change ends between odd and even games. Throws std::invalid_argument if
// values in `schedule` contradict each other.
std::vector<ScheduledJudgeGame> games_of(const JudgeSchedule& schedule);

}  // namespace autoref::experiments
