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

// Sets up the match, resumes from halts, confirms goals, starts kick-offs and penalty kicks, and
// ends stages. It decides based on the controller's messages and its own state, and acts at most
// once a second. Actions without effect are repeated.
class ControllerOperator {
 public:
  using Inputs = google::protobuf::RepeatedPtrField<league::ControllerInput>;

  explicit ControllerOperator(const game::GameConfiguration& game);

  // The inputs to send before the first frame. These inputs set up a new match with these teams,
  // which the controller continues by itself where it can.
  Inputs set_up(const PerSide<TeamRequests>& requests) const;

  // Records AutoRef's decision on a shot at goal, to be given when the controller asks for it.
  void on_decision(const referee::Decision& decision);

  // Call once per frame. Returns the inputs to send now, given the controller's newest message and
  // the signal in it.
  Inputs act(const league::RefereePacket& packet, const RefereeSignal& signal,
             const Tracks& tracks);

 private:
  using Action = league::ContinueAction;

  std::optional<Action::Type> next_action(const league::RefereePacket& packet,
                                          const RefereeSignal& signal, const Tracks& tracks);
  void take_time(const RefereeSignal& signal, double now_s);
  std::optional<Action::Type> in_halt(const league::RefereePacket& packet);
  std::optional<Action::Type> at_restart(const RefereeSignal& signal, const Tracks& tracks) const;
  bool is_half_over(Stage stage) const;

  game::GameConfiguration game_;
  double now_s_ = 0;
  std::optional<double> before_s_;  // time of the previous frame
  std::optional<Stage> stage_;
  double stage_s_ = 0;  // time spent in the stage; in a half, the time played
  std::uint32_t command_counter_ = 0;
  double command_s_ = 0;  // when the command was first seen
  double acted_s_ = -1;   // when the operator last acted
  bool is_goal_valid_ = true;
  std::string decided_goal_;  // serialised event of the last goal that was accepted or rejected
  int halted_ = 0;            // number of attempts to resume from the current halt
  int for_team_ = 0;          // team to which the next action applies
};

}  // namespace autoref::live
