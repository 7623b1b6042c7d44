// Play counts and possession chains of a recorded game, from vision alone.
//
// game::PlayStatistics gets the world as the tracks estimate it, the touches that the referee's
// detector reports (track_touches.hpp), and the recorded referee's decisions:
//
// - If referee packets command the game (Control::kHuman), play lasts from the recorded command
//   that starts it until the one that stops it. Goals are those by which the score in the packets
//   has grown when play starts again. If AutoRef made a call before the recorded stop that it did
//   not withdraw, that call is the reason of the stop; otherwise the reason is unknown. Touches
//   after AutoRef has called an exit or a goal do not count.
// - If nobody commands it (Control::kNone), play is always on. AutoRef's own calls end a chain,
// also
//   goals, and the next touch on the field begins another one.
// - If AutoRef commands it, its own decisions count, as in a simulated game.
//
// The game is sampled at kRate_hz, so that frames mean the same as in a simulated game. Shoot-outs
// do not count.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "game/play_counts/play_statistics.hpp"
#include "logs/track_touches.hpp"
#include "referee/referee_configuration.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::logs {

class LogReferee;

// A shot or an action, and which end blue defended then (soccer/referee_signal.hpp).
struct RecordedShot {
  game::Shot shot;
  bool blue_on_positive_half = true;
};
struct RecordedAction {
  game::BallAction action;
  bool blue_on_positive_half = true;
};

// What happened in play. Frame numbers are times in units of 1 / RecordedPlay::kRate_hz; positions
// are the program's, in which yellow is west.
struct PlayOfLog {
  std::vector<game::PossessionChain> chains;
  std::vector<RecordedShot> shots;
  std::vector<RecordedAction> actions;
  PerSide<game::PlayCounts> counts;
  double ball_in_play_s = 0;
};

class RecordedPlay {
 public:
  static constexpr double kRate_hz = 60;
  // Further chains, shots and actions are counted, but not kept.
  static constexpr std::size_t kMostKept = 100'000;

  // The rule book must have models of chances and situations (game/play_counts/).
  explicit RecordedPlay(const referee::Configuration& configuration);

  // Takes a frame that the referee has judged.
  void add(const LogReferee& referee);

  // Ends the play in progress. Returns what happened so far; call it after the last frame.
  PlayOfLog finish();

 private:
  struct JudgedFrame {
    TrackedFrame tracked;
    std::vector<referee::Decision> decisions;
    RefereeSignal signal;
    bool is_play_on = false;
    bool is_ball_in_play = false;
    bool is_turned = false;
  };

  // The end of a play, until its reason is known: whether it was a goal.
  struct Stop {
    sim::WorldState world;
    bool is_turned = false;  // teams may change ends before the reason is known
    referee::Finding reason;
  };

  void process_oldest();
  void process(const JudgedFrame& frame, const std::vector<sim::Touch>& touches);
  void process_official(const JudgedFrame& frame, const std::vector<sim::Touch>& touches);
  void process_followed(const JudgedFrame& frame, const std::vector<sim::Touch>& touches);
  void process_alone(const JudgedFrame& frame, const std::vector<sim::Touch>& touches);
  void note_own_decision(const referee::Decision& decision, const sim::WorldState& world);
  void note_command(const referee::Decision& decision, const JudgedFrame& frame);
  void start(const PerSide<int>& goals);
  void stop(const referee::Finding& reason);
  void settle_stop(const PerSide<int>& goals);
  void bridge_gap(std::int64_t frame, const PerSide<int>& goals);
  void update(const std::vector<sim::Touch>& touches,
              const std::vector<referee::Decision>& decisions, bool is_play_on);

  referee::Control control_;
  Field field_;
  game::PlayStatistics statistics_;
  TrackTouches touches_;
  std::deque<JudgedFrame> waiting_;
  std::optional<TrackedFrame> before_;  // the last frame processed
  std::vector<sim::Touch> held_over_;   // touches in frames that were skipped
  PlayOfLog play_;
  std::int64_t frames_in_play_ = 0;

  sim::WorldState world_;    // the last world given to the statistics
  bool is_on_ = false;       // whether play was on then
  bool is_in_play_ = false;  // whether the ball was in play
  bool is_turned_ = false;
  PerSide<int> goals_;  // the score when play started
  std::optional<Stop> stop_;
  std::optional<Command> restart_;                // the restart announced during a stop
  std::vector<referee::Decision> calls_in_stop_;  // AutoRef's, given when play starts
  std::optional<referee::Finding> call_;  // AutoRef's call that waits for the recorded referee
  bool is_dead_ = false;                  // whether the ball has been called out of the field
};

}  // namespace autoref::logs
