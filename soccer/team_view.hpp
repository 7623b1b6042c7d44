// The game as one team sees it, and what the referee's commands mean for play.
//
// Every team sees its own goal at -x and +y to its left, whichever side it plays on; only this code
// rotates the view.
#pragma once

#include <cstdint>
#include <optional>

#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref {

// What the referee's commands mean for play, that is, who may do what at the moment. There is no
// play during halt and stop. A prepared restart waits for the start command; a restart lasts until
// the ball is in play.
enum class Play : std::uint8_t {
  kHalt,
  kStop,
  kPrepareKickoff,
  kPreparePenalty,
  kKickoff,
  kPenalty,
  kDirectFree,
  kIndirectFree,
  kRunning,
};

// The names, in the style of the league's commands.
constexpr auto names_of(Play /*any*/) {
  return std::to_array<Named<Play>>({{Play::kHalt, "HALT"},
                                     {Play::kStop, "STOP"},
                                     {Play::kPrepareKickoff, "PREPARE_KICKOFF"},
                                     {Play::kPreparePenalty, "PREPARE_PENALTY"},
                                     {Play::kKickoff, "KICKOFF"},
                                     {Play::kPenalty, "PENALTY"},
                                     {Play::kDirectFree, "DIRECT_FREE"},
                                     {Play::kIndirectFree, "INDIRECT_FREE"},
                                     {Play::kRunning, "RUNNING"}});
}

// `side` is the side that takes the restart; it is not used in halt, stop and running play. While a
// side's robots place the ball, `play` is kStop and `placer` is that side.
struct Situation {
  Play play = Play::kHalt;
  Side side = Side::kWest;
  std::optional<Side> placer{};
};

constexpr bool is_restart(Play play) { return play >= Play::kKickoff && play < Play::kRunning; }

// Derives the situation from the commands and the ball. Call update() once per frame with the
// signal and the ball (nullopt until it has been seen).
class SituationTracker {
 public:
  explicit SituationTracker(const RuleBook& rules) : in_play_m_(rules.in_play_m) {}

  Situation update(const RefereeSignal& signal, const std::optional<Vec2>& ball_m);

 private:
  void obey(const Command& command);

  double in_play_m_;
  Situation situation_;
  std::uint32_t obeyed_counter_ = 0;
  std::optional<Vec2> restart_from_m_;  // the ball's position when the restart was allowed
};

struct TeamView {
  std::int64_t frame = 0;  // number of the camera frame behind this view
  double time_s = 0;       // capture time of that frame
  double latency_s = 0;    // the team's estimate of the time from a frame until its command moves a
                           // robot
  TrackedRobots own;
  TrackedRobots opponents;
  TrackedBall ball;
  Play play = Play::kHalt;
  bool ours = false;  // whether the current restart is this team's
  // Where the referee places the ball for the next restart; set only while play is stopped.
  std::optional<Vec2> placement_m;
  // Set only while a team's robots place the ball at `placement_m`: whether they are this team's
  // robots. The placing team brings the ball there, and the other team keeps clear of its path.
  std::optional<bool> placing_is_ours;
  // The restart after this stop, if known, and whether it is this team's.
  std::optional<CommandKind> next;
  bool next_is_ours = false;
  int goals_own = 0;
  int goals_opponent = 0;
  double stage_time_left_s = 0;
};

// Fills `view` with `tracks` and `signal`, which are in field coordinates, as seen by the team on
// `side`. Allocates nothing.
void fill_view(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
               Side side, TeamView& view);

}  // namespace autoref
