// Records a game for its page.
#pragma once

#include <string>

#include "game/loop/configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "view/game_recording.hpp"
#include "view/recorded_decision.hpp"

namespace autoref::app {

// What a page shows of a decision.
view::RecordedDecision recorded(const referee::Decision& decision);

class PageRecorder final : public game::Observer {
 public:
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

  // The page of the game that has been recorded.
  std::string page(const game::GameConfiguration& game, const game::GameRecord& record) const;

 private:
  view::GameRecording recording_;
};

}  // namespace autoref::app
