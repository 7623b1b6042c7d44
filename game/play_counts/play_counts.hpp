// A team's statistics in a game, as in football: shots, passes, possession and so on.
//
// The statistics are based on ground truth and the referee's signals and cannot see intentions.
// Play lasts from a restart's signal until the referee stops it, so the kick that takes the restart
// counts. Touches of a ball that is entirely behind a goal line do not count, and shoot-outs do not
// count.
//
// A kick counts only if the ball leaves the robot at kAway_mps or more and then travels at least
// kAway_m. It is classified once, when another robot touches the ball, a goal is given or play
// stops. If the kicker touches the ball first (later than kSameKick_s after the kick), it has only
// pushed the ball ahead, and the kick does not count. Kicks by both teams in the same sub-step do
// not count either. A kick's path is the straight line along which the ball would roll or fly if
// nobody touched it (kick_away.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "game/play_counts/ball_actions.hpp"
#include "game/play_counts/possession_chains.hpp"
#include "soccer/named.hpp"
#include "soccer/units.hpp"

namespace autoref::game {

// Minimum speed of a kicked ball relative to the robot. A slower ball is only nudged ahead.
inline constexpr double kAway_mps = 1.0_mps;
// Minimum distance that a kicked ball travels. If another robot touches it earlier, the ball was
// kicked against that robot in a duel.
inline constexpr double kAway_m = 200_mm;
// The time after a kick in which the kicker's touches belong to that kick. A kicker needs 100 ms
// before its next kick; until then, the hull may still touch the departing ball.
inline constexpr double kSameKick_s = 100_ms;

// How far a shot may pass outside a post: more than the kicker's noise accounts for (1.5 degrees
// from 6 m: 160 mm).
inline constexpr double kShotMiss_m = 250_mm;
// Minimum speed on arrival of a shot or pass. A slower ball was pushed ahead and is a loose ball.
inline constexpr double kArrival_mps = 1.0_mps;
// The share of the field in which a kick at the goal is a clearance: the team's own third.
inline constexpr double kClearanceShare = 1.0 / 3.0;

// Minimum distance from the kick to a team-mate that it can reach as a pass. Nearer team-mates are
// next to the kicker, so the path of every kick starts near them.
inline constexpr double kShortestPass_m = 500_mm;
// How far a pass may miss a team-mate's current position; the team-mate can easily move that far.
inline constexpr double kPassMiss_m = 500_mm;
// Mean speed at which a team-mate moves towards the ball's path, so that it gets farther if the
// ball takes longer. The value is the mean speed over the first 0.67 s when accelerating from rest
// at 3 m/s^2.
inline constexpr double kMate_mps = 1.0_mps;
// Upper limit of the distance that a team-mate moves to receive a pass: given enough time, any
// robot can reach any ball.
inline constexpr double kFarthestMate_m = 1.0_m;

// Maximum distance from a robot's hull to the ball's surface in a duel: slightly more than the
// ball's diameter, so nothing else fits in between.
inline constexpr double kDuel_m = 50_mm;
inline constexpr double kDuelBegins_s = 100_ms;  // how long both sides must be within kDuel_m
// Distance from the ball to the loser's disc at which a duel is over: more than a robot's width
// (0.18 m).
inline constexpr double kDuelOver_m = 300_mm;
inline constexpr double kLongestDuel_s = 3.0_s;  // longer duels are drawn

// Counts of a team's possession chains, for example of those that began in the same way.
struct ChainCounts {
  int chains = 0;
  int shots = 0;
  int goals = 0;
  double xg = 0;  // expected goals of the shots: the sum of their chances (Shot::chance)
  bool operator==(const ChainCounts&) const = default;
};

// Counts of a team's actions of one kind (ball_actions.hpp), except those in progress.
struct ActionCounts {
  int actions = 0;
  double worth = 0;  // sum of what they were worth, in goals
  bool operator==(const ActionCounts&) const = default;
};

struct PlayCounts {
  // Kicks taken outside the team's own third of the field, with a path that crosses the opponents'
  // goal line at kArrival_mps or faster at any height, and at most kShotMiss_m outside the posts.
  // Excludes passes (see passes_tried) that a team-mate touches next. Every other goal from the
  // team's own touch also counts as a shot.
  int shots = 0;
  // Shots that became goals, and shots that were saved or blocked. A shot is saved or blocked if
  // its path leads between the posts and under the bar and an opponent touches the ball next.
  int shots_on_goal = 0;
  // Kicks, other than shots, that a team-mate can reach. At the point of the path nearest to the
  // team-mate (at least kShortestPass_m from the kick and not in a chip's first flight), the ball
  // must be at least as fast as kArrival_mps. The team-mate may be at most kPassMiss_m from the
  // path, or as far as it can move at kMate_mps until the ball arrives, up to kFarthestMate_m. The
  // path ends where the ball stops or leaves the field.
  int passes_tried = 0;
  // Passes that a team-mate touches next, without an opponent in the same sub-step.
  int passes_completed = 0;
  // Time for which the ball is in play (GameRecord::ball_in_play_s) from this team's touch until
  // the other team's next one. If both touch it in the same sub-step, possession does not change.
  double possession_s = 0;
  // Fouls called against the team's robots, during play or while it is stopped. If both teams are
  // at fault, each gets one. Excludes balls that leave the field, aimless kicks, disallowed goals,
  // restarts not taken and failed penalties.
  int fouls = 0;
  // A duel begins when robots of both teams have been within kDuel_m of the ball for kDuelBegins_s.
  // A team wins it by touching the ball, or by its kick in progress, once all opponents are farther
  // from it than kDuelOver_m. Nobody wins a duel if play stops first or if it takes longer than
  // kLongestDuel_s.
  int duels_won = 0;
  // The team's possession chains by the way in which they began (ChainStart), once they have ended.
  // Their shots are all the team's shots, and their goals are all its goals except the opponents'
  // own goals.
  std::array<ChainCounts, kChainStartCount> by_start{};
  std::array<ActionCounts, kActionKindCount> by_action{};  // by ActionKind
  ChainCounts with_pass{};  // of the chains with at least one completed pass
  int own_goals = 0;        // goals against the team that ended one of its own chains
  // Expected goals: the sum of the chances of the team's shots, not knowing where they are aimed.
  double xg = 0;
  // Expected goals on target: the same, knowing the shots' paths (Shot::chance_on_target).
  double xgot = 0;
  bool operator==(const PlayCounts&) const = default;
};

// A count's name, such as "shots", and its member; the other member pointer is null.
template <typename Counts>
struct CountField {
  std::string_view name;
  int Counts::*count = nullptr;
  double Counts::*number = nullptr;
};

// Every member of PlayCounts that is a number, in the order used in rows and JSON.
inline std::span<const CountField<PlayCounts>> count_fields() {
  using Field = CountField<PlayCounts>;
  static constexpr std::array kFields = {
      Field{"shots", &PlayCounts::shots},
      Field{"shots_on_goal", &PlayCounts::shots_on_goal},
      Field{"passes_tried", &PlayCounts::passes_tried},
      Field{"passes_completed", &PlayCounts::passes_completed},
      Field{"possession_s", nullptr, &PlayCounts::possession_s},
      Field{"fouls", &PlayCounts::fouls},
      Field{"duels_won", &PlayCounts::duels_won},
      Field{"own_goals", &PlayCounts::own_goals},
      Field{"xg", nullptr, &PlayCounts::xg},
      Field{"xgot", nullptr, &PlayCounts::xgot},
  };
  return kFields;
}

// Every member of ChainCounts.
inline std::span<const CountField<ChainCounts>> chain_count_fields() {
  using Field = CountField<ChainCounts>;
  static constexpr std::array kFields = {
      Field{"chains", &ChainCounts::chains}, Field{"shots", &ChainCounts::shots},
      Field{"goals", &ChainCounts::goals}, Field{"xg", nullptr, &ChainCounts::xg}};
  return kFields;
}

// Every member of ActionCounts.
inline std::span<const CountField<ActionCounts>> action_count_fields() {
  using Field = CountField<ActionCounts>;
  static constexpr std::array kFields = {Field{"actions", &ActionCounts::actions},
                                         Field{"worth", nullptr, &ActionCounts::worth}};
  return kFields;
}

// The counts of a team, which may be const, for one kind of action.
auto& counts_of(auto& team, ActionKind kind) {
  return team.by_action[static_cast<std::size_t>(kind)];
}

// A group of possession chains: those that began in one way, or those with a pass.
struct ChainGroup {
  std::string_view name;            // such as "corner_kick"; "with_pass"
  std::optional<ChainStart> start;  // nullopt: chains with a pass

  // The counts of a team, which may be const.
  auto& of(auto& team) const {
    return start ? team.by_start[static_cast<std::size_t>(*start)] : team.with_pass;
  }
};

// All groups, in the order used in rows and JSON.
inline std::span<const ChainGroup> chain_groups() {
  static const std::array kGroups = [] {
    std::array<ChainGroup, kChainStartCount + 1> groups{};
    std::size_t next = 0;
    for (const Named<ChainStart>& start : names_of(ChainStart{}))
      groups[next++] = {start.name, start.value};
    groups[next] = {"with_pass", std::nullopt};
    return groups;
  }();
  return kGroups;
}

}  // namespace autoref::game
