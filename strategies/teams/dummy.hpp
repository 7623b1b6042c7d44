// A team that does nothing: the lower bound of every comparison.
#pragma once

#include "strategies/strategy.hpp"

namespace autoref::strategies {

class Dummy final : public Strategy {
 public:
  void decide(const TeamView& view, TeamCommands& commands) override;
};

}  // namespace autoref::strategies
