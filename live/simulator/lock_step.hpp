// Lock-step with programs on the network: the game continues when all programs have requested the
// next step.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "league/simulator/sync_request.hpp"
#include "live/simulator/command_slots.hpp"
#include "live/simulator/robot_reports.hpp"
#include "soccer/side.hpp"

namespace autoref::live {

// The sender of a request: a team, or a program at the control port (nullopt).
using Participant = std::optional<Side>;

class LockStep {
 public:
  using Clock = std::chrono::steady_clock;
  using Reply = std::function<void(std::string bytes)>;

  // Teams in `is_network` take part from the beginning, and the control port from its first request
  // for a step. Until then, requests at the control port are answered without detections.
  LockStep(const PerSide<bool>& is_network, double frame_rate_hz);

  // Called in the network's thread: accepts a request. `reply` will be called in the game's thread
  // with a response of at most `longest_bytes`. Returns false if 64 requests of the participant are
  // already waiting.
  bool add(const Participant& from, league::SyncRequest request, Reply reply,
           std::size_t longest_bytes);

  // Adds a camera's detections to the next responses. If the detections since a participant's last
  // response do not all fit into the next one, the oldest are left out, and an error in the
  // response says how long the participant's steps may be.
  void add_detection(const std::string& detection);

  // Answers every request that is completed by `frame`, applies the commands of the next requests,
  // and waits until all participants have requested a later frame. Returns false if the deadline
  // passes first. `control` receives the requests to the simulator.
  bool advance(std::int64_t frame, const PerSide<RobotReports>& reports, CommandSlots& slots,
               const std::function<void(const league::SimulatorRequest&)>& control,
               Clock::time_point deadline);

  // The teams that have not requested a later frame.
  PerSide<bool> is_awaited() const;

 private:
  struct Waiting {
    league::SyncRequest request;
    Reply reply;
    std::size_t longest_bytes = 0;
  };
  struct Member {
    bool takes_part = false;
    double granted_s = 0;  // time until which the participant lets the game continue
    std::deque<Waiting> waiting;
    std::optional<Waiting> current;  // answered when its frame is reached
    // Detections since the last response, or the newest of them.
    std::deque<std::string> detections;
    std::size_t detections_bytes = 0;  // size of all detections since the last response
    std::size_t kept_bytes = 0;
    std::int64_t answered = 0;  // frame of the last response
    // Requests to the simulator since the last frame.
    std::vector<league::SimulatorRequest> control{};
  };

  Member& member(const Participant& participant);
  std::int64_t target(const Member& member) const;
  static void drop_first_detection(Member& member);
  void let_join(Member& member, std::int64_t frame) const;
  void fit_detections(Member& member, std::int64_t frame, Waiting& done) const;
  void answer(Member& member, std::int64_t frame, const std::bitset<kMaxRobots>& contact);
  void begin_next(const Participant& from, Member& member, CommandSlots& slots);
  bool settle(std::int64_t frame, const PerSide<RobotReports>& reports, CommandSlots& slots);

  double rate_hz_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::array<Member, 3> members_;  // west, east, control
};

}  // namespace autoref::live
