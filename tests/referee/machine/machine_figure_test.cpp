#include "referee/machine/machine_figure.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "referee/machine/machine.hpp"
#include "referee/person/transitions_beside_person.hpp"
#include "soccer/rules/rule_book.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::referee {
namespace {

std::string readme() { return content_of(in_checkout("referee/README.md")); }

TEST(MachineFigure, InTheReadmeIsPrintedFromTheTable) {
  const std::string figure = machine_figure();
  EXPECT_NE(readme().find(figure), std::string::npos)
      << "referee/README.md should show this figure:\n\n"
      << figure;
}

TEST(MachineFigure, BesideAPersonInTheReadmeIsPrintedFromTheTable) {
  const std::string figure = machine_figure(transitions_beside_person());
  EXPECT_NE(readme().find(figure), std::string::npos)
      << "referee/README.md should show this figure:\n\n"
      << figure;
}

TEST(MachineFigure, EveryDeviationOfATransitionIsListed) {
  const std::string text = readme();
  for (const auto& transitions : all_transitions()) {
    for (const Transition& transition : transitions) {
      std::istringstream numbers{std::string(transition.deviations)};
      for (std::string number; std::getline(numbers >> std::ws, number, ',');) {
        const std::string heading = "**" + number + "**";
        EXPECT_NE(text.find(heading), std::string::npos) << heading << " of " << transition.label;
      }
    }
  }
}

// In the row of a table, or of an event that the rule raises.
TEST(RuleByRule, NamesEveryRuleInATable) {
  std::istringstream page(content_of(in_checkout("docs/rules.md")));
  std::string rows;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("|")) rows += line;
  for (const RuleEntry& entry : rule_table())
    EXPECT_NE(rows.find("`" + std::string(entry.name) + "`"), std::string::npos) << entry.name;
}

TEST(Machine, LabelsItsTransitionsUniquely) {
  std::set<std::string_view> labels;
  for (const std::string_view label : all_labels())
    EXPECT_TRUE(labels.insert(label).second) << label;
}

TEST(Machine, StepLeavesItsInputUntouched) {
  const Configuration configuration;
  const Frame frame;
  const std::optional<BallSight> ball;
  const LastTouch touch;
  const Tracks tracks;
  const PerSide<TeamRequests> requests;
  const FrameHistory frames;
  const RefereeState state;
  Finding finding;
  finding.event = Event::kBegin;
  const RefereeInput input{configuration, frame, ball, touch, tracks, requests, frames};
  const Step first = step(state, input, finding);
  const Step again = step(state, input, finding);
  EXPECT_EQ(first.state.machine_state, State::kWaitStart);
  EXPECT_EQ(first.transition, again.transition);
  EXPECT_EQ(first.sent, again.sent);
}

TEST(Machine, DoesNotChangeIfNoTransitionApplies) {
  const Configuration configuration;
  const Frame frame;
  const std::optional<BallSight> ball;
  const LastTouch touch;
  const Tracks tracks;
  const PerSide<TeamRequests> requests;
  const FrameHistory frames;
  RefereeState state;
  state.machine_state = State::kWaitStop;
  Finding goal;
  goal.event = Event::kGoal;
  const Step taken =
      step(state, {configuration, frame, ball, touch, tracks, requests, frames}, goal);
  EXPECT_EQ(taken.transition, nullptr);
  EXPECT_EQ(taken.state.signal.goals[Side::kWest], 0);
  EXPECT_FALSE(taken.sent.has_value());
}

}  // namespace
}  // namespace autoref::referee
