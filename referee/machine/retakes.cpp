#include "referee/machine/retakes.hpp"

namespace autoref::referee {
namespace {

constexpr int kMostRetakes = 3;

bool is_taken_again(Event event) {
  return event == Event::kDefenderTooCloseToKickPoint || event == Event::kKickoffPositions ||
         event == Event::kPenaltyPositions;
}

}  // namespace

bool may_be_taken_again(const RefereeState& state) { return state.retakes.count < kMostRetakes; }

void take_again(Finding& finding, const PlayState& play) {
  finding.restart = play.restart;
  finding.ball_to_m = play.position_m;
}

Retakes retakes_after(const Retakes& before, const Finding& finding) {
  if (!is_taken_again(finding.event)) return {};
  Retakes after = before;
  ++after.count;
  if (finding.event == Event::kDefenderTooCloseToKickPoint) {
    for (const RobotId robot : finding.robots) after.too_near.add(robot);
  }
  return after;
}

}  // namespace autoref::referee
