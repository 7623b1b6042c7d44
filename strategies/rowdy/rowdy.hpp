// `basic` with bad manners: now and then it breaks a rule on purpose, so that a referee can be
// measured.
//
// Each kind of mischief (kinds.hpp) has a parameter of its name: the share of its opportunities
// that the team takes, from 0 (never) to 1 (always). `otherwise` is the share of all kinds that are
// not named; without it they have their defaults. One mischief at a time.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "strategies/basic/basic.hpp"
#include "strategies/rowdy/kinds.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies::rowdy {

class Rowdy final : public Strategy {
 public:
  explicit Rowdy(const Briefing& briefing);

  void decide(const TeamView& view, TeamOrders& orders) override;
  TeamRequests requests() const override { return requests_; }

 private:
  // A kind, how often it is done, and when there was last an opportunity.
  struct Habit {
    const Mischief* kind = nullptr;
    double share = 0;
    double last_chance_s = -std::numeric_limits<double>::infinity();
  };

  void look_for_chances(const Scene& scene);
  void consider(Habit& habit, const Scene& scene);
  bool go_on(const Scene& scene, TeamOrders& orders);

  Briefing briefing_;
  basic::Basic basic_;
  RandomStream random_;
  std::array<Habit, kKindCount> habits_;
  const Mischief* under_way_ = nullptr;
  Deed deed_;
  TeamView now_;
  TeamRequests requests_;
};

}  // namespace autoref::strategies::rowdy
