// AutoRef: the paper's referee, which turns vision frames into referee commands.
//
// It owns the state of the game: score, stage, clock, next restart and last touch. It sees only
// vision frames, the tracks made from them, and the teams' requests ("operates based solely on
// vision information", paper, section 4.1), takes the time from the frames, and draws no random
// numbers. The tracker belongs to whoever runs the game, because the teams and the network also use
// its tracks. In each frame, call:
//
//   const Referee::View view = referee.see(frame);
//   if (view.tracks_begin_afresh) tracker.begin_afresh();
//   const RefereeSignal& signal = referee.judge(tracker.update(view.frame), requests);
//
// If you only have frames, use AutoRef: frame in, signal out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "referee/decision.hpp"
#include "referee/referee_configuration.hpp"
#include "referee/state.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

class Referee {
 public:
  // Throws std::invalid_argument if a length or time is not positive (a break may be 0 s) or a
  // count is out of range.
  explicit Referee(const Configuration& configuration);
  ~Referee();
  Referee(Referee&&) noexcept;
  Referee& operator=(Referee&&) noexcept;

  // Starts the game in the middle of a half instead of with the first kick-off. Call begin() before
  // the first frame, and only if the configuration has Control::kAutoref (asserted). Throws
  // std::invalid_argument if the game has no half of that signal's stage.
  void begin(const MidwayStart& midway_start);

  // A frame as the referee sees it. Update the tracker with this frame.
  struct View {
    const Frame& frame;  // valid until judge(), which completes it
    // After a gap of more than a second, tracks and touches start again from nothing. The last
    // touch stays known, with less confidence, if the ball's path shows that nobody has touched it
    // since, or that it comes from the robot that had it before the gap (touch/kept_touch.hpp).
    bool tracks_begin_afresh = false;
  };

  // Takes the next frame. Frames must be in order. Robots and ball may be missing. Objects with
  // non-finite numbers count as unseen, and if AutoRef does not command the game, so does a ball
  // that is suddenly farther away than any ball can fly (touch/sight.hpp).
  View see(const Frame& frame);

  // Judges the frame given to see(), and returns the signal now in force. Call it once after each
  // see(), with tracks made from the frame in its view. A robot that is missing from the frame is
  // judged at its tracked position.
  const RefereeSignal& judge(const Tracks& tracks, const PerSide<TeamRequests>& requests);

  // Records a signal from the person who commands the game. Unless Control::kHuman is set, it takes
  // from the signal only which end each team defends. Call it after the last frame that was
  // captured before the signal; repeated signals are harmless. A new command adds a decision to
  // those made in that frame. Its `command_time_s` is on the frames' clock and matters only if the
  // command is older than the first frame. Signals before the first frame take effect after it.
  void follow(const RefereeSignal& given);

  // The decisions made in the last frame and for signals received since, in order; usually empty.
  std::span<const Decision> decisions() const;

  // The last frame as it was judged: without impossible objects, and completed by the tracks.
  const Frame& frame() const;
  // The last touch in the current play, as the online detector estimates it in this frame
  // (touch/online_touch_detector.hpp).
  const LastTouch& last_touch() const;
  State state() const;
  bool is_ball_in_play() const;
  // Whether the last half is over and `after_game` is kHalt, so no further command will follow.
  bool is_over() const;
  // Goals of each half so far, including the running one.
  std::span<const PerSide<int>> goals_by_half() const;
  // Goals scored in the shoot-out so far; nullopt if there has been none.
  std::optional<PerSide<int>> shootout_goals() const;
  // Games finished so far, for AfterGame::kNewGame.
  int games_finished() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// A referee with a tracker of its own.
class AutoRef final : public Referee {
 public:
  // Takes the same arguments, and throws the same exceptions, as Referee.
  explicit AutoRef(const Configuration& configuration)
      : Referee(configuration), tracker_(configuration.noise) {}

  // Judges one frame and returns the signal now in force; see Referee::see() for the frames.
  const RefereeSignal& update(const Frame& frame, const PerSide<TeamRequests>& requests) {
    const View view = see(frame);
    if (view.tracks_begin_afresh) tracker_.begin_afresh();
    return judge(tracker_.update(view.frame), requests);
  }

  // The tracked robots and ball after the last update. Referees in the league also publish the
  // objects they track.
  const Tracks& tracks() const { return tracker_.tracks(); }

 private:
  using Referee::judge;
  using Referee::see;

  tracking::Tracker tracker_;
};

}  // namespace autoref::referee
