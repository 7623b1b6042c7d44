// The referee's decisions of a game, one JSON object a line.
#pragma once

#include <string>
#include <utility>

#include "runner/game/game.hpp"

namespace autoref::runner {

// Who plays in a colour: the letter of its team ("a" or "b") and its name; empty where not known.
struct EventTeam {
  std::string letter;
  std::string name;
};

// The teams of a game, named as shown_names() (configuration.hpp) has them.
PerSide<EventTeam> event_teams_of(const GameConfiguration& game);

// One line without its end. Every line has the same keys; what is unknown or does not apply is
// null. Sides are named by their colours, "yellow" and "blue", as the commands are.
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
