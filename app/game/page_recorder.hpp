// Records a game as a page, and shows it in the browser while it is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/network_flags.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "live/web/live_page.hpp"
#include "view/game_recording.hpp"
#include "view/page.hpp"

namespace autoref::app {

// The part of a decision that a page shows.
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

// Facts that identify the game and the program on a page.
std::vector<view::PageFact> facts_of(const game::GameConfiguration& game);

// Shows a simulated game.
class WebObserver final : public game::Observer {
 public:
  explicit WebObserver(live::WebView& view) : view_(&view) {}

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

 private:
  live::WebView* view_;
};

class GameOnWeb {
 public:
  // Shows the game at `web` and reports the address on stderr. Does neither if the address is
  // empty. Throws InputError naming --web or --web-host.
  GameOnWeb(const game::GameConfiguration& game, const WebFlags& web);

  // The observer that shows the game; null if the game is not shown.
  game::Observer* observer() { return web_ ? &*web_ : nullptr; }

  // Announces that the game is over and gives the message some time to arrive.
  void end();

 private:
  std::optional<live::WebView> view_;
  std::optional<WebObserver> web_;
};

}  // namespace autoref::app
