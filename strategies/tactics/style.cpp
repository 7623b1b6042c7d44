#include "strategies/tactics/style.hpp"

#include <array>
#include <initializer_list>

#include "strategies/tactics/tunables.hpp"

namespace autoref::strategies {
namespace {

constexpr std::array kTeam = std::to_array<Tunable>({
    {&Style::shot_mps, {"shot_mps", "m/s", 0, 1, 8, "Speed of shots at the goal."}},
    {&Style::shot_threshold,
     {"shot_threshold", "1", 0, 0, 1, "Chance of scoring above which a shot is taken at once."}},
    {&Style::pass_arrival_mps,
     {"pass_arrival_mps", "m/s", 0, 0.5, 5, "Speed of a pass when it reaches the receiver."}},
    {&Style::pass_risk,
     {"pass_risk", "1", 0, 0, 1,
      "Willingness to risk losing a pass, from 0 (cautious) to 1 (bold)."}},
    {&Style::carry, {"carry", "1", 0, 0, 2, "Preference for carrying the ball over passing it."}},
    {&Style::wall,
     {"wall", "1", 0, 0, 6,
      "Number of robots in the wall in front of the team's own area while defending."}},
    {&Style::markers,
     {"markers", "1", 0, 0, 6, "Number of robots that mark an opponent while defending."}},
    {&Style::forwards,
     {"forwards", "1", 0, 0, 6,
      "Number of robots that stay ahead while defending, if there are enough."}},
    {&Style::receivers,
     {"receivers", "1", 0, 0, 6, "Maximum number of robots that run for passes while attacking."}},
    {&Style::width, {"width", "1", 0, 0.2, 1, "Fraction of the field's width used by receivers."}},
    {&Style::line_m,
     {"line_m", "m", 0, -4, 4, "Rearmost position of receivers, from the halfway line."}},
    {&Style::keeper_out_m,
     {"keeper_out_m", "m", 0, 0.1, 1, "Distance from its line at which the keeper awaits a shot."}},
    {&Style::ahead,
     {"ahead", "1", 0, 0, 2, "Extra value of a pass that gains half the field's length."}},
    {&Style::patience,
     {"patience", "1", 0, 0, 1, "Value of a safe pass merely for keeping the ball."}},
    {&Style::net_m,
     {"net_m", "m", 0, 0.6, 3, "Distance from the ball to the receivers around it."}},
});

}  // namespace

std::span<const Tunable> tunables() {
  static const std::vector<Tunable> kAll = [] {
    std::vector<Tunable> all(kTeam.begin(), kTeam.end());
    for (const auto& role : {moving_tunables(), kick_tunables(), ball_tunables(),
                             running_tunables(), defence_tunables(), together_tunables(),
                             discipline_tunables(), play_tunables(), formation_tunables()}) {
      all.insert(all.end(), role.begin(), role.end());
    }
    return all;
  }();
  return kAll;
}

std::vector<Parameter> parameters_of(const Style& style) {
  return parameters_of<Style>(tunables(), style);
}

Style tuned(const Style& style, const std::map<std::string, double>& params) {
  return tuned<Style>(tunables(), style, params);
}

}  // namespace autoref::strategies
