#include "live/simulator/lock_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "live/network/stream_server.hpp"

namespace autoref::live {
namespace {

constexpr std::size_t kMostWaitingRequests = 64;
// Part of a response reserved for errors and feedback.
constexpr std::size_t kReserved_bytes = 4096;
constexpr std::size_t kFraming_bytes = 6;  // overhead of a detection in a response
constexpr double kRoundingFrames = 1e-3;   // tolerance of steps, which are floats
constexpr std::array<Participant, 3> kParticipants = {Side::kWest, Side::kEast, std::nullopt};

}  // namespace

LockStep::LockStep(const PerSide<bool>& is_network, double frame_rate_hz)
    : rate_hz_(frame_rate_hz) {
  for (const Side side : kSides) member(side).takes_part = is_network[side];
  member(std::nullopt).takes_part = !is_network[Side::kWest] && !is_network[Side::kEast];
}

LockStep::Member& LockStep::member(const Participant& participant) {
  return members_.at(participant ? static_cast<std::size_t>(*participant) : 2);
}

bool LockStep::add(const Participant& from, league::SyncRequest request, Reply reply,
                   std::size_t longest_bytes) {
  {
    const std::lock_guard lock(mutex_);
    Member& sender = member(from);
    if (sender.waiting.size() == kMostWaitingRequests) return false;
    sender.waiting.push_back({std::move(request), std::move(reply), longest_bytes});
  }
  news_.notify_one();
  return true;
}

void LockStep::add_detection(const std::string& detection) {
  const std::lock_guard lock(mutex_);
  for (Member& one : members_) {
    if (!one.takes_part) continue;
    one.detections.push_back(detection);
    one.kept_bytes += detection.size() + kFraming_bytes;
    one.detections_bytes += detection.size() + kFraming_bytes;
    while (one.kept_bytes > kLongestResponse) drop_first_detection(one);
  }
}

void LockStep::drop_first_detection(Member& member) {
  member.kept_bytes -= member.detections.front().size() + kFraming_bytes;
  member.detections.pop_front();
}

std::int64_t LockStep::target(const Member& member) const {
  return std::llround(std::ceil(member.granted_s * rate_hz_ - kRoundingFrames));
}

// Leaves out the oldest detections if the response would become too long.
void LockStep::fit_detections(Member& member, std::int64_t frame, Waiting& done) const {
  const std::size_t room = done.longest_bytes - kReserved_bytes;
  if (member.detections_bytes <= room && member.kept_bytes == member.detections_bytes) return;
  while (member.kept_bytes > room) drop_first_detection(member);
  const auto frames = static_cast<double>(frame - member.answered);
  const double share = static_cast<double>(room) / static_cast<double>(member.detections_bytes);
  const double most_s = std::floor(0.9 * share * frames) / rate_hz_;
  done.request.commands.errors.push_back(
      {"STEP", fmt::format("the detections of {:.3f} s take {} bytes, but a response holds at "
                           "most {}; the oldest were left out; {}",
                           frames / rate_hz_, member.detections_bytes, room,
                           most_s > 0 ? fmt::format("ask for steps of at most {:.3f} s", most_s)
                                      : "connect with TCP, or use fewer cameras")});
}

void LockStep::answer(Member& member, std::int64_t frame, const std::bitset<kMaxRobots>& contact) {
  Waiting done = *std::exchange(member.current, std::nullopt);
  fit_detections(member, frame, done);
  done.reply(league::sync_response({member.detections.begin(), member.detections.end()},
                                   done.request.commands, contact));
  member.detections.clear();
  member.detections_bytes = member.kept_bytes = 0;
  member.answered = frame;
}

// The participant joins if its next request asks for a step.
void LockStep::let_join(Member& member, std::int64_t frame) const {
  if (member.takes_part || member.waiting.front().request.step_s <= 0) return;
  member.takes_part = true;
  member.granted_s = static_cast<double>(frame) / rate_hz_;
}

void LockStep::begin_next(const Participant& from, Member& member, CommandSlots& slots) {
  member.current = std::move(member.waiting.front());
  member.waiting.pop_front();
  member.granted_s += member.current->request.step_s;
  member.control.push_back(member.current->request.control);
  if (from) slots.add(*from, member.current->request.commands.updates);
}

// Answers and starts all requests that it can. Returns whether everybody has requested a later
// frame.
bool LockStep::settle(std::int64_t frame, const PerSide<RobotReports>& reports,
                      CommandSlots& slots) {
  bool is_ready = true;
  for (const Participant& from : kParticipants) {
    Member& one = member(from);
    const auto contact = from ? reports[*from].ball_contact : std::bitset<kMaxRobots>();
    if (one.current && target(one) <= frame) answer(one, frame, contact);
    // A request without a step is answered immediately.
    while (!one.current && !one.waiting.empty()) {
      let_join(one, frame);
      begin_next(from, one, slots);
      if (target(one) <= frame) answer(one, frame, contact);
    }
    is_ready = is_ready && (one.current.has_value() || !one.takes_part);
  }
  return is_ready;
}

bool LockStep::advance(std::int64_t frame, const PerSide<RobotReports>& reports,
                       CommandSlots& slots,
                       const std::function<void(const league::SimulatorRequest&)>& control,
                       Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  const auto has_news = [this] {
    return std::any_of(members_.begin(), members_.end(),
                       [](const Member& one) { return !one.current && !one.waiting.empty(); });
  };
  while (!settle(frame, reports, slots)) {
    if (!news_.wait_until(lock, deadline, has_news)) return false;
  }
  for (Member& one : members_) {
    for (const league::SimulatorRequest& request : one.control) control(request);
    one.control.clear();
  }
  return true;
}

PerSide<bool> LockStep::is_awaited() const {
  const std::lock_guard lock(mutex_);
  PerSide<bool> awaited;
  for (const Side side : kSides) {
    const Member& one = members_.at(static_cast<std::size_t>(side));
    awaited[side] = one.takes_part && !one.current;
  }
  return awaited;
}

}  // namespace autoref::live
