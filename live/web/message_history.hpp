// The messages that show a watcher the game so far.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "live/web/web_message.hpp"
#include "view/live_messages.hpp"

namespace autoref::live {

// The newest messages of one kind. The oldest one goes as soon as the others contain enough
// entries, so that what is kept is limited however long the game is.
class MessageList {
 public:
  explicit MessageList(std::size_t enough) : enough_(enough) {}

  void add(view::CountedMessage message);  // without entries, it is left out
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

// Keeps lists of messages, and single messages until they are replaced by messages of the lists.
// One thread adds; any thread may ask for the backlog.
class MessageHistory {
 public:
  // `enough` is how many entries of each list must be kept.
  MessageHistory(std::string start, const std::vector<std::size_t>& enough);

  // Numbers the message and keeps it.
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

}  // namespace autoref::live
