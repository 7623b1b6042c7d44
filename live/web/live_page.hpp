// Turns a simulated or real game into messages, and shows the game to watchers on the network.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "live/frame_pacer.hpp"
#include "live/network/network.hpp"
#include "live/web/web_message.hpp"
#include "live/web/web_server.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "view/game_recording.hpp"
#include "view/live_messages.hpp"
#include "view/page.hpp"

namespace autoref::live {

// The newest messages of one kind. The oldest one is dropped as soon as the others contain enough
// entries, so the memory is limited regardless of the game's length.
class MessageList {
 public:
  explicit MessageList(std::size_t enough) : enough_(enough) {}

  void add(view::CountedMessage message);  // ignored if it has no entries
  std::size_t entries() const { return entries_; }
  void append_to(std::vector<WebText>& texts) const;

 private:
  struct Kept {
    WebText text;
    std::size_t entries = 0;
  };

  std::size_t enough_;
  std::size_t entries_ = 0;
  std::deque<Kept> messages_;
};

// The messages that show a watcher the game so far. Messages are kept in lists; the newest ones are
// kept singly until messages in the lists replace them. One thread adds; any thread can ask for the
// backlog.
class MessageHistory {
 public:
  // `enough` is the number of entries that must be kept in each list.
  MessageHistory(std::string start, const std::vector<std::size_t>& enough);

  // Numbers the message and stores it.
  WebMessage add(std::string text, bool is_frame);

  // Replaces the messages since the last call by one message for each list.
  void fold(std::vector<view::CountedMessage> messages);

  // The start, the lists in their order, and the messages since the last fold.
  WebBacklog backlog() const;

 private:
  WebText start_;
  mutable std::mutex mutex_;
  std::vector<MessageList> lists_;
  std::vector<WebText> recent_;
  std::int64_t last_number_ = 0;
};

// Takes published positions (soccer/referee_signal.hpp). Sends about 30 frames per wall-clock
// second, and decisions, changed signals, chains and shots with the next frame that is added, in at
// most 100 messages per second. New watchers get the last ten minutes and as many calls as a page
// keeps (LiveLimits), so the memory for these messages is limited to about 10 MB. Most of it is
// used only after a game has lasted 13 hours.
class LivePage {
 public:
  using Send = std::function<void(const WebMessage&)>;

  // `content` needs no recording; `send` is called by the functions below.
  LivePage(const view::PageContent& content, const FrameClock& clock, Send send);

  // Times must increase.
  void add(const Frame& frame, const RefereeSignal& signal);
  void add(const view::RecordedDecision& decision);
  void add(const view::RecordedChain& chain);
  void add(const view::RecordedShot& shot);  // after its chain
  void end();                                // call when the game is over

  // Can be called in any thread.
  WebBacklog backlog() const;

 private:
  void record(const Frame& frame);
  void send_newest(FrameClock::Time now);
  void fold();

  const FrameClock* clock_;
  Send send_;
  MessageHistory history_;
  WebText present_;
  std::optional<Frame> skipped_;  // the last frame, unless it was sent
  view::GameRecording newest_;    // entries since the last message
  view::GameRecording frames_;    // frames since the last fold
  view::GameRecording calls_;     // other entries since the last fold
  FrameClock::Time next_frame_;
  FrameClock::Time next_message_;
};

// Shows one game to watchers on the network. Owns the game's page, its server and the server's
// thread.
class WebView {
 public:
  // Throws InputError naming --web if the server cannot listen, or --web-host.
  WebView(const WebOptions& options, const view::PageContent& content);

  // Like the functions of LivePage.
  void add(const Frame& frame, const RefereeSignal& signal) { page_.add(frame, signal); }
  void add(const view::RecordedDecision& decision) { page_.add(decision); }
  void add(const view::RecordedChain& chain) { page_.add(chain); }
  void add(const view::RecordedShot& shot) { page_.add(shot); }
  void end() { page_.end(); }

  std::string url() const { return server_.url(); }

 private:
  SteadyFrameClock clock_;
  LivePage page_;
  NetworkThread thread_;
  WebServer server_;
};

}  // namespace autoref::live
