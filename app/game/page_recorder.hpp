// Records a game as a page, and shows it in the browser while it is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/network_flags.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/loop/win_probability_observer.hpp"
#include "game/play_counts/possession_chains.hpp"
#include "io/files.hpp"
#include "live/web/live_page.hpp"
#include "view/game_recording.hpp"
#include "view/page.hpp"

namespace autoref::app {

// The part of a decision that a page shows.
view::RecordedDecision recorded(const referee::Decision& decision);

// A chain, a shot and an action as a page shows them. `blue_on_positive_half`: as in the referee's
// signal at the time of the shot or action.
view::RecordedChain recorded(const game::PossessionChain& chain, double frame_rate_hz);
view::RecordedShot recorded(const game::Shot& shot, double frame_rate_hz,
                            bool blue_on_positive_half);
view::RecordedAction recorded(const game::BallAction& action, double frame_rate_hz,
                              bool blue_on_positive_half);

// All names of game::ChainStart and game::ChainEnd.
view::ChainKinds chain_kinds();

class PageRecorder final : public game::Observer {
 public:
  // `growing`: a growing file to which the game is also written while it is played, as a page that
  // lacks at most its last second; null: none. `game` and `growing` must outlive the recorder.
  explicit PageRecorder(const game::GameConfiguration& game, io::PendingFile* growing = nullptr);
  PageRecorder(const PageRecorder&) = delete;
  PageRecorder& operator=(const PageRecorder&) = delete;

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;
  void on_action(const game::BallAction& action) override;
  void on_chain(const game::PossessionChain& chain) override;
  void on_shot(const game::Shot& shot) override;
  void on_play(const game::StateOfPlay& play) override {
    if (win_probability_) win_probability_->on_play(play);
  }

  // The page of the game that has been recorded.
  std::string page(const game::GameRecord& record) const;

  // Whether the game was too long for that page.
  bool is_full() const { return recording_.is_full(); }

  // Writes what has happened since the last second to the growing file.
  void grow();

 private:
  template <typename... Entry>
  void add(const Entry&... entry) {
    recording_.add(entry...);
    if (growing_ != nullptr) newest_.add(entry...);
  }
  view::PageContent content(const view::GameRecording& recording) const;

  const game::GameConfiguration* game_;
  io::PendingFile* growing_;
  view::GameRecording recording_;
  view::GameRecording newest_;  // what the growing file does not have yet
  bool has_grown_ = false;
  std::optional<game::WinProbabilityObserver> win_probability_;  // nullopt for a scene
  bool blue_on_positive_half_ = true;                            // in the last frame
};

// Facts that identify the game and the program on a page.
std::vector<view::PageFact> facts_of(const game::GameConfiguration& game);

// Shows a simulated game.
class WebObserver final : public game::Observer {
 public:
  WebObserver(live::WebView& view, double frame_rate_hz)
      : view_(&view), frame_rate_hz_(frame_rate_hz) {}

  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;
  void on_chain(const game::PossessionChain& chain) override;
  void on_shot(const game::Shot& shot) override;

 private:
  live::WebView* view_;
  double frame_rate_hz_;
  bool blue_on_positive_half_ = true;  // in the last frame
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
