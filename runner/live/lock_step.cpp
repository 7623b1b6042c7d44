#include "runner/live/lock_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autoref::runner {
namespace {

constexpr std::size_t kMostWaitingRequests = 16;
constexpr std::size_t kMostDetections = 256;  // kept for a response
constexpr double kRoundingFrames = 1e-3;      // of steps, which are floats
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

void LockStep::add(const Participant& from, league::SyncRequest request, Reply reply) {
  {
    const std::lock_guard lock(mutex_);
    Member& sender = member(from);
    if (!from) sender.takes_part = true;
    if (!sender.takes_part || sender.waiting.size() == kMostWaitingRequests) return;
    sender.waiting.push_back({std::move(request), std::move(reply)});
  }
  news_.notify_one();
}

void LockStep::add_detection(const std::string& detection) {
  const std::lock_guard lock(mutex_);
  for (Member& one : members_) {
    if (one.takes_part && one.detections.size() < kMostDetections)
      one.detections.push_back(detection);
  }
}

std::int64_t LockStep::target(const Member& member) const {
  return std::llround(std::ceil(member.granted_s * rate_hz_ - kRoundingFrames));
}

void LockStep::answer(Member& member, const std::bitset<kMaxRobots>& contact) {
  const Waiting done = *std::exchange(member.current, std::nullopt);
  done.reply(league::sync_response(member.detections, done.request.commands, contact));
  member.detections.clear();
}

void LockStep::begin_next(const Participant& from, Member& member, CommandSlots& slots) {
  member.current = std::move(member.waiting.front());
  member.waiting.pop_front();
  member.granted_s += member.current->request.step_s;
  member.control.push_back(member.current->request.control);
  if (from) slots.add(*from, member.current->request.commands.updates);
}

// Answers and begins what can be; returns whether everybody has asked for a later frame.
bool LockStep::settle(std::int64_t frame, const PerSide<RobotReports>& reports,
                      CommandSlots& slots) {
  bool is_ready = true;
  for (const Participant& from : kParticipants) {
    Member& one = member(from);
    if (!one.takes_part) continue;
    const auto contact = from ? reports[*from].ball_contact : std::bitset<kMaxRobots>();
    if (one.current && target(one) <= frame) answer(one, contact);
    // A request that asks for no step is answered at once.
    while (!one.current && !one.waiting.empty()) {
      begin_next(from, one, slots);
      if (target(one) <= frame) answer(one, contact);
    }
    is_ready = is_ready && one.current.has_value();
  }
  return is_ready;
}

bool LockStep::advance(std::int64_t frame, const PerSide<RobotReports>& reports,
                       CommandSlots& slots,
                       const std::function<void(const league::SimulatorRequest&)>& control,
                       Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  const auto has_news = [this] {
    return std::any_of(members_.begin(), members_.end(), [](const Member& one) {
      return one.takes_part && !one.current && !one.waiting.empty();
    });
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

}  // namespace autoref::runner
