#include "live/web/message_history.hpp"

#include <utility>

namespace autoref::live {
namespace {

WebText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

}  // namespace

void MessageList::add(view::CountedMessage message) {
  if (message.entries == 0) return;
  message.text.shrink_to_fit();  // it is kept for long
  entries_ += message.entries;
  messages_.push_back({shared(std::move(message.text)), message.entries});
  while (entries_ - messages_.front().entries >= enough_) {
    entries_ -= messages_.front().entries;
    messages_.pop_front();
  }
}

void MessageList::append_to(std::vector<WebText>& texts) const {
  for (const Kept& message : messages_) texts.push_back(message.text);
}

MessageHistory::MessageHistory(std::string start, const std::vector<std::size_t>& enough)
    : start_(shared(std::move(start))), lists_(enough.begin(), enough.end()) {}

WebMessage MessageHistory::add(std::string text, bool is_frame) {
  WebText message = shared(std::move(text));
  const std::lock_guard lock(mutex_);
  recent_.push_back(message);
  return {std::move(message), is_frame, ++last_number_};
}

void MessageHistory::fold(std::vector<view::CountedMessage> messages) {
  const std::lock_guard lock(mutex_);
  recent_.clear();
  for (std::size_t i = 0; i < lists_.size(); ++i) lists_[i].add(std::move(messages.at(i)));
}

WebBacklog MessageHistory::backlog() const {
  const std::lock_guard lock(mutex_);
  WebBacklog backlog{{start_}, last_number_};
  for (const MessageList& list : lists_) list.append_to(backlog.texts);
  backlog.texts.insert(backlog.texts.end(), recent_.begin(), recent_.end());
  return backlog;
}

}  // namespace autoref::live
