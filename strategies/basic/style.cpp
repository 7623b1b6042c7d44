#include "strategies/basic/style.hpp"

#include <array>

namespace autoref::strategies::basic {
namespace {

constexpr std::array kTunables = std::to_array<TunableOf<Style>>({
    {&Style::shot_mps, {"shot_mps", "m/s", 0, 0, 8, "Speed of shots at the goal."}},
    {&Style::pass_mps, {"pass_mps", "m/s", 0, 0, 8, "Speed of passes, at most."}},
    {&Style::slowest_pass_mps,
     {"slowest_pass_mps", "m/s", 0, 0.2, 8, "Speed of the shortest passes."}},
    {&Style::pass_per_metre_per_s,
     {"pass_per_metre_per_s", "1/s", 0, 0, 5, "Added to a pass's speed for each metre."}},
    {&Style::push_mps, {"push_mps", "m/s", 0, 0.2, 8, "Kick ahead where nothing better is open."}},
    {&Style::clearance_mps,
     {"clearance_mps", "m/s", 0, 0.2, 8, "The keeper's kick away from the goal."}},
    {&Style::kick_caution,
     {"kick_caution", "1", 0, 0.5, 1,
      "Share of the speed limit of kicks that is used: kickers are not exact."}},
    {&Style::duel_m, {"duel_m", "m", 0, 0, 2, "An opponent this near to the ball presses."}},
    {&Style::pass_lane_m, {"pass_lane_m", "m", 0, 0, 2, "Room that a pass needs on both sides."}},
    {&Style::shot_lane_m,
     {"shot_lane_m", "m", 0, 0, 2, "Room that a shot needs: a robot's and a ball's radius."}},
    {&Style::free_lane_m,
     {"free_lane_m", "m", 0, 0, 2, "More room does not make a kick less exact."}},
    {&Style::aim_share,
     {"aim_share", "1", 0, 0.05, 1, "Share of the room by which a kick may be off."}},
    {&Style::back_pass_m, {"back_pass_m", "m", 0, -3, 3, "Passes go no farther back than this."}},
    {&Style::robot_gap_m,
     {"robot_gap_m", "m", 0, 0, 0.5, "Between hulls, where a robot drives around another."}},
    {&Style::ball_gap_m,
     {"ball_gap_m", "m", 0, 0, 0.5, "From hull to ball, where a robot drives around it."}},
    {&Style::stop_speed_share,
     {"stop_speed_share", "1", 0, 0.1, 1, "Share of the speed allowed while play is stopped."}},
    {&Style::sidestep_m,
     {"sidestep_m", "m", 0, 0.005, 0.5, "Step aside where nobody fits between ball and own area."}},
    {&Style::from_their_area_m,
     {"from_their_area_m", "m", 0, 0, 1,
      "A ball nearer to the opponents' area is left alone where a rule asks for it."}},
    {&Style::keeper_fetch_mps,
     {"keeper_fetch_mps", "m/s", 0, 0, 5, "The keeper comes out for slower balls."}},
    {&Style::keeper_area_margin_m,
     {"keeper_area_margin_m", "m", 0, 0, 0.5, "So far before the area a ball counts as in it."}},
    {&Style::keeper_shot_mps,
     {"keeper_shot_mps", "m/s", 0, 0, 5,
      "Speed towards the goal of a ball whose way the keeper takes."}},
    {&Style::margin_m,
     {"margin_m", "m", 0, 0, 0.5, "More than a rule asks for, for the robots' own errors."}},
    {&Style::wall_gap_m,
     {"wall_gap_m", "m", 0, 0.18, 1, "Between the centres of two robots in the wall."}},
    {&Style::mark_radii,
     {"mark_radii", "1", 0, 2, 10,
      "From an opponent's centre to its marker's, in radii of robots."}},
    {&Style::mark_off_ball_m,
     {"mark_off_ball_m", "m", 0, 0, 2, "From the ball to opponents that are marked, at least."}},
    {&Style::supporter_ahead,
     {"supporter_ahead", "1", 0, -1, 1,
      "Share of the half's length that the supporter is ahead of the ball."}},
    {&Style::supporter_back,
     {"supporter_back", "1", 0, -1, 0, "The same of the middle, behind which it does not go."}},
    {&Style::supporter_front,
     {"supporter_front", "1", 0, 0.01, 0.9, "And before which it does not go."}},
    {&Style::supporter_row,
     {"supporter_row", "1", 0, 0, 1, "The same between two rows of supporters."}},
    {&Style::supporter_wing,
     {"supporter_wing", "1", 0, 0, 0.9, "Share of the half's width that they stand aside."}},
    {&Style::loyalty_s,
     {"loyalty_s", "s", 0, 0, 2, "How much faster another robot must be to become the attacker."}},
    {&Style::go_round_s,
     {"go_round_s", "s", 0, 0, 4, "Time to get from before the ball to behind it."}},
});

}  // namespace

std::vector<Parameter> parameters() { return parameters_of<Style>(kTunables, Style{}); }

Style tuned(const std::map<std::string, double>& params) {
  return tuned<Style>(kTunables, Style{}, params);
}

}  // namespace autoref::strategies::basic
