// Operates the league's game controller in place of a person.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "league/messages/game_controller.pb.h"
#include "referee/decision.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::live {

// Sets up the match, resumes from halts, confirms goals, starts ball placements, continues after
// stops, starts kick-offs and penalty kicks, and ends stages. It decides based on the controller's
// messages and its own state, and acts at most once a second. Actions without effect are repeated.
//
// The controller's automatic continue is switched off: the controller does not survive two pending
// actions of which the second finds no next command, and whether its own action is pending cannot
// be seen from outside.
class ControllerOperator {
 public:
  using Inputs = google::protobuf::RepeatedPtrField<league::ControllerInput>;

  // The controller counts an event that was reported once it is this old.
  static constexpr double kProposal_s = 1;

  explicit ControllerOperator(const game::GameConfiguration& game);

  // The inputs to send before the first frame. These inputs set up a new match with these teams.
  Inputs set_up(const PerSide<TeamRequests>& requests) const;

  // The inputs to send when the game is over: the controller continues by itself again.
  static Inputs leave();

  // Records AutoRef's decision on a shot at goal, to be given when the controller asks for it.
  void on_decision(const referee::Decision& decision);

  // An event was reported that will have counted by this time. Until then, the operator ends no
  // half and acts only in HALT, since the event can change what is to be done.
  void await_event(double counted_s) { events_counted_s_ = counted_s; }

  // Call once per frame. Returns the inputs to send now, given the controller's newest message and
  // the signal in it.
  Inputs act(const league::RefereePacket& packet, const RefereeSignal& signal,
             const Tracks& tracks);

  // Whether the message shows the effect of the operator's last action.
  bool is_done(const league::RefereePacket& packet) const;

  // Whether the operator places the ball by hand, because no team can.
  bool places_ball() const { return places_ball_; }

 private:
  using Action = league::ContinueAction;

  // What an action changes in the controller's messages.
  struct VisibleState {
    int stage = 0;
    std::uint32_t command_counter = 0;
    int events = 0;
    bool operator==(const VisibleState&) const = default;
  };
  static VisibleState visible_in(const league::RefereePacket& packet);

  std::optional<Action::Type> next_action(const league::RefereePacket& packet,
                                          const RefereeSignal& signal, const Tracks& tracks);
  void take_time(const RefereeSignal& signal, double now_s);
  std::optional<Action::Type> in_halt(const league::RefereePacket& packet);
  std::optional<Action::Type> in_stop(const league::RefereePacket& packet,
                                      const RefereeSignal& signal, const Tracks& tracks);
  std::optional<Action::Type> before_start(const RefereeSignal& signal, const Tracks& tracks) const;
  bool is_half_over(const RefereeSignal& signal) const;
  bool is_penalty_pending(const RefereeSignal& signal) const;
  std::optional<Action::Type> at_end(const RefereeSignal& signal) const;

  game::GameConfiguration game_;
  double now_s_ = 0;
  std::optional<Stage> stage_;
  double stage_since_s_ = 0;   // when the stage was first seen
  double stage_length_s_ = 0;  // what the controller's clock showed then
  std::uint32_t command_counter_ = 0;
  CommandKind command_ = CommandKind::kHalt;
  double command_s_ = 0;     // when the command was first seen
  bool was_halted_ = false;  // whether the command before was HALT
  bool places_ball_ = false;
  VisibleState before_action_;
  double events_counted_s_ = 0;  // when all reported events will have counted
  bool is_penalty_ = false;      // whether a penalty kick is prepared or being taken
  double acted_s_ = -1;          // when the operator last acted
  bool is_goal_valid_ = true;
  std::string decided_goal_;  // serialised event of the last goal that was accepted or rejected
  int resumptions_ = 0;       // number of attempts to resume from the current halt
  int for_team_ = 0;          // team to which the next action applies
};

}  // namespace autoref::live
