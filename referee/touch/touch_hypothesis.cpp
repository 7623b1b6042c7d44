#include "referee/touch/touch_hypothesis.hpp"

#include <algorithm>

namespace autoref::referee {

double SideMinima::least() const { return std::min({nll[kNobody], nll[kWest], nll[kEast]}); }

void SideMinima::offer(Toucher toucher, double offered_nll, const LastTouch& offered_touch) {
  if (offered_nll >= nll[toucher]) return;
  nll[toucher] = offered_nll;
  touch[toucher] = offered_touch;
}

}  // namespace autoref::referee
