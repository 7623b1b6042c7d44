// Prediction over the latency: a team's own robots follow the commands that have been sent but have
// not yet taken effect.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "soccer/robot_command.hpp"
#include "soccer/team_view.hpp"

namespace autoref::strategies {

class LookAhead {
 public:
  using TeamAbilities = std::array<Abilities, kMaxRobots>;

  LookAhead(const TeamAbilities& abilities, double frame_rate_hz);

  // Extrapolates `view` by its latency, to when commands given now take effect. The team's own
  // robots follow the commands recorded so far, within their acceleration limits; a ball at a
  // robot's dribbler moves with that robot. Opponents, and a ball that is not held, keep their
  // motion. Returns whether the ball is held.
  bool look(const TeamView& view, TeamView& ahead) const;

  // Records the commands that the team gives for the view of this frame.
  void note(std::int64_t frame, const TeamCommands& commands);

 private:
  // How many of the latest commands are kept. If there are more frames between view and motion, the
  // oldest commands are missing.
  static constexpr int kKept = 32;
  struct Sent {
    std::int64_t frame = -1;
    TeamCommands commands{};
  };

  // Commands that have not yet taken effect, if the team gave any, and for how long they will
  // apply.
  struct PendingCommands {
    const TeamCommands* sent;
    double duration_s;
  };
  using Pending = boost::container::static_vector<PendingCommands, kKept>;

  const TeamCommands* sent_for(std::int64_t frame) const;
  Pending pending(const TeamView& view) const;
  void follow(const Pending& pending, TrackedRobot& robot) const;

  TeamAbilities abilities_;
  double frame_s_;
  std::array<Sent, kKept> sent_{};
};

}  // namespace autoref::strategies
