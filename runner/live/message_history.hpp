// The messages that show a watcher the game so far.
#pragma once

#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "runner/live/web_message.hpp"

namespace autoref::runner {

// Keeps the newest chunks of frames, the newest chunks of calls, and single messages until they are
// replaced by chunks. One thread adds; any thread may ask for the backlog.
class MessageHistory {
 public:
  MessageHistory(std::string start, std::size_t most_frame_chunks, std::size_t most_call_chunks);

  // Numbers the message and keeps it.
  WebMessage add(std::string text, bool is_frame);

  // Replaces the messages since the last call by their frames and their calls; an empty text is
  // left out.
  void fold(std::string frames, std::string calls);

  WebBacklog backlog() const;

 private:
  WebText start_;
  std::size_t most_frame_chunks_;
  std::size_t most_call_chunks_;
  mutable std::mutex mutex_;
  std::deque<WebText> frames_;
  std::deque<WebText> calls_;
  std::vector<WebText> recent_;
  std::int64_t last_number_ = 0;
};

}  // namespace autoref::runner
