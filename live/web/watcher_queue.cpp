#include "live/web/watcher_queue.hpp"

#include <algorithm>

namespace autoref::live {

void WatcherQueue::begin_with(const WebBacklog& backlog) {
  backlog_.assign(backlog.texts.begin(), backlog.texts.end());
  last_number_ = backlog.last_number;
}

bool WatcherQueue::push(const WebMessage& message) {
  if (message.number <= last_number_) return true;
  const bool is_long = bytes_ + message.text->size() > kMostWaiting_bytes;
  if (!message.is_frame && (is_long || waiting_.size() - frames_ >= kMostOthers)) return false;
  waiting_.push_back(message);
  bytes_ += message.text->size();
  frames_ += message.is_frame ? 1 : 0;
  if (frames_ > kMostFrames) leave_out_oldest_frame();
  return true;
}

void WatcherQueue::leave_out_oldest_frame() {
  const auto oldest = std::find_if(waiting_.begin(), waiting_.end(),
                                   [](const WebMessage& message) { return message.is_frame; });
  bytes_ -= oldest->text->size();
  waiting_.erase(oldest);
  --frames_;
  ++left_out_;
}

WebText WatcherQueue::pop() {
  WebText next;
  if (!backlog_.empty()) {
    next = backlog_.front();
    backlog_.pop_front();
  } else if (!waiting_.empty()) {
    next = waiting_.front().text;
    frames_ -= waiting_.front().is_frame ? 1 : 0;
    bytes_ -= next->size();
    waiting_.pop_front();
  }
  return next;
}

}  // namespace autoref::live
