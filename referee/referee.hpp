// AutoRef: the referee of the paper, from vision frames to referee commands.
//
// It owns the state of the game: score, stage, clock, the next restart, the last touch. It sees
// nothing but vision frames and the teams' requests ("operates based solely on vision
// information", paper, section 4.1), keeps time by the frames, and draws no random numbers. The
// game loop calls it once per frame.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "referee/configuration.hpp"
#include "referee/decision.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

class Referee {
 public:
  // Throws std::invalid_argument for lengths or times that are not positive (a break may be 0 s)
  // and for counts out of range.
  explicit Referee(const Configuration& configuration);
  ~Referee();
  Referee(Referee&&) noexcept;
  Referee& operator=(Referee&&) noexcept;

  // Judges one frame and says what is in force from now on. Frames come in order. Robots and ball
  // may be missing from a frame, or always; a robot not seen for less than half a second counts as
  // where it was going. Numbers that are not finite count as not seen.
  const RefereeSignal& update(const Frame& frame, const PerSide<TeamRequests>& requests);

  // The field as of the last update: what the referee makes of the frames. The league's referees
  // send their tracks to the teams, too.
  const Tracks& tracks() const;

  // The decisions taken at the last update, in order; empty for most frames.
  std::span<const Decision> decisions() const;

  State state() const;
  bool is_ball_in_play() const;
  // Whether the last half is over and `after_game` is kHalt: no further command will come.
  bool is_over() const;
  // Goals of each half so far, the running one included.
  std::span<const PerSide<int>> goals_by_half() const;
  // Goals of the shoot-out's kicks so far; none where there has been none.
  std::optional<PerSide<int>> shootout_goals() const;
  // Games finished so far, for AfterGame::kNewGame.
  int games_finished() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::referee
