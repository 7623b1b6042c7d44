// The interface of a kind of experiment. Each kind consists of a folder next to this file, with a
// struct of the user's settings derived from ExperimentOf, and a line in all_kinds.cpp. Its virtual
// functions are enough for reading and writing files, --set, --pairs and --seed, resuming, shards,
// verification, reports and the reference page.
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

namespace autoref::experiments {

class Experiment;

struct Kind {
  std::string_view name;                            // in `kind:`
  std::string_view about;                           // one sentence
  std::unique_ptr<Experiment> (*make)() = nullptr;  // with its defaults
  std::string_view verb = "run";                    // the verb of `autoref` that plays it
};

// The games an experiment needs, given its rows so far.
struct Schedule {
  std::vector<ScheduledGame> games;  // in playing order
  // Number of games needed. If less than games.size(), only the first ones count; if more, some
  // future games are not known yet.
  std::size_t needed = 0;
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  virtual const Kind& kind() const = 0;
  // An independent experiment with the same settings.
  virtual std::unique_ptr<Experiment> copy() const = 0;

  // The keys of its scenario file, in the order of effective.yaml; always the same ones. They refer
  // to this object and must not outlive it.
  virtual std::vector<Key> keys() = 0;
  // The settings of its base that vary between its games.
  virtual std::vector<Factor> varied_settings() const { return {}; }

  // The games known in advance, in playing order. Throws std::invalid_argument if the settings
  // contradict each other; if that is a SettingError, it names one of them.
  virtual std::vector<ScheduledGame> games() const = 0;
  // For messages: how the games actually played may differ from games(). Empty if they cannot
  // differ.
  virtual std::string caveat() const { return {}; }
  // All games of games() under the ids that `autoref check` uses: games with ids that differ only
  // in pair and leg are expected to take equally long.
  virtual std::vector<ScheduledGame> trial_games(std::vector<ScheduledGame> all) const {
    return all;
  }
  // Whether schedule() depends on the rows. If it does not, all of games() are needed.
  virtual bool follows_its_rows() const { return false; }
  // The games known given `rows`, the rows of the games played so far. Depends only on rows of the
  // experiment's own games. Keeps a game even if further rows make it unnecessary. Throws like
  // games().
  virtual Schedule schedule(const RowsById& rows) const;
  // Whether these rows make all remaining games unnecessary. Throws like games().
  virtual bool is_decided(const RowsById& rows) const;
  // The number of games in a round, if all games are played in rounds of equal size that depend on
  // all rows of earlier rounds. A shard that waits too long for the others then says so and exits
  // with code 75, and `autoref experiment submit` uses a single task unless a number is given.
  // Throws like games().
  virtual std::optional<std::size_t> games_of_a_round() const { return std::nullopt; }
  // How long a shard waits for other shards' games on which its next games depend, in s.
  virtual double default_wait_s() const { return 0; }
  // Why the experiment has no number of pairs, if none of its keys sets one.
  virtual std::string why_no_pairs() const { return {}; }

  virtual RowKind row_kind() const { return RowKind::kPlayed; }
  // Names of the row columns that contain a game's values (ScheduledGame::values).
  virtual std::vector<std::string> value_columns() const { return {}; }

  // Computes the results from the needed rows, some of which are missing while the experiment runs.
  // Throws std::logic_error for judged games, since their calls are summed up elsewhere.
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

// The rows of the needed games, from which the results are computed.
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

// Also replaces all named seeds.
void set_master_seed(Experiment& experiment, std::uint64_t seed);

}  // namespace autoref::experiments
