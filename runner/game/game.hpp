// The game loop: one refereed game from values to a record. Knows no files and no command line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "referee/decision.hpp"
#include "runner/game/play_counts/play_counts.hpp"
#include "runner/settings/configuration.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/team_requests.hpp"
#include "strategies/strategy.hpp"

namespace autoref::runner {

enum class EndReason : std::uint8_t { kTime, kGoals, kShootout, kForfeitA, kForfeitB, kVoid };
std::string_view name_of(EndReason reason);

enum class Status : std::uint8_t { kOk, kForfeit, kVoid };
std::string_view name_of(Status status);

struct GameRecord {
  int goals_a = 0;
  int goals_b = 0;
  std::vector<std::array<int, 2>> goals_by_half;  // [a, b] of each half
  std::optional<std::array<int, 2>> shootout;     // [a, b] goals of its kicks; none without one
  EndReason end_reason = EndReason::kTime;
  Status status = Status::kOk;
  std::string void_reason;                         // empty unless void
  std::array<int, referee::kEventCount> events{};  // how often each event occurred
  int count(referee::Event event) const { return events[static_cast<std::size_t>(event)]; }
  std::vector<std::string> transitions;  // labels of the transitions taken, each once
  std::array<PlayCounts, 2> counts{};    // [a, b]
  double ball_in_play_s = 0;
  double sim_s = 0;
  std::int64_t frames = 0;
  std::uint64_t state_hash = 0;  // over every frame's state and every decision
};

// The parts of one frame, in the order in which they come; the record is kept after the referee,
// too.
enum class Phase : std::uint8_t { kCamera, kReferee, kTeamWest, kTeamEast, kPhysics, kRecord };
inline constexpr int kPhaseCount = 6;

// Watches a game. All calls come from the game loop, in order.
class Observer {
 public:
  virtual ~Observer() = default;
  // A part of the frame has ended.
  virtual void on_phase(Phase /*ended*/) {}
  // Once per frame, before the referee: what it is asked for.
  virtual void on_requests(const PerSide<TeamRequests>& /*requests*/) {}
  // Once per frame, after the referee and before the teams.
  virtual void on_frame(const Frame& /*frame*/, const RefereeSignal& /*signal*/,
                        const sim::World& /*world*/) {}
  virtual void on_decision(const referee::Decision& /*decision*/) {}
};

// Makes the team of that name. Throws std::invalid_argument where there is none.
using TeamMaker = std::function<std::unique_ptr<strategies::Strategy>(
    const std::string& name, const strategies::TeamContext& context)>;

// The teams of strategies/registry.hpp.
std::unique_ptr<strategies::Strategy> make_registered_team(const std::string& name,
                                                           const strategies::TeamContext& context);

// Plays one game to its end. Throws std::invalid_argument for a configuration that no game can be
// made of (unknown strategy, rules or preset, numbers out of range). A strategy that throws or
// sends a number that is not finite makes the game void, not the call fail.
GameRecord play(const GameConfiguration& configuration, Observer* observer = nullptr,
                const TeamMaker& make_team = make_registered_team);

}  // namespace autoref::runner
