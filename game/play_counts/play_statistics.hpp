// Updates the play counts (play_counts.hpp) of a running game, and finds out which teams win its
// duels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "game/play_counts/ball_actions.hpp"
#include "game/play_counts/chance.hpp"
#include "game/play_counts/kick_away.hpp"
#include "game/play_counts/play_counts.hpp"
#include "game/play_counts/possession_chains.hpp"
#include "game/play_counts/situation_value.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// Detects who wins duels for the ball, as defined in play_counts.hpp.
class Duels {
 public:
  explicit Duels(double frame_rate_hz);

  // Processes a frame of play. `touched`: the sides that touched the ball; `kicked`: the side whose
  // kick is in progress. Returns the winner if a duel has just been won.
  std::optional<Side> update(const sim::WorldState& now, const PerSide<bool>& touched,
                             std::optional<Side> kicked);
  void stop();  // call when play has stopped

  // How close a side's nearest robot is to the ball.
  struct Nearness {
    bool is_at_ball = false;  // within kDuel_m of the ball
    bool is_in_it = false;    // within kDuelOver_m of the ball
  };
  static Nearness nearness(const sim::WorldState& now, Side side);

 private:
  void await(bool both_at_ball);

  enum class Stage { kNone, kOn, kDrawn };  // a duel stays kDrawn until the robots separate

  int begin_frames_;
  int most_frames_;
  Stage stage_ = Stage::kNone;
  int frames_ = 0;  // number of frames since both sides reached the ball, or since the duel began
};

// Owns the state of the current kick, duel and possession. The game loop calls update() once per
// frame. Does not affect the game, and allocates only when a shot or a possession
// chain ends.
class PlayStatistics {
 public:
  // The state of the game in a frame, after the referee's update.
  struct FrameSummary {
    const sim::WorldState& now;
    std::span<const sim::Touch> touches;             // touches in the last step
    std::span<const referee::Decision> decisions{};  // decisions in this frame
    bool is_play_on = false;  // whether play is on after this frame (referee::State::kRun)
    bool is_ball_in_play = false;
  };

  // The models must outlive this object.
  PlayStatistics(const Field& field, const sim::BallParameters& ball, double frame_rate_hz,
                 const ChanceModel& chances, const ValueModel& values);

  void update(const FrameSummary& summary);

  // A game controller gave a command; decisions of the game's own referee contain theirs.
  void note_command(const Command& command) { chains_.prepare_restart(command); }

  // The counts so far, excluding a kick and a possession chain in progress.
  PerSide<PlayCounts> counts() const;

  // Who has the ball, or will take the next restart; nullopt if this is not known.
  std::optional<BallOwner> ball_owner() const;

  // The possession chains that ended in the last frame, and their shots; valid until the next
  // update.
  std::span<const PossessionChain> ended_chains() const { return chains_.ended(); }
  std::span<const Shot> ended_shots() const { return chains_.ended_shots(); }
  // The actions that ended in the last frame; valid until the next update.
  std::span<const BallAction> ended_actions() const { return actions_.ended(); }

 private:
  // Simultaneous touches: all kicks of a sub-step, or all hull contacts in it.
  struct TouchGroup;
  enum class Next : std::uint8_t { kMate, kOpponent, kGoal, kStop };

  void touch(const FrameSummary& summary);
  void touch(const TouchGroup& group, const sim::WorldState& now);
  ChainStart gained_by(const TouchGroup& group, const sim::WorldState& now) const;
  void meet(const TouchGroup& group);
  void settle(Next next);
  Shot shot_of(const KickAway& kick) const;
  void count_shot(const Shot& shot);
  void note(const referee::Decision& decision, const sim::WorldState& now);
  void give_goal(Side scorer, const sim::WorldState& now);
  void end_play(const sim::WorldState& now);
  void note_call(const referee::Decision& decision, const BallActions::Owners& owners,
                 const sim::WorldState& now);
  std::optional<BallOwner> next_kicker() const;
  void discard_kick();
  void count_chains();
  void count_actions();

  Field field_;
  sim::BallParameters ball_;
  const ChanceModel* chances_;
  double frame_rate_hz_;
  std::int64_t same_kick_frames_;
  Duels duels_;
  PossessionChains chains_;
  BallActions actions_;
  bool is_on_ = false;              // whether play was on before this frame
  std::optional<KickAway> kick_;    // kick in progress
  std::optional<Side> last_touch_;  // side that touched the ball last since play started
  PerSide<PlayCounts> counts_;
  PerSide<std::int64_t> possession_frames_;
};

}  // namespace autoref::game
