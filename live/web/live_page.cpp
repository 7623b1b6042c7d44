#include "live/web/live_page.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <random>
#include <utility>
#include <vector>

#include "view/live_messages.hpp"

namespace autoref::live {
namespace {

WebText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

using std::chrono::milliseconds;

constexpr std::chrono::microseconds kFrameEvery{33'333};
constexpr milliseconds kEarliest{3};  // how much before its time a frame may be sent
constexpr milliseconds kMessageEvery{10};
constexpr std::size_t kFramesPerFold = 150;  // 5 s
constexpr std::size_t kKeptFrames = 18'000;  // ten minutes

std::string random_id() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

bool has_calls(const view::GameRecording& part) {
  return !part.signals().empty() || !part.clock().empty() || !part.decisions().empty() ||
         !part.chains().empty() || !part.shots().empty();
}

// Calls come before frames because the page needs the teams' ends first.
std::vector<std::size_t> kept_entries() {
  const view::LiveLimits limits;
  return {limits.signals, limits.clock_marks, limits.decisions,
          limits.chains,  limits.shots,       kKeptFrames};
}

}  // namespace

void MessageList::add(view::CountedMessage message) {
  if (message.entries == 0) return;
  message.text.shrink_to_fit();  // it is kept for a long time
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

LivePage::LivePage(const view::PageContent& content, const FrameClock& clock, Send send)
    : clock_(&clock),
      send_(std::move(send)),
      history_(view::start_message(content, random_id()), kept_entries()),
      present_(std::make_shared<const std::string>(view::present_message())),
      next_frame_(clock.now()),
      next_message_(next_frame_) {}

void LivePage::add(const Frame& frame, const RefereeSignal& signal) {
  const FrameClock::Time now = clock_->now();
  newest_.add(frame.time_s, signal);
  calls_.add(frame.time_s, signal);
  if (now + kEarliest >= next_frame_) {
    next_frame_ = std::max(next_frame_ + kFrameEvery, now);
    record(frame);
  } else {
    skipped_ = frame;
  }
  if (now >= next_message_) send_newest(now);
}

void LivePage::add(const view::RecordedDecision& decision) {
  newest_.add(decision);
  calls_.add(decision);
}

void LivePage::add(const view::RecordedChain& chain) {
  newest_.add(chain);
  calls_.add(chain);
}

void LivePage::add(const view::RecordedShot& shot) {
  newest_.add(shot);
  calls_.add(shot);
}

void LivePage::record(const Frame& frame) {
  newest_.add(frame);
  frames_.add(frame);
  skipped_.reset();
}

// The last frame is always sent because the page does not show signals that are later than its last
// frame.
void LivePage::end() {
  if (skipped_) record(Frame(*skipped_));
  send_newest(clock_->now());
  send_(history_.add(view::over_message("The game is over."), false));
}

WebBacklog LivePage::backlog() const {
  WebBacklog backlog = history_.backlog();
  backlog.texts.push_back(present_);
  return backlog;
}

void LivePage::send_newest(FrameClock::Time now) {
  const bool is_frame = !has_calls(newest_);
  if (is_frame && newest_.frames() == 0) return;
  next_message_ = now + kMessageEvery;
  send_(history_.add(view::part_message(newest_.take_recording()), is_frame));
  if (frames_.frames() >= kFramesPerFold) fold();
}

void LivePage::fold() {
  auto [signals, clock, decisions, chains, shots] = view::call_messages(calls_.take_recording());
  const view::GameRecording frames = frames_.take_recording();
  history_.fold({std::move(signals), std::move(clock), std::move(decisions), std::move(chains),
                 std::move(shots),
                 view::CountedMessage{view::part_message(frames), frames.frames()}});
}

WebView::WebView(const WebOptions& options, const view::PageContent& content)
    : page_(content, clock_, [this](const WebMessage& message) { server_.send(message); }),
      server_(thread_, options, {view::live_page(), [this] { return page_.backlog(); }}) {}

}  // namespace autoref::live
