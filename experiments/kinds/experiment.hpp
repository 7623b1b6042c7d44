// The interface of a kind of experiment. Each kind consists of a folder next to this file, with a
// struct of the user's settings derived from ExperimentOf, and a line in all_kinds.cpp. A kind only
// has to implement the virtual functions of Experiment; they suffice for reading and writing files,
// --set, --pairs and --seed, resuming, shards, verification, reports and the reference page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/keys.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/results/row_format.hpp"
#include "experiments/schedule/factor.hpp"
#include "experiments/schedule/schedule.hpp"
#include "experiments/schedule/team_versions.hpp"

namespace autoref::experiments {

class Experiment;

struct Kind {
  std::string_view name;                            // the value of `kind:` in a scenario file
  std::string_view about;                           // description in one sentence
  std::unique_ptr<Experiment> (*make)() = nullptr;  // creates an experiment with default settings
  std::string_view verb = "run";                    // the verb of `autoref` that plays it
};

// The games that an experiment needs, given the rows of the games played so far.
struct Schedule {
  std::vector<ScheduledGame> games;  // known games, in playing order
  // Number of games needed. If it is less than games.size(), only the first `needed` games count.
  // If it is more, some future games are not known yet.
  std::size_t needed = 0;
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  virtual const Kind& kind() const = 0;
  // An independent experiment with the same settings.
  virtual std::unique_ptr<Experiment> copy() const = 0;

  // The keys of the experiment's scenario file, in the order of effective.yaml. Every call returns
  // the same keys. The keys refer to this object and must not outlive it.
  virtual std::vector<Key> keys() = 0;
  // The settings of `base` that vary between the experiment's games.
  virtual std::vector<Factor> varied_settings() const { return {}; }

  // The teams whose ratings can be followed over time. The pointers are into this object.
  virtual std::optional<VersionedTeams> versioned_teams() { return std::nullopt; }

  // The games known in advance, in playing order. Throws std::invalid_argument if the settings
  // contradict each other; if that is a SettingError, it names one of them.
  virtual std::vector<ScheduledGame> games() const = 0;
  // How the games actually played may differ from games(), as text for messages. Empty if they
  // cannot differ.
  virtual std::string caveat() const { return {}; }
  // All games of games(), with the ids that `autoref check` uses. If two ids differ only in pair
  // and leg, the games are expected to take equally long to play.
  virtual std::vector<ScheduledGame> trial_games(std::vector<ScheduledGame> all) const {
    return all;
  }
  // Whether schedule() depends on the rows. If it does not, all of games() is needed.
  virtual bool follows_its_rows() const { return false; }
  // The games known given `rows`, the rows of the games played so far. Ignores rows of games that
  // do not belong to the experiment. Keeps a game even if further rows make it unnecessary. Throws
  // like games().
  virtual Schedule schedule(const RowsById& rows) const;
  // Whether games of a round may turn out to be unnecessary, so that is_decided() is asked after
  // each game. If not, games are written to the disk in groups, which is faster.
  virtual bool may_end_within_a_round() const { return follows_its_rows(); }
  // Whether the result is decided by these rows, so that no more games are needed. Throws like
  // games().
  virtual bool is_decided(const RowsById& rows) const;
  // The number of games in a round, if games are played in rounds of equal size and each round
  // depends on all rows of earlier rounds. A shard that waits too long for the other shards then
  // says so and exits with code 75. `autoref experiment submit` then uses a single task unless you
  // give a number of tasks. Throws like games().
  virtual std::optional<std::size_t> games_of_a_round() const { return std::nullopt; }
  // How long a shard waits for other shards' games on which its next games depend, in s.
  virtual double default_wait_s() const { return 0; }
  // The reason why no key sets a number of pairs, as text for messages.
  virtual std::string why_no_pairs() const { return {}; }

  virtual RowKind row_kind() const { return RowKind::kPlayed; }
  // Names of the row columns that contain a game's values (ScheduledGame::values).
  virtual std::vector<std::string> value_columns() const { return {}; }

  // Computes the results from the needed rows, some of which are missing while the experiment runs.
  // Throws std::logic_error for judged games, because judge/ evaluates those.
  virtual ExperimentResults results(const RowsById& rows) const = 0;
};

template <typename Its>
class ExperimentOf : public Experiment {
 public:
  const Kind& kind() const override { return Its::kKind; }
  std::unique_ptr<Experiment> copy() const override {
    return std::make_unique<Its>(static_cast<const Its&>(*this));
  }
  static std::unique_ptr<Experiment> make() { return std::make_unique<Its>(); }
};

// Reads the scenario file and applies the command line's settings. If it throws InputError, the
// experiment is only partly read.
void read_keys(TopReader& top, Experiment& experiment);

// Those of `rows` that belong to needed games. The results are computed from these rows.
RowsById needed_rows(const Schedule& schedule, RowsById rows);

// The format of the experiment's rows.
RowFormat row_format(const Experiment& experiment);

// The settings in which two experiments of one kind differ: "match.half_s is 60.0 here and 600.0
// there; ...". Empty if no setting differs or if the kinds differ. Ignores factor values and teams
// that occur in only one of the experiments, since those belong to different games.
std::string changes_between(const Experiment& here, const Experiment& there);

// The number of pairs of legs per combination or matchup, or the maximum of an SPRT match; nullopt
// if the kind has none.
std::optional<int> pairs_of(const Experiment& experiment);

// The experiment's master seed; nullopt if it has several with names.
std::optional<std::uint64_t> master_seed_of(const Experiment& experiment);

// The seed or seeds as text, for reports; empty if no key is a seed.
std::string seed_text(const Experiment& experiment);

// If the experiment cannot have this many pairs, throws std::invalid_argument and changes nothing.
void set_pairs(Experiment& experiment, int pairs);

// The versions that the experiment rates; nullopt if it has none.
std::optional<TeamVersions> versions_of(const Experiment& experiment);

// Sets the master seed, which also replaces all named seeds.
void set_master_seed(Experiment& experiment, std::uint64_t seed);

}  // namespace autoref::experiments
