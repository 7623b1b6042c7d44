// The referee's decisions of a game, one JSON object a line.
#pragma once

#include <string>

#include "runner/game/game.hpp"

namespace autoref::runner {

// One line without its end. Unknown things are null; sides are "west" and "east".
std::string decision_json(const referee::Decision& decision);

// Collects the lines of a game.
class EventLog final : public Observer {
 public:
  void on_decision(const referee::Decision& decision) override {
    text_ += decision_json(decision) + "\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace autoref::runner
