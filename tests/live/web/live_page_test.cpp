#include "live/web/live_page.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "view/live_messages.hpp"

namespace autoref::live {
namespace {

class HandClock final : public FrameClock {
 public:
  Time now() const override { return now_; }
  void sleep_until(Time time) override { now_ = time; }

 private:
  Time now_{};
};

struct BacklogCounts {
  std::size_t signals = 0;
  std::size_t clock_marks = 0;
  std::size_t decisions = 0;
  std::uint32_t last_counter = 0;
};

// A game at 60 frames per second, watched from its beginning.
class LivePageTest : public testing::Test {
 protected:
  void play(int frames, double speed = 1) {
    for (int i = 0; i < frames; ++i) {
      frame_.time_s = static_cast<double>(frame_.number) / 60;
      page_.add(frame_, signal_);
      ++frame_.number;
      clock_.sleep_until(clock_.now() +
                         std::chrono::microseconds(static_cast<int>(1'000'000 / (60 * speed))));
    }
  }

  int sent_frames() const {
    int frames = 0;
    for (const WebMessage& message : sent_)
      frames += io::Json::parse(*message.text).value("frames", 0);
    return frames;
  }

  // Every frame with a changed signal, a changed clock and a decision.
  void play_with_calls(int frames, double speed) {
    view::RecordedDecision decision;
    decision.event = "goal";
    for (int i = 0; i < frames; ++i) {
      ++signal_.command_counter;
      signal_.stage_time_left_s = i % 600;
      page_.add(decision);
      play(1, speed);
    }
  }

  // What a new watcher gets.
  BacklogCounts counts() const {
    BacklogCounts counts;
    for (const WebText& text : page_.backlog().texts) {
      const io::Json message = io::Json::parse(*text);
      if (message["type"] != "part") continue;
      counts.signals += message["signals"].size();
      counts.clock_marks += message["clock"].size();
      counts.decisions += message["decisions"].size();
      for (const io::Json& signal : message["signals"]) counts.last_counter = signal["counter"];
    }
    return counts;
  }

  HandClock clock_;
  std::vector<WebMessage> sent_;
  view::GameRecording nothing_;
  LivePage page_{{nothing_, Field{}, {{"a", "b"}}}, clock_, [this](const WebMessage& message) {
                   sent_.push_back(message);
                 }};
  Frame frame_;
  RefereeSignal signal_;
};

io::Json parsed(const WebText& text) { return io::Json::parse(*text); }

TEST_F(LivePageTest, SendsThirtyFramesPerSecond) {
  play(600);
  EXPECT_NEAR(sent_frames(), 300, 2);
}

TEST_F(LivePageTest, SendsThirtyFramesPerSecondOfTheClockInAFastGame) {
  play(6000, 10);
  EXPECT_NEAR(sent_frames(), 300, 2);
}

TEST_F(LivePageTest, SendsAChangedSignalAtOnceAndOnlyOnce) {
  play(59);
  sent_.clear();
  signal_.command.kind = CommandKind::kStop;
  play(1);
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_FALSE(sent_[0].is_frame);
  EXPECT_EQ(parsed(sent_[0].text)["signals"][0]["command"], "STOP");
  play(10);
  for (std::size_t i = 1; i < sent_.size(); ++i) EXPECT_TRUE(sent_[i].is_frame);
}

TEST_F(LivePageTest, SendsADecisionWithTheFrame) {
  play(59);
  sent_.clear();
  view::RecordedDecision decision;
  decision.event = "goal";
  page_.add(decision);
  play(1);
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_EQ(parsed(sent_[0].text)["decisions"][0]["event"], "goal");
}

TEST_F(LivePageTest, SendsAChainAndItsShotWithTheFrame) {
  play(59);
  sent_.clear();
  page_.add(view::RecordedChain{1, 2, Side::kEast, "duel", "shot", 0, 1, 0.5});
  page_.add(view::RecordedShot{1.5, Side::kEast, {1, 0}, 0.5, false});
  play(1);
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_FALSE(sent_[0].is_frame);  // so that no watcher misses it
  EXPECT_EQ(parsed(sent_[0].text)["chains"][0][3], "duel");
  EXPECT_EQ(parsed(sent_[0].text)["shots"][0][0], 1.5);
}

TEST_F(LivePageTest, ANewWatcherGetsEachChainOnceAndBeforeItsShot) {
  page_.add(view::RecordedChain{});
  page_.add(view::RecordedShot{});
  play(60 * 60);
  std::string entries;
  for (const WebText& text : page_.backlog().texts) {
    const io::Json message = parsed(text);
    if (message["type"] != "part") continue;
    entries.append(message["chains"].size(), 'c').append(message["shots"].size(), 's');
  }
  EXPECT_EQ(entries, "cs");
}

TEST_F(LivePageTest, ANewWatcherGetsTheGameFromItsBeginning) {
  play(60 * 60);
  int frames = 0;
  const WebBacklog backlog = page_.backlog();
  EXPECT_EQ(parsed(backlog.texts.front())["type"], "start");
  EXPECT_EQ(parsed(backlog.texts.back())["type"], "present");
  for (const WebText& text : backlog.texts) frames += parsed(text).value("frames", 0);
  EXPECT_EQ(frames, sent_frames());
  EXPECT_EQ(backlog.last_number, sent_.back().number);
}

TEST_F(LivePageTest, ForgetsFramesAfterTenMinutesButNoCalls) {
  signal_.command.kind = CommandKind::kStop;
  play(60 * 60 * 12);
  int frames = 0;
  std::size_t signals = 0;
  for (const WebText& text : page_.backlog().texts) {
    frames += parsed(text).value("frames", 0);
    signals += parsed(text).value("signals", io::Json::array()).size();
  }
  EXPECT_NEAR(frames, 18'000, 150);
  EXPECT_EQ(signals, 1U);
}

TEST_F(LivePageTest, KeepsAsManyCallsAsThePage) {
  const view::LiveLimits limits;
  for (const std::size_t most : {limits.signals, limits.clock_marks, limits.decisions})
    EXPECT_LT(most, 50'000U);
  play_with_calls(50'000, 4);
  page_.end();
  const std::size_t unfolded = 2 * 5 * 60 * 4;  // in 5 s at four times real time, twice
  const BacklogCounts kept = counts();
  EXPECT_GE(kept.signals, limits.signals);
  EXPECT_LT(kept.signals, limits.signals + unfolded);
  EXPECT_GE(kept.clock_marks, limits.clock_marks);
  EXPECT_LT(kept.clock_marks, limits.clock_marks + unfolded);
  EXPECT_GE(kept.decisions, limits.decisions);
  EXPECT_LT(kept.decisions, limits.decisions + unfolded);
  EXPECT_EQ(kept.last_counter, 50'000U);
}

TEST_F(LivePageTest, SaysHowManyCallsAPageKeeps) {
  const io::Json limits = parsed(page_.backlog().texts.front())["limits"];
  EXPECT_EQ(limits["signals"], view::LiveLimits{}.signals);
  EXPECT_EQ(limits["clock"], view::LiveLimits{}.clock_marks);
  EXPECT_EQ(limits["decisions"], view::LiveLimits{}.decisions);
}

TEST_F(LivePageTest, SaysThatTheGameIsOver) {
  play(2);
  page_.end();
  EXPECT_EQ(sent_frames(), 2);
  EXPECT_EQ(parsed(sent_.back().text)["type"], "over");
  EXPECT_FALSE(sent_.back().is_frame);
}

}  // namespace
}  // namespace autoref::live
