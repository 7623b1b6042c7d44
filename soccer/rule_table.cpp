#include "soccer/rule_table.hpp"

#include <array>

namespace autoref {
namespace {

using R = RuleId;
using B = RuleBook;

// clang-format off
constexpr std::array<RuleEntry, kRuleCount> kTable = {{
  {R::kGoal, "a ball wholly inside a goal scores",
   "paper 4.4, ball in a goal", "Laws 10", "2026, Scoring Goals", nullptr, ""},
  {R::kBallLeavesField, "throw-in, corner kick or goal kick once the ball is out",
   "paper 4.2, ball-related rules", "Laws 9, 15 to 17", "2026, Ball Leaves The Field", nullptr, ""},
  {R::kAttackerNearArea, "robots keep away from the opponents' defence area at restarts",
   "paper 4.2, robot-related rules", "Laws 8, 13", "2026, Attacker Too Close To Defense Area", &B::attacker_to_area_m, "m"},
  {R::kRestartNotTaken, "a restart is taken in time",
   "Laws 2014, 8 and 9; 2016", "Laws 8, 9; 2016", "2026, Lack Of Progress", &B::restart_timeout_s, "s"},
  {R::kStuckBall, "a ball that does not get away is put to a neutral place",
   "2016; Laws 2014, 9", "Laws 9; 2016", "", &B::stuck_distance_m, "m"},
  {R::kNoProgress, "a ball that does not get away is started anew",
   "", "", "2026, Lack Of Progress", &B::stuck_time_s, "s"},
  {R::kKickSpeed, "no kick is faster",
   "", "Laws 12, indirect free kicks", "2026, Ball Speed", &B::kick_limit_mps, "m/s"},
  {R::kChipGoal, "a chip kick does not score directly",
   "", "Laws 12, indirect free kicks", "", &B::chip_height_m, "m"},
  {R::kGoalValid, "a goal counts if the ball stayed low since the scorers' last touch and they had not just fouled",
   "", "", "2026, Scoring Goals", &B::chip_height_m, "m"},
  {R::kIndirectGoal, "no goal straight from an indirect free kick or a throw-in",
   "", "Laws 13, 15", "", nullptr, ""},
  {R::kFreeKickOwnGoal, "a ball kicked into one's own goal straight from a restart is a corner kick",
   "", "Laws 13", "2026, Free Kick", nullptr, ""},
  {R::kDefenderInArea, "only the keeper touches the ball inside its own defence area",
   "", "Laws 12, penalty kick, cautions", "2026, Defender In Defense Area", nullptr, ""},
  {R::kAttackerInArea, "nobody touches the ball inside the opponents' defence area",
   "", "", "2026, Attacker In Defense Area", nullptr, ""},
  {R::kDoubleTouch, "the kicker of a restart does not touch the ball again before another robot has",
   "", "Laws 8, 13 to 17", "2026, Double Touch", &B::in_play_m, "m"},
  {R::kRestartDistance, "opponents keep away from the ball at restarts",
   "", "Laws 8, 13, 15 to 17", "2026, Defender Too Close To Ball", &B::opponents_to_ball_m, "m"},
  {R::kStopSpeed, "robots are slow while play is stopped",
   "", "Laws 12, cautions", "2026, Robot Stop Speed", &B::stop_speed_mps, "m/s"},
  {R::kStopDistance, "robots keep away from the ball while play is stopped",
   "", "Laws 9", "", &B::opponents_to_ball_m, "m"},
  {R::kDribbling, "nobody dribbles farther",
   "", "Laws 12, indirect free kicks", "2026, Dribbling", &B::dribbling_m, "m"},
  {R::kKeeperHolding, "the keeper gives the ball away in time",
   "", "Laws 12, indirect free kicks", "2026, Lack Of Progress", &B::keeper_holding_s, "s"},
  {R::kCrash, "robots do not run into opponents",
   "", "Laws 12, substantial contact", "2026, Crashing", &B::crash_mps, "m/s"},
  {R::kPushing, "robots do not push opponents away",
   "", "Laws 12, holding", "2026, Pushing", &B::pushing_m, "m"},
  {R::kPlacementInterference, "nobody stands in the way of a ball that is being placed",
   "", "", "2026, Ball Placement Interference", &B::placement_clearance_m, "m"},
  {R::kTooManyRobots, "after a card a robot leaves in time",
   "", "Laws 3, 12", "2026, Number Of Robots", &B::too_many_s, "s"},
  {R::kKickoffPositions, "at kick-off all robots are in their own half",
   "", "Laws 8", "2026, Kick-Off", nullptr, ""},
  {R::kPenaltyPositions, "at a penalty kick the others keep behind the ball, the keeper on its line",
   "", "Laws 14", "2026, Penalty Kick", &B::penalty_clearance_m, "m"},
  {R::kPenaltyFailed, "a penalty kick that does not score in time is over",
   "", "", "2026, Penalty Kick", &B::penalty_time_s, "s"},
  {R::kAimlessKick, "no kick from the own half over the opponents' goal line",
   "", "", "2026, Aimless Kick", nullptr, ""},
  {R::kOffside, "no pass to a robot that was beyond the second-last defender",
   "", "", "", nullptr, ""},
  {R::kCards, "a yellow card takes a robot off for some time of play, a red one for good",
   "", "Laws 12, disciplinary sanctions", "2026, Yellow Card, Red Card", &B::card_s, "s"},
  {R::kTimeouts, "teams may ask for timeouts while play is stopped",
   "", "Laws 7", "2026, Timeouts", &B::timeouts_s, "s"},
  {R::kGoalLead, "the game ends at a clear lead",
   "", "", "2026, End Of Game", nullptr, ""},
}};
// clang-format on

}  // namespace

std::span<const RuleEntry> rule_table() { return kTable; }

const RuleEntry& entry_of(RuleId rule) { return kTable[static_cast<std::size_t>(rule)]; }

std::string_view section_of(const RuleBook& rules, RuleId rule) {
  const RuleEntry& entry = entry_of(rule);
  const std::array<std::string_view, 3> sections = {entry.paper, entry.laws_2014, entry.rules_2026};
  const std::string_view section = sections[static_cast<std::size_t>(rules.edition)];
  return section.empty() ? "ours" : section;
}

}  // namespace autoref
