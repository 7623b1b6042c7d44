#include "strategies/tactics/style.hpp"

#include <array>
#include <initializer_list>

#include "strategies/tactics/tunables.hpp"

namespace autoref::strategies {
namespace {

constexpr std::array kTeam = std::to_array<Tunable>({
    {&Style::shot_mps, {"shot_mps", "m/s", 0, 1, 8, "Speed of shots at the goal."}},
    {&Style::shot_threshold,
     {"shot_threshold", "1", 0, 0, 1, "Chance of scoring from which a shot is taken at once."}},
    {&Style::pass_arrival_mps,
     {"pass_arrival_mps", "m/s", 0, 0.5, 5, "Speed of a pass when it gets to the receiver."}},
    {&Style::pass_risk,
     {"pass_risk", "1", 0, 0, 1, "How little a lost pass is feared: 0 very much, 1 not at all."}},
    {&Style::carry,
     {"carry", "1", 0, 0, 2, "How much keeping the ball at the foot is liked over passing it."}},
    {&Style::wall, {"wall", "1", 0, 0, 6, "Robots before the own area while defending."}},
    {&Style::markers,
     {"markers", "1", 0, 0, 6, "Robots that mark an opponent each while defending."}},
    {&Style::forwards,
     {"forwards", "1", 0, 0, 6, "Robots that stay ahead while defending, if there are enough."}},
    {&Style::receivers,
     {"receivers", "1", 0, 0, 6, "Robots that run for passes while attacking, at most."}},
    {&Style::width,
     {"width", "1", 0, 0.2, 1, "Share of the field's width in which receivers look for room."}},
    {&Style::line_m,
     {"line_m", "m", 0, -4, 4, "How far from the middle line receivers come back, at most."}},
    {&Style::keeper_out_m,
     {"keeper_out_m", "m", 0, 0.1, 1, "How far from its line the keeper awaits a shot."}},
    {&Style::ahead,
     {"ahead", "1", 0, 0, 2, "Worth of a pass that gains half a field, besides what it brings."}},
    {&Style::patience,
     {"patience", "1", 0, 0, 1, "Worth of a safe pass for keeping the ball alone."}},
    {&Style::net_m,
     {"net_m", "m", 0, 0.6, 3, "From the ball to those around it who offer themselves."}},
});

}  // namespace

std::span<const Tunable> tunables() {
  static const std::vector<Tunable> kAll = [] {
    std::vector<Tunable> all(kTeam.begin(), kTeam.end());
    for (const auto& role :
         {moving_tunables(), kick_tunables(), ball_tunables(), running_tunables(),
          defence_tunables(), play_tunables(), formation_tunables()}) {
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
