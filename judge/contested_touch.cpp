#include "judge/contested_touch.hpp"

#include <algorithm>
#include <array>

#include "judge/association.hpp"

namespace autoref::judge {
namespace {

constexpr std::array<std::string_view, 4> kTrueExits = {"throw_in", "corner_kick", "goal_kick",
                                                        "aimless_kick"};

}  // namespace

void SideTouches::see(std::span<const sim::Touch> touches, double time_s) {
  for (const sim::Touch& touch : touches) latest_s_[touch.robot.side] = time_s;
}

bool SideTouches::is_contested(double exit_s) const {
  return std::all_of(latest_s_.values.begin(), latest_s_.values.end(),
                     [exit_s](double latest_s) { return latest_s >= exit_s - kContested_s; });
}

double exit_time_s(const ground_truth::TrueEvents& true_events, double call_s) {
  const double since_s = call_s - ground_truth::Window{}.lag_s;
  for (auto event = true_events.rbegin(); event != true_events.rend(); ++event) {
    if (event->time_s < since_s) break;
    if (std::find(kTrueExits.begin(), kTrueExits.end(), event->name) != kTrueExits.end()) {
      return event->time_s;
    }
  }
  return call_s;
}

}  // namespace autoref::judge
