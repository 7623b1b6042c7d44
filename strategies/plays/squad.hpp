// A team built from skills, tactics and plays. Its playbook decides what it does in each situation.
#pragma once

#include "strategies/plays/plays.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/place_ball.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

// The differences between teams of this kind: their style, and any plays that only one team has.
struct TeamPlaybook {
  Style style;
  void (*open_play)(PlayContext& book, RoleAssignment& assignment) = strategies::open_play;
  void (*await_restart)(PlayContext& book, RoleAssignment& assignment) = strategies::await_restart;
};

class Squad final : public Strategy {
 public:
  // `context.params` can override the style's values.
  Squad(const TeamContext& context, const TeamPlaybook& playbook);
  Squad(const Squad&) = delete;
  Squad& operator=(const Squad&) = delete;

  void decide(const TeamView& view, TeamCommands& commands) override;
  TeamRequests requests() const override { return requests_; }

 private:
  void command_robots(const TeamView& view, TeamCommands& commands);
  void choose_play(RoleAssignment& assignment);
  void keep(const RoleAssignment& assignment);
  bool may_take() const;
  void note_stop();
  void note_restarter();
  RobotCommand command_for(int index, const Task& task);
  RobotCommand command_in_placement(int index, const Task& task);

  TeamPlaybook playbook_;
  PredictedState predicted_;
  PassField field_;
  BallHandler handler_;
  BallPlacer placer_;
  PlayContext book_;
  RoleAssignment kept_;  // the assignment that robots keep while play is stopped, and that the
                         // others keep while one robot takes a restart
  int kept_robots_ = 0;
  Play former_play_ = Play::kHalt;
  std::optional<bool> former_placing_;
  int former_robots_ = 0;
  double since_s_ = 0;  // view time at which the state of play last changed
  TeamRequests requests_;
};

}  // namespace autoref::strategies
