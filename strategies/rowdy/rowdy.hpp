// Plays like `basic`, but occasionally breaks rules on purpose, so that a referee can be evaluated.
//
// Each foul behaviour (foul_behaviours.hpp) has a parameter with its name. It is the fraction of
// opportunities that the team takes, from 0 (never) to 1 (always). The parameter `otherwise` sets
// this fraction for all behaviours that have no value of their own; without `otherwise`, they use
// their defaults. Only one foul behaviour is active at a time.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "strategies/basic/basic.hpp"
#include "strategies/rowdy/foul_behaviours.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies::rowdy {

class Rowdy final : public Strategy {
 public:
  explicit Rowdy(const TeamContext& context);

  void decide(const TeamView& view, TeamCommands& commands) override;
  TeamRequests requests() const override { return requests_; }

 private:
  // A foul behaviour, the fraction of its opportunities that the team takes, and the time of its
  // last opportunity.
  struct Habit {
    const FoulBehaviour* kind = nullptr;
    double share = 0;
    double last_chance_s = -std::numeric_limits<double>::infinity();
  };

  void look_for_chances(const RowdyView& view);
  void consider(Habit& habit, const RowdyView& view);
  bool go_on(const RowdyView& view, TeamCommands& commands);

  TeamContext context_;
  basic::Basic basic_;
  RandomStream random_;
  std::array<Habit, kKindCount> habits_;
  const FoulBehaviour* under_way_ = nullptr;
  ActiveFoul active_foul_;
  TeamView now_;
  TeamRequests requests_;
};

}  // namespace autoref::strategies::rowdy
