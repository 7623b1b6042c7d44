// What a team did in a game, in the figures that people know from football.
//
// They are told from the true world and the referee's signals, as somebody on the stands would tell
// them who sees everything and knows nobody's plans. Play is on from a restart's signal until the
// referee ends it, so that the restart's own kick counts; a shoot-out is no part of it.
//
// A *kick away* is a fired kicker whose ball leaves the robot at kAway_mps or more and gets kAway_m
// far. It is judged once, by what becomes of it: when another robot touches the ball, a goal is
// given, or play stops. If the kicker touches the ball again first (later than kSameKick_s), it was
// a push ahead and counts for nothing. So do kicks of both teams in the same sub-step. "Its way" is
// the straight one that the ball would roll or fly from the kick on if nobody met it
// (ball_trajectory.hpp).
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "soccer/units.hpp"

namespace autoref::runner {

// Relative to the robot, which only nudges a slower ball ahead of itself.
inline constexpr double kAway_mps = 1.0_mps;
// A ball that somebody else meets earlier was kicked against a robot already there: a duel.
inline constexpr double kAway_m = 200_mm;
// A kicker needs 100 ms for its next kick; until then the hull may still meet the leaving ball.
inline constexpr double kSameKick_s = 100_ms;

// A shot may miss a post by so much: more than kickers' noise (1.5 degrees from 6 m: 160 mm).
inline constexpr double kShotMiss_m = 250_mm;
// Where a shot or pass gets to. A slower ball was pushed ahead, and is anybody's.
inline constexpr double kArrival_mps = 1.0_mps;
// From the own third of the field a kick at the goal is a clearance.
inline constexpr double kClearanceShare = 1.0 / 3.0;

// Nearer mates stand beside the kicker, and every kick's way begins near them.
inline constexpr double kShortestPass_m = 500_mm;
// A pass may lead so far past where a mate is now: that is one step aside for the mate.
inline constexpr double kPassMiss_m = 500_mm;
// And farther where the ball gives it time. From rest at 3 m/s^2 that is the mean speed of the
// first 0.67 s.
inline constexpr double kMate_mps = 1.0_mps;
// But not farther than this: anybody reaches any ball in the end.
inline constexpr double kFarthestMate_m = 1.0_m;

// From hulls to the ball's surface. Less than its diameter and a bit: nobody fits in between.
inline constexpr double kDuel_m = 50_mm;
inline constexpr double kDuelBegins_s = 100_ms;  // for so long at once
// The loser is out of it: from robots' full discs, more than a robot is wide (0.18 m), and a bit.
inline constexpr double kDuelOver_m = 300_mm;
inline constexpr double kLongestDuel_s = 3.0_s;  // then nobody has won it

struct PlayCounts {
  // Kicks away from outside the own third of the field whose way crosses the opponents' goal line
  // at kArrival_mps or faster, at most kShotMiss_m outside the posts, at whatever height. Not
  // those that a team-mate touches next, if they are passes by the definition below. And every
  // goal that the team's own touch made is a shot, however it came.
  int shots = 0;
  // Those of them that became a goal, and those whose way led between the posts and under the bar
  // and that an opponent touched next: saved or blocked.
  int shots_on_goal = 0;
  // Kicks away, other than shots, with a team-mate that may meet them: at the point of their way
  // nearest to it, at least kShortestPass_m from the kick and not in a chip's first flight, the
  // ball is no slower than kArrival_mps, and the mate at most kPassMiss_m away, or as far as it
  // comes at kMate_mps in the ball's time, up to kFarthestMate_m. Their way ends where the ball
  // stops or leaves the field.
  int passes_tried = 0;
  // Those of them that a team-mate touches next, and no opponent in the same sub-step.
  int passes_completed = 0;
  // Of the ball's time in play (GameRecord::ball_in_play_s): from a touch of this team until one of
  // the other. Where both touch it in the same sub-step, it stays with who had it.
  double possession_s = 0;
  // Calls for what robots of the team did wrong, in play or while it was stopped: one for each
  // team where both are at fault. Not exits, aimless kicks, goals that do not count, restarts not
  // taken, penalties that failed.
  int fouls = 0;
  // A duel begins when robots of both teams have been within kDuel_m of the ball for kDuelBegins_s.
  // It is won by who touches the ball once all opponents are farther from it than kDuelOver_m, or
  // whose kick away has brought it so far; by nobody if play stops first, or after kLongestDuel_s.
  int duels_won = 0;
  bool operator==(const PlayCounts&) const = default;
};

// A count's name, such as "shots", and the member that holds it: one of the two.
struct CountField {
  std::string_view name;
  int PlayCounts::*count = nullptr;
  double PlayCounts::*seconds = nullptr;
};

// Every member of PlayCounts, in the order in which rows and JSON have them.
std::span<const CountField> count_fields();

}  // namespace autoref::runner
