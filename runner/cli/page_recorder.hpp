// Records a game for its page.
#pragma once

#include <string>

#include "runner/game/configuration.hpp"
#include "runner/game/game_record.hpp"
#include "runner/game/observer.hpp"
#include "runner/view/game_recording.hpp"
#include "runner/view/recorded_decision.hpp"

namespace autoref::runner {

// What a page shows of a decision.
RecordedDecision recorded(const referee::Decision& decision);

class PageRecorder final : public Observer {
 public:
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

  // The page of the game that has been recorded.
  std::string page(const GameConfiguration& game, const GameRecord& record) const;

 private:
  GameRecording recording_;
};

}  // namespace autoref::runner
