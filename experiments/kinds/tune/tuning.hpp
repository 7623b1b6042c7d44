// Tuning: improving a team's parameters by playing games.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/statistics/sequential_test.hpp"
#include "experiments/tune/optimiser.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// A parameter of the team and the range searched for its best value. All numbers are in the
// parameter's unit.
struct TunedParameter {
  std::string name;  // the parameter's name, as in `params:`
  double from = 0;
  double to = 1;
  double start = 0;
  double step = 0.2;   // distance from the current value at which its effect is first tested
  bool whole = false;  // whether only whole numbers are played
  bool operator==(const TunedParameter&) const = default;
};

inline constexpr const char* kSpsaName = "spsa";
inline constexpr const char* kCmaEsName = "cma-es";

// The key of the final test, which compares the result with the start.
inline constexpr const char* kTestKey = "test";

struct Tuning : ExperimentOf<Tuning> {
  static const Kind kKind;

  game::GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  game::TeamSettings team;  // the tuned team, including the parameters that are not tuned
  std::vector<TunedParameter> parameters;
  Teams opponents;  // if empty, candidates play each other
  // Weights of the opponents; an opponent without an entry has weight 1.
  std::map<std::string, double> weights;
  std::string method = kSpsaName;
  int iterations = 100;
  int pairs = 4;      // pairs of legs per candidate, opponent and iteration
  double gain = 0.3;  // gain of SPSA
  // Compares the result with the start.
  SequentialTest test = {.d0 = 0, .d1 = 0.5, .max_pairs = 400};
  std::uint64_t seed = 1;  // master seed

  bool is_against_itself() const { return opponents.empty(); }
  double weight_of(const std::string& opponent) const;

  std::vector<Key> keys() override;
  // The games that would be played if all were drawn. Their number is right, but their parameters
  // are not.
  std::vector<ScheduledGame> games() const override;
  std::string caveat() const override;
  // Gives the games of all iterations a common prefix: "search-plus~zone-p0001-1" for
  // "k0007-plus~zone-p0001-1".
  std::vector<ScheduledGame> trial_games(std::vector<ScheduledGame> all) const override;
  bool follows_its_rows() const override { return true; }
  // The known games. Games of later iterations, which are not known yet, also count as needed.
  Schedule schedule(const RowsById& rows) const override;
  bool is_decided(const RowsById& rows) const override;
  std::optional<std::size_t> games_of_a_round() const override;
  double default_wait_s() const override { return 600; }
  std::vector<std::string> value_columns() const override;
  ExperimentResults results(const RowsById& rows) const override;
};

using ParamValues = std::vector<double>;  // values of the tuned parameters, in their order

// Creates the optimiser, with the tuned parameters as axes.
std::unique_ptr<Optimiser> optimiser_of(const Tuning& tuning);

// The parameter values played at a point of the search. Values are whole numbers where required,
// and otherwise rounded to five significant digits of the range. Rounded values are readable and do
// not depend on the last bit of a result.
ParamValues values_at(const Tuning& tuning, const Point& point);

ParamValues start_values(const Tuning& tuning);

// The tuned team with these parameter values.
game::TeamSettings team_with(const Tuning& tuning, const ParamValues& values);

// The values as written in a scenario: "0.53412", whole numbers as "4.0".
std::vector<std::string> spelt(const ParamValues& values);

// Throws SettingError if the settings contradict each other.
void check(const Tuning& tuning);

// The key `tune`, with the parameters by name. Takes a parameter's range and start from the
// strategy's description of it, if there is one. The team must therefore be read first.
Key parameters_key(Tuning& tuning);

}  // namespace autoref::experiments
