#include "referee/touch/touch_hypothesis.hpp"

#include <algorithm>

namespace autoref::referee {

double SideMinima::least() const {
  return std::min({deviance[kNobody], deviance[kWest], deviance[kEast]});
}

void SideMinima::offer(Toucher toucher, double offered_deviance, const LastTouch& offered_touch) {
  if (offered_deviance >= deviance[toucher]) return;
  deviance[toucher] = offered_deviance;
  touch[toucher] = offered_touch;
}

}  // namespace autoref::referee
