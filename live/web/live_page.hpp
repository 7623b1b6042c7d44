// Turns a game, simulated or real, into messages for watchers.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "live/frame_pacer.hpp"
#include "live/web/message_history.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "view/game_recording.hpp"
#include "view/page.hpp"
#include "view/recorded_decision.hpp"

namespace autoref::live {

// Takes published positions (soccer/published.hpp). Sends about 30 frames per second of the clock,
// and decisions and changed signals with the next frame that is added, at most 100 messages per
// second. New watchers get the last ten minutes and as many calls as a page keeps (LiveLimits), so
// that the memory for them is limited: to about 10 MB, most of it after 13 hours of a game.
class LivePage {
 public:
  using Send = std::function<void(const WebMessage&)>;

  // `content` needs no recording; `send` is called by the functions below.
  LivePage(const view::PageContent& content, const FrameClock& clock, Send send);

  // Times must increase.
  void add(const Frame& frame, const RefereeSignal& signal);
  void add(const view::RecordedDecision& decision);
  void end();  // the game is over

  // May be called in any thread.
  WebBacklog backlog() const;

 private:
  void take(const Frame& frame);
  void send_newest(FrameClock::Time now);
  void fold();

  const FrameClock* clock_;
  Send send_;
  MessageHistory history_;
  WebText present_;
  std::optional<Frame> skipped_;  // the last frame, unless it was sent
  view::GameRecording newest_;    // since the last message
  view::GameRecording frames_;    // since the last fold
  view::GameRecording calls_;     // likewise
  FrameClock::Time next_frame_;
  FrameClock::Time next_message_;
};

}  // namespace autoref::live
