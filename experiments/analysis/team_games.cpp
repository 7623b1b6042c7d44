#include "experiments/analysis/team_games.hpp"

#include <stdexcept>

#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

TeamNumbers mean_over_legs(const TeamNumber& number, const std::string& matchup, int pair,
                           const RowsById& rows) {
  constexpr int kLegs = 2;
  TeamNumbers mean;
  for (int leg = 1; leg <= kLegs; ++leg) {
    const game::GameRecord& record = rows.at(game_id(matchup, pair, leg)).record;
    const auto& [a, b] = record.counts;
    mean.of_a += number({record.goals_a, record.goals_b, &a, &b}) / kLegs;
    mean.of_b += number({record.goals_b, record.goals_a, &b, &a}) / kLegs;
  }
  return mean;
}

std::string_view plural_of(game::ChainStart start) {
  using enum game::ChainStart;
  switch (start) {
    case kKickOff:
      return "kick-offs";
    case kPenalty:
      return "penalties";
    case kFreeKick:
      return "free kicks";
    case kCornerKick:
      return "corner kicks";
    case kGoalKick:
      return "goal kicks";
    case kThrowIn:
      return "throw-ins";
    case kKeeper:
      return "its own defence area";
    case kInterception:
      return "interceptions";
    case kDuel:
      return "duels";
    case kLooseBall:
      return "loose balls";
  }
  throw std::logic_error("unknown start of a chain");
}

}  // namespace autoref::experiments
