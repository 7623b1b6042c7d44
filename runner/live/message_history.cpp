#include "runner/live/message_history.hpp"

#include <utility>

namespace autoref::runner {
namespace {

WebText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

void keep(std::deque<WebText>& chunks, const WebText& chunk, std::size_t most) {
  if (chunk->empty()) return;
  chunks.push_back(chunk);
  if (chunks.size() > most) chunks.pop_front();
}

}  // namespace

MessageHistory::MessageHistory(std::string start, std::size_t most_frame_chunks,
                               std::size_t most_call_chunks)
    : start_(shared(std::move(start))),
      most_frame_chunks_(most_frame_chunks),
      most_call_chunks_(most_call_chunks) {}

WebMessage MessageHistory::add(std::string text, bool is_frame) {
  WebText message = shared(std::move(text));
  const std::lock_guard lock(mutex_);
  recent_.push_back(message);
  return {std::move(message), is_frame, ++last_number_};
}

void MessageHistory::fold(std::string frames, std::string calls) {
  const WebText frame_chunk = shared(std::move(frames));
  const WebText call_chunk = shared(std::move(calls));
  const std::lock_guard lock(mutex_);
  recent_.clear();
  keep(frames_, frame_chunk, most_frame_chunks_);
  keep(calls_, call_chunk, most_call_chunks_);
}

// Calls come first: the page needs the teams' ends before the frames.
WebBacklog MessageHistory::backlog() const {
  const std::lock_guard lock(mutex_);
  WebBacklog backlog{{start_}, last_number_};
  for (const auto* chunks : {&calls_, &frames_})
    backlog.texts.insert(backlog.texts.end(), chunks->begin(), chunks->end());
  backlog.texts.insert(backlog.texts.end(), recent_.begin(), recent_.end());
  return backlog;
}

}  // namespace autoref::runner
