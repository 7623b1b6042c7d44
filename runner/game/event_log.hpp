// The referee's decisions in a game, one JSON object per line.
#pragma once

#include <string>
#include <utility>

#include "runner/game/game.hpp"

namespace autoref::runner {

// The team that wears a colour: its letter ("a" or "b") and name; empty if unknown.
struct EventTeam {
  std::string letter;
  std::string name;
};

// The teams of a game, with the names returned by shown_names() (configuration.hpp).
PerSide<EventTeam> event_teams_of(const GameConfiguration& game);

// One line, without the newline. Every line has the same keys; unknown or inapplicable values are
// null. Sides are identified by their colours, "yellow" and "blue", as in the commands. Positions
// are published ones (soccer/published.hpp).
std::string decision_json(const referee::Decision& decision, const PerSide<EventTeam>& teams = {});

// Collects the lines of a game.
class EventLog final : public Observer {
 public:
  explicit EventLog(PerSide<EventTeam> teams = {}) : teams_(std::move(teams)) {}
  void on_decision(const referee::Decision& decision) override {
    text_ += decision_json(decision, teams_) + "\n";
  }
  const std::string& text() const { return text_; }

 private:
  PerSide<EventTeam> teams_;
  std::string text_;
};

}  // namespace autoref::runner
