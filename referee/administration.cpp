// The arrows of what is neither play nor the paper's: cards, timeouts, knockout games.
#include <array>

#include "referee/machine.hpp"

namespace autoref::referee {
namespace {

// clang-format off
constexpr std::array kAdministration = {
  Arrow{"yellow_card", State::kRun, Event::kYellowCard, kAlways, kShowCard,
        State::kRun, "2026", ""},
  Arrow{"yellow_card_stopped", State::kWaitStop, Event::kYellowCard, kAlways, kShowCard,
        State::kWaitStop, "2026", ""},
  Arrow{"red_card", State::kRun, Event::kRedCard, kAlways, kShowCard,
        State::kRun, "2026", ""},
  Arrow{"red_card_stopped", State::kWaitStop, Event::kRedCard, kAlways, kShowCard,
        State::kWaitStop, "2026", ""},
  Arrow{"card_over", State::kRun, Event::kCardOver, kAlways, kEndCard,
        State::kRun, "Laws 12; 2026", ""},
};
// clang-format on

}  // namespace

std::span<const Arrow> arrows_of_administration() { return kAdministration; }

}  // namespace autoref::referee
