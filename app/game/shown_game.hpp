// A single game on the network (--web), while it is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/web_flags.hpp"
#include "game/loop/configuration.hpp"
#include "game/loop/observer.hpp"
#include "live/web/web_view.hpp"
#include "view/page.hpp"

namespace autoref::app {

// Which game and which program a page shows.
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

class ShownGame {
 public:
  // Shows the game at `web`, and says so on stderr; nowhere if its address is empty. Throws
  // InputError naming --web or --web-host.
  ShownGame(const game::GameConfiguration& game, const WebFlags& web);

  // Null if the game is shown nowhere.
  game::Observer* observer() { return web_ ? &*web_ : nullptr; }

  // Says that the game is over, and leaves some time for the message to arrive.
  void end();

 private:
  std::optional<live::WebView> view_;
  std::optional<WebObserver> web_;
};

}  // namespace autoref::app
