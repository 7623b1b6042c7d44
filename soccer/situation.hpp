// What the referee's commands mean for play: who may do what at the moment.
#pragma once

#include <cstdint>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref {

// No play during halt and stop. A prepared restart waits for the start command; a restart lasts
// until the ball is in play.
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

// In the manner of the league's commands.
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

// `side` takes the restart; it is unused in halt, stop and running play. While a side's robots
// place the ball, `play` is kStop and `placer` is that side.
struct Situation {
  Play play = Play::kHalt;
  Side side = Side::kWest;
  std::optional<Side> placer{};
};

constexpr bool is_restart(Play play) { return play >= Play::kKickoff && play < Play::kRunning; }

// Derives the situation from commands and ball. Call it once per frame with the signal and the ball
// (nullopt until it has been seen).
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

}  // namespace autoref
