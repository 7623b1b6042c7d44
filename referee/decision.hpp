// What the referee decided, and why: one row of a game's event log.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// States of the paper's machine (section 4.3, figure 3), the end, and a team's timeout.
enum class State : std::uint8_t { kInit, kWaitStart, kWaitStop, kRun, kDelayWait, kOver, kTimeout };

// The paper's name, such as "WAIT_STOP".
std::string_view name_of(State state);

// What happened on the field or on the clock that made the referee act.
enum class Event : std::uint8_t {
  kBegin,         // the first frame
  kRobotsMoved,   // the clients are there
  kStartTimeout,  // they are not, and the wait is over
  kReady,         // robots and ball have come to rest
  kReadyTimeout,  // or the wait for that is over
  kGoal,
  kThrowIn,
  kCornerKick,
  kGoalKick,
  kTouchLineUnknown,  // out over a touch line, and nobody knows by whom
  kAttackerNearArea,
  kRestartNotTaken,
  kStuckBall,
  kSignalled,  // a briefly transmitted command has been sent
  kHalfOver,
  kGameOver,
  // Beyond the paper's rules. These stop play:
  kNoProgress,
  kKickSpeed,
  kChipGoal,
  kGoalInvalid,
  kIndirectGoal,
  kFreeKickOwnGoal,
  kDefenderInArea,
  kDefenderPartlyInArea,
  kAttackerInArea,
  kDoubleTouch,
  kRestartDistance,
  kDribbling,
  kKeeperHolding,
  kCrash,
  kPushing,
  kTooManyRobots,
  kKickoffPositions,
  kPenaltyPositions,
  kPenaltyFailed,
  kAimlessKick,
  kOffside,
  kGoalLineUnknown,  // out over a goal line, and nobody knows by whom; under the paper a goal kick
  // Noted while play goes on or is stopped already; where a book lets fouls go on, also
  // kRestartDistance, kCrash and kTooManyRobots:
  kCrashDrawn,
  kAttackerStaysNearArea,
  kStopSpeed,
  kStopDistance,
  kPlacementInterference,
  // Cards, timeouts and ends of games:
  kYellowCard,
  kRedCard,
  kCardOver,
  kTimeout,
  kTimeoutOver,
  kGoalLead,
  kExtraTime,
  kShootout,
  kShootoutOver,
};
inline constexpr int kEventCount = static_cast<int>(Event::kShootoutOver) + 1;

// A short name in snake_case, as in event logs and column heads: "throw_in".
std::string_view name_of(Event event);

// Whether the event is a call on play or on robots; these are the kinds that a game's row counts.
bool is_call(Event event);

enum class Card : std::uint8_t { kNone, kYellow, kRed };
std::string_view name_of(Card card);

// Who touched the ball last, as far as vision tells.
struct LastTouch {
  std::optional<Side> side;          // none: unknown
  std::optional<RobotId> robot;      // none: unknown, or one of several of that side
  double time_s = 0;                 // of the touch
  double gap_m = 0;                  // from the ball's surface to that robot's hull at that time
  double speed_change_mps = 0;       // of the ball, beyond what the carpet explains
  std::optional<RobotId> runner_up;  // the next best candidate
};

using ConcernedRobots = boost::container::static_vector<RobotId, 4>;

struct Decision {
  std::int64_t frame = 0;
  double time_s = 0;
  std::string_view transition;  // label of the machine's transition, see referee/README.md
  State from = State::kInit;
  State to = State::kInit;
  std::optional<Command> command;  // sent with this decision; none where nothing was sent
  Event event = Event::kBegin;
  std::string_view rule;  // what it rests on, such as "paper 4.2"
  double value = 0;       // measured, in the threshold's unit
  double threshold = 0;
  std::string_view unit;  // of value and threshold; empty where nothing was measured
  ConcernedRobots robots;
  std::optional<Side> offender;    // the side at fault; none where nobody or both are
  Card card = Card::kNone;         // shown to the offender
  std::optional<Vec2> position_m;  // where it happened
  std::optional<Command> restart;  // what play goes on with
  LastTouch last_touch;
  std::string evidence;  // one sentence for people
};

}  // namespace autoref::referee
