// A single game on the network (--web), while it is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/cli/web_flags.hpp"
#include "runner/game/configuration.hpp"
#include "runner/game/observer.hpp"
#include "runner/live/web_view.hpp"
#include "runner/view/page.hpp"

namespace autoref::runner {

// Which game and which program a page shows.
std::vector<PageFact> facts_of(const GameConfiguration& game);

// Shows a simulated game.
class WebObserver final : public Observer {
 public:
  explicit WebObserver(WebView& view) : view_(&view) {}

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

 private:
  WebView* view_;
};

class ShownGame {
 public:
  // Shows the game at `web`, and says so on stderr; nowhere if its address is empty. Throws
  // InputError naming --web or --web-host.
  ShownGame(const GameConfiguration& game, const WebFlags& web);

  // Null if the game is shown nowhere.
  Observer* observer() { return web_ ? &*web_ : nullptr; }

  // Says that the game is over, and leaves some time for the message to arrive.
  void end();

 private:
  std::optional<WebView> view_;
  std::optional<WebObserver> web_;
};

}  // namespace autoref::runner
