#include "view/page.hpp"

#include <gtest/gtest.h>

namespace autoref::view {
namespace {

std::string page_between(const std::string& yellow, const std::string& blue) {
  GameRecording recording;
  Frame frame;
  frame.ball = BallObservation{{1, 0}, 0.0, {}};
  recording.add(frame);
  recording.add(0, RefereeSignal{});
  return page_of({recording, Field{}, {{yellow, blue}}});
}

std::size_t count_in(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Page, ContainsAllParts) {
  const std::string page = page_between("cobalt", "counter");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page.find(R"("teams": ["cobalt", "counter"])"), std::string::npos);
  for (const char* mark : {"@STYLE@", "@GAME@", "@FRAMES@", "@SCRIPT@"})
    EXPECT_EQ(count_in(mark, page), 0U) << mark;
}

TEST(Page, ShowsWhichBuildPlayedTheGame) {
  GameRecording recording;
  recording.add(Frame{});
  const std::string page =
      page_of({recording, Field{}, {{"a", "b"}}, {{"build", "0.1.0-bc09b374e057"}}});
  EXPECT_NE(page.find(R"("facts": [["build", "0.1.0-bc09b374e057"]])"), std::string::npos);
}

TEST(Page, KnowsTheEndsOfTheTeams) {
  GameRecording recording;
  recording.add(Frame{});
  RefereeSignal signal;
  recording.add(0, signal);
  signal.blue_on_positive_half = false;
  recording.add(1, signal);
  const std::string page = page_of({recording, Field{}, {}});
  const std::size_t first = page.find(R"("yellowDefends": "west")");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(page.find(R"("yellowDefends": "east")", first), std::string::npos);
}

TEST(Page, HasTheDecisionsOfTheRecording) {
  RecordedDecision decision;
  decision.time_s = 12.5;
  decision.event = "bot_pushed_bot";
  decision.rule = "paper 4.2";
  decision.reason = "He said \"no\" <twice>.";
  decision.offender = "blue";
  decision.card = "yellow";
  decision.card_reason = "3rd foul";
  decision.position_m = Vec2(1, -2);
  GameRecording recording;
  recording.add(decision);
  EXPECT_NE(page_of({recording, Field{}, {}})
                .find(R"("decisions": [{"time_s": 12.5, "event": "bot_pushed_bot", )"
                      R"("rule": "paper 4.2", "reason": "He said \"no\" \u003ctwice>.", )"
                      R"("offender": "blue", "card": "yellow", "card_reason": "3rd foul", )"
                      R"("restart": null, "position_m": [1, -2]}])"),
            std::string::npos);
}

TEST(Page, TakesPartsAtItsEnd) {
  RecordedDecision decision;
  decision.event = "goal";
  decision.reason = "</script>";
  GameRecording recording;
  recording.add(Frame{});
  recording.add(decision);
  const std::string part = page_part(recording);
  EXPECT_TRUE(part.starts_with(R"(<script type="application/json" class="part">{)")) << part;
  EXPECT_TRUE(part.ends_with("}</script>\n")) << part;
  EXPECT_EQ(count_in("</script>", part), 1U) << part;
  EXPECT_EQ(count_in(R"("frames": 1)", part), 1U) << part;
  EXPECT_EQ(count_in(R"("reason": "\u003c/script>")", part), 1U) << part;
}

TEST(Page, HasTheChainsShotsAndWinProbabilitiesOfTheRecording) {
  GameRecording recording;
  recording.add(RecordedChain{12.5, 14.0004, Side::kEast, "duel", "goal", 2, 1, 0.12345});
  recording.add(RecordedShot{13.25, Side::kEast, {1.5, -2}, 0.12345, true});
  recording.add(RecordedWinProbability{3, 0.25, 0.12345});
  PageContent content{recording, Field{}, {}};
  content.chain_kinds = ChainKinds{{"duel", "penalty"}, {"goal", "lost"}};
  const std::string page = page_of(content);
  for (const char* part :
       {R"("chains": [[12.5, 14, 1, "duel", "goal", 2, 1, 0.123]])",
        R"("shots": [[13.25, 1, [1500, -2000], 0.123, true]])",
        R"("winProbabilities": [[3, 0.25, 0.123]])",
        R"("chainKinds": {"starts": ["duel", "penalty"], "ends": ["goal", "lost"]})"})
    EXPECT_EQ(count_in(part, page), 1U) << part;
}

TEST(Page, KnowsThatAGameIsNotDividedIntoChains) {
  EXPECT_EQ(count_in(R"("chainKinds": null)", page_between("a", "b")), 1U);
}

TEST(Page, LinksToNoFile) {
  const std::string page = page_between("a", "b");
  EXPECT_EQ(count_in("<a ", page), 0U);
}

TEST(Page, NeedsNoNetwork) {
  const std::string page = page_between("a", "b");
  for (const char* sign : {"://", "@import", "url(", " src=", "fetch("})
    EXPECT_EQ(count_in(sign, page), 0U) << sign;
}

TEST(Page, IsNotBrokenByTextsInALog) {
  const std::string harmless = page_between("a", "b");
  const std::string page = page_between("</script><script>alert(1)</script>", "<!--<script>");
  EXPECT_EQ(count_in("<script", page), count_in("<script", harmless));
  EXPECT_EQ(count_in("</script", page), count_in("</script", harmless));
  EXPECT_EQ(count_in("<!--", page), 0U);
}

}  // namespace
}  // namespace autoref::view
