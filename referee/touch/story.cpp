#include "referee/touch/story.hpp"

#include <algorithm>

namespace autoref::referee {

double Explanations::least() const { return std::min({cost[kNobody], cost[kWest], cost[kEast]}); }

void Explanations::offer(Toucher toucher, double offered_cost, const LastTouch& offered_touch) {
  if (offered_cost >= cost[toucher]) return;
  cost[toucher] = offered_cost;
  touch[toucher] = offered_touch;
}

}  // namespace autoref::referee
