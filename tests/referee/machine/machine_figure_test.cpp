#include "referee/machine/machine_figure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "referee/machine/machine.hpp"
#include "soccer/rule_table.hpp"

namespace autoref::referee {
namespace {

std::string readme() {
  std::ifstream file(AUTOREF_SOURCE_DIR "/referee/README.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(MachineFigure, InTheReadmeIsPrintedFromTheTable) {
  const std::string figure = machine_figure();
  EXPECT_NE(readme().find(figure), std::string::npos)
      << "referee/README.md should show this figure:\n\n"
      << figure;
}

TEST(MachineFigure, EveryDeviationOfAnArrowIsListed) {
  const std::string text = readme();
  for (const auto& arrows : all_arrows()) {
    for (const Arrow& arrow : arrows) {
      std::istringstream numbers{std::string(arrow.deviations)};
      for (std::string number; std::getline(numbers >> std::ws, number, ',');) {
        const std::string heading = "**" + number + "**";
        EXPECT_NE(text.find(heading), std::string::npos) << heading << " of " << arrow.label;
      }
    }
  }
}

TEST(Readme, SaysOfEveryRuleWhatItGives) {
  const std::string text = readme();
  for (const RuleEntry& entry : rule_table()) {
    const std::string row = "\n| " + std::string(name_of(entry.rule)) + " | ";
    EXPECT_NE(text.find(row), std::string::npos) << name_of(entry.rule);
  }
}

TEST(Machine, LabelsItsArrowsUniquely) {
  std::set<std::string_view> labels;
  for (const auto& arrows : all_arrows()) {
    for (const Arrow& arrow : arrows) EXPECT_TRUE(labels.insert(arrow.label).second);
  }
}

TEST(Machine, StepLeavesItsInputUntouched) {
  const Configuration configuration;
  const Frame frame;
  const std::optional<BallSight> ball;
  const LastTouch touch;
  const Tracks tracks;
  const PerSide<TeamRequests> requests;
  const Memory memory;
  Finding finding;
  finding.event = Event::kBegin;
  const Step first = step(memory, {configuration, frame, ball, touch, tracks, requests}, finding);
  const Step again = step(memory, {configuration, frame, ball, touch, tracks, requests}, finding);
  EXPECT_EQ(first.memory.state, State::kWaitStart);
  EXPECT_EQ(first.arrow, again.arrow);
  EXPECT_EQ(first.sent, again.sent);
}

TEST(Machine, StaysWhereNoArrowLeadsOn) {
  const Configuration configuration;
  const Frame frame;
  const std::optional<BallSight> ball;
  const LastTouch touch;
  const Tracks tracks;
  const PerSide<TeamRequests> requests;
  Memory memory;
  memory.state = State::kWaitStop;
  Finding goal;
  goal.event = Event::kGoal;
  const Step taken = step(memory, {configuration, frame, ball, touch, tracks, requests}, goal);
  EXPECT_EQ(taken.arrow, nullptr);
  EXPECT_EQ(taken.memory.signal.goals[Side::kWest], 0);
  EXPECT_FALSE(taken.sent.has_value());
}

}  // namespace
}  // namespace autoref::referee
