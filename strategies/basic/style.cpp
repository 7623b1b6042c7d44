#include "strategies/basic/style.hpp"

#include <array>

namespace autoref::strategies::basic {
namespace {

constexpr std::array kTunables = std::to_array<TunableOf<Style>>({
    {&Style::shot_mps, {"shot_mps", "m/s", 0, 0, 8, "Speed of shots at the goal."}},
    {&Style::pass_mps, {"pass_mps", "m/s", 0, 0, 8, "Maximum speed of passes."}},
    {&Style::slowest_pass_mps,
     {"slowest_pass_mps", "m/s", 0, 0.2, 8, "Speed of the shortest passes."}},
    {&Style::pass_per_metre_per_s,
     {"pass_per_metre_per_s", "1/s", 0, 0, 5, "Added to a pass's speed per metre."}},
    {&Style::push_mps,
     {"push_mps", "m/s", 0, 0.2, 8, "Speed of a kick ahead if nothing better is possible."}},
    {&Style::clearance_mps,
     {"clearance_mps", "m/s", 0, 0.2, 8, "Speed of the keeper's kick away from the goal."}},
    {&Style::kick_caution,
     {"kick_caution", "1", 0, 0.5, 1,
      "Fraction of the kick speed limit that is used, since kickers are not exact."}},
    {&Style::duel_m,
     {"duel_m", "m", 0, 0, 2, "Distance from the ball within which an opponent contests it."}},
    {&Style::pass_lane_m,
     {"pass_lane_m", "m", 0, 0, 2, "Free space that a pass needs on both sides."}},
    {&Style::shot_lane_m,
     {"shot_lane_m", "m", 0, 0, 2,
      "Free space that a shot needs: a robot's plus a ball's radius."}},
    {&Style::free_lane_m,
     {"free_lane_m", "m", 0, 0, 2,
      "Free space beyond which the allowed aiming error stays the same."}},
    {&Style::aim_share,
     {"aim_share", "1", 0, 0.05, 1,
      "Allowed aiming error of a kick, as a fraction of the free space."}},
    {&Style::back_pass_m, {"back_pass_m", "m", 0, -3, 3, "Maximum length of a backward pass."}},
    {&Style::robot_gap_m,
     {"robot_gap_m", "m", 0, 0, 0.5, "Gap between hulls when driving around another robot."}},
    {&Style::ball_gap_m,
     {"ball_gap_m", "m", 0, 0, 0.5, "Gap between hull and ball when driving around it."}},
    {&Style::stop_speed_share,
     {"stop_speed_share", "1", 0, 0.1, 1,
      "Fraction of the speed limit that is used while play is stopped."}},
    {&Style::sidestep_m,
     {"sidestep_m", "m", 0, 0.005, 0.5,
      "Step to the side if nobody fits between ball and own area."}},
    {&Style::from_their_area_m,
     {"from_their_area_m", "m", 0, 0, 1,
      "A ball closer to the opponents' area is left alone if a rule requires it."}},
    {&Style::keeper_fetch_mps,
     {"keeper_fetch_mps", "m/s", 0, 0, 5, "Speed below which the keeper comes out for the ball."}},
    {&Style::keeper_area_margin_m,
     {"keeper_area_margin_m", "m", 0, 0, 0.5, "Margin by which the keeper's area is extended."}},
    {&Style::keeper_shot_mps,
     {"keeper_shot_mps", "m/s", 0, 0, 5,
      "Speed towards the goal above which the keeper moves into the ball's path."}},
    {&Style::margin_m,
     {"margin_m", "m", 0, 0, 0.5, "Added to the rules' distances for the robots' own errors."}},
    {&Style::wall_gap_m,
     {"wall_gap_m", "m", 0, 0.18, 1, "Distance between the centres of two robots in the wall."}},
    {&Style::mark_radii,
     {"mark_radii", "1", 0, 2, 10,
      "Distance between the centres of an opponent and its marker, in robot radii."}},
    {&Style::mark_off_ball_m,
     {"mark_off_ball_m", "m", 0, 0, 2, "Opponents closer to the ball than this are not marked."}},
    {&Style::supporter_ahead,
     {"supporter_ahead", "1", 0, -1, 1,
      "Lead of the supporter over the ball, as a fraction of half the field's length."}},
    {&Style::supporter_back,
     {"supporter_back", "1", 0, -1, 0,
      "Rearmost position of the supporter, as a fraction of half the field's length."}},
    {&Style::supporter_front,
     {"supporter_front", "1", 0, 0.01, 0.9,
      "Foremost position of the supporter, as a fraction of half the field's length."}},
    {&Style::supporter_row,
     {"supporter_row", "1", 0, 0, 1,
      "Distance between two rows of supporters, as a fraction of half the field's length."}},
    {&Style::supporter_wing,
     {"supporter_wing", "1", 0, 0, 0.9,
      "Distance of supporters from the middle, as a fraction of half the field's width."}},
    {&Style::loyalty_s,
     {"loyalty_s", "s", 0, 0, 2, "How much faster another robot must be to become the attacker."}},
    {&Style::go_round_s,
     {"go_round_s", "s", 0, 0, 4, "Time to get from in front of the ball to behind it."}},
});

}  // namespace

std::vector<Parameter> parameters() { return parameters_of<Style>(kTunables, Style{}); }

Style tuned(const std::map<std::string, double>& params) {
  return tuned<Style>(kTunables, Style{}, params);
}

}  // namespace autoref::strategies::basic
