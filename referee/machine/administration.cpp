// Transitions outside play that the paper's machine does not have: cards, timeouts and knockout
// games.
#include <array>

#include "referee/machine/machine.hpp"

namespace autoref::referee {
namespace {

// clang-format off
constexpr std::array kAdministration = {
  Transition{"", std::nullopt, Event::kMultipleFouls, kAlways, kShowCard,
        std::nullopt, "2026", ""},
  Transition{"", std::nullopt, Event::kMultipleCards, kAlways, kShowCard,
        std::nullopt, "2026", ""},
  Transition{"card_over", State::kRun, Event::kCardOver, kAlways, kEndCard,
        State::kRun, "Laws 12; 2026", ""},
  Transition{"timeout", State::kWaitStop, Event::kTimeout, kAlways, kBeginTimeout,
        State::kTimeout, "Laws 7; 2026", ""},
  Transition{"timeout_over", State::kTimeout, Event::kTimeoutOver, kAlways, kEndTimeout,
        State::kWaitStop, "Laws 7; 2026", ""},
  Transition{"goal_lead", State::kDelayWait, Event::kGoalLead, kGameWasLast, kEndGame,
        State::kOver, "2026", ""},
  Transition{"goal_lead_next", State::kDelayWait, Event::kGoalLead, kNewGameFollows, kEndGame,
        State::kDelayWait, "2026", ""},
  Transition{"extra_time", std::nullopt, Event::kExtraTime, kAlways, kBeginExtraTime,
        State::kDelayWait, "Laws, appendix A; 2026", ""},
  Transition{"shootout", std::nullopt, Event::kShootout, kAlways, kEndForShootout,
        State::kDelayWait, "Laws, appendix A; 2026", ""},
  Transition{"shootout_begins", State::kDelayWait, Event::kSignalled, kBeforeShootout, kBeginShootout,
        State::kWaitStop, "Laws, appendix A; 2026", ""},
  Transition{"shootout_goal", State::kRun, Event::kGoal, kInShootout, kCountShootoutGoal,
        State::kDelayWait, "Laws, appendix A; 2026", ""},
  Transition{"shootout_miss", State::kRun, Event::kPenaltyKickFailed, kInShootout, kCountShootoutMiss,
        State::kWaitStop, "Laws, appendix A; 2026", ""},
  Transition{"shootout_over", std::nullopt, Event::kShootoutOver, kGameWasLast, kEndGame,
        State::kOver, "Laws, appendix A; 2026", ""},
  Transition{"shootout_over_next", std::nullopt, Event::kShootoutOver, kNewGameFollows, kEndGame,
        State::kDelayWait, "Laws, appendix A; 2026", ""},
};
// clang-format on

}  // namespace

std::span<const Transition> transitions_of_administration() { return kAdministration; }

}  // namespace autoref::referee
