// The game that AutoRef judges, from a log or from the network, and the options shared by the verbs
// of `autoref referee`.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::app {

struct RefereeArguments {
  std::string rules;          // empty: the rule book is guessed from the field and the date
  std::string first_kickoff;  // empty: as announced by the referee packets
  std::string control;        // empty: the default of the verb
  std::string source;         // vision or tracker; empty: the default of the verb
  std::string camera;  // camera preset; empty: no vision error except the rounding in the packets
  std::vector<std::string> sets;  // "key=value"
  std::string events;             // output file for AutoRef's decisions; empty: none
  std::string game_events;        // output file for AutoRef's game events; empty: none
};

// Adds the options that describe a game, from --rules to --set. `default_control` and
// `default_source` describe what the verb assumes without --control and --source.
void add_referee_options(CLI::App& verb, RefereeArguments& arguments,
                         const std::string& default_control, const std::string& default_source);

// The rule book must be chosen first because it sets field, robots and durations, which the
// recorded facts then override. Throws InputError if an assignment chooses the rule book.
void refuse_book_among(const game::Assignments& assignments);

// The rule book given by --rules, or else a guess, which is reported on stderr. `source` says
// whether the guess is based on the log or on the network.
std::string book_of(const RefereeArguments& arguments, const logs::RecordedFacts& facts,
                    const std::string& source);

// Throws InputError if the log, `source`, has no frames of the kind that the arguments choose.
void check_has_frames(const RefereeArguments& arguments, const logs::RecordedFacts& facts,
                      const std::string& source);

// The game under the rule book `book`, with the recorded facts and the user's settings applied.
// Throws InputError if AutoRef cannot referee it.
game::GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                           const game::Assignments& assignments, const logs::RecordedFacts& facts,
                           const logs::RecordedGame& recorded, const std::string& source);

// Lists on stderr the settings that the recorded facts do not provide.
void print_gaps(const RefereeArguments& arguments, const game::Assignments& assignments,
                const logs::RecordedFacts& facts, const game::GameSettings& game,
                const std::string& source);

}  // namespace autoref::app
