// The fields of the referee's decisions, and the event log of a game: one JSON object per line.
// Also the log of the league's game events that correspond to the decisions.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "game/loop/game.hpp"
#include "io/json.hpp"
#include "referee/decision.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::game {

// The team that wears a colour: its letter ("a" or "b") and name; empty if unknown.
struct EventTeam {
  std::string letter;
  std::string name;
};

// Facts about the game that every line repeats.
struct EventGame {
  PerSide<EventTeam> teams;
  std::string rule_changes;  // rule_changes_in() (game_configuration.hpp)
};

// The teams have the names returned by shown_names() (game_configuration.hpp).
EventGame event_game_of(const GameConfiguration& game);

// Types of columns in a database.
namespace column_type {
inline constexpr const char* kInteger = "INTEGER";
inline constexpr const char* kReal = "REAL";
inline constexpr const char* kText = "TEXT";
}  // namespace column_type

// A field of a decision, in event logs and in databases. Sides are identified by their colours,
// "yellow" and "blue", as in the commands. Positions are as published (soccer/referee_signal.hpp).
struct DecisionField {
  const char* path;  // path of the field in a line of the event log (JSON pointer, RFC 6901)
  const char* type;  // type of the field's column in a database
  // The field's value; null if unknown or inapplicable. A field is discarded if the object that
  // contains it is null.
  io::Json (*value)(const referee::Decision& decision, const EventGame& game);
  // Name of the column; null: derived from the path; empty: no column.
  const char* column = nullptr;

  bool has_column() const { return column == nullptr || *column != 0; }
};

// All fields, in the order of a line's keys and of a database's columns. This list determines the
// content of event logs and databases; pages show a selection from it (view/game_recording.hpp).
std::span<const DecisionField> decision_fields();

// The name of the field's column: by default its path, with underscores. Empty if there is no
// column.
std::string column_of(const DecisionField& field);

// A line of the event log as an object. All lines have the same keys.
io::Json decision_object(const referee::Decision& decision, const EventGame& game = {});

// The line as text, without the newline.
std::string decision_json(const referee::Decision& decision, const EventGame& game = {});

// Collects the lines of a game.
class EventLog final : public Observer {
 public:
  explicit EventLog(EventGame game = {}) : game_(std::move(game)) {}
  void on_decision(const referee::Decision& decision) override {
    text_ += decision_json(decision, game_) + "\n";
  }
  const std::string& text() const { return text_; }

 private:
  EventGame game_;
  std::string text_;
};

struct TimedGameEvent {
  double time_s = 0;  // time since the start of the game or log
  GameEvent event;
};

// Collects the league's events for a referee's decisions.
class GameEventLog {
 public:
  // `start_unix_s` is the Unix time of the game's time 0.
  explicit GameEventLog(double start_unix_s = 0) : start_unix_s_(start_unix_s) {}

  void on_decision(const referee::Decision& decision);

  // The events so far, without decisions for which the league has no event.
  const std::vector<TimedGameEvent>& events() const { return events_; }

 private:
  double start_unix_s_ = 0;
  std::vector<TimedGameEvent> events_;
};

// The events as JSON (game_event_fields.hpp), one per line.
std::string game_event_lines(const std::vector<TimedGameEvent>& events);

}  // namespace autoref::game
