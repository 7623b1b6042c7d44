// AutoRef referees whatever is called a log: it refuses it or makes finite decisions, in bounded
// time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "game/loop/event_log.hpp"
#include "io/command.hpp"
#include "io/errors.hpp"
#include "league/log_contents.hpp"
#include "league/message_fields.hpp"
#include "league/messages/tracker.pb.h"
#include "league/tracker_message.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/logs/mutated_log.hpp"
#include "tests/logs/refereed_log.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {
namespace {

namespace fs = std::filesystem;
using league::LogRecord;
using league::MessageKind;

constexpr std::uint64_t kLogs = AUTOREF_MUTATED_LOGS;

// Writes the log of a game with many fouls. Its seed has a corner kick and a robot that stays near
// the area in the part that game_records() uses.
void write_mutated_game(const fs::path& log) {
  const std::string game = in_checkout("scenarios/paper-game.yaml");
  const std::string path = log.string();
  const app::Answer answer = app::answer_to(
      {"play", game.c_str(), "--log", path.c_str(), "--set", "match.rules=2026-b", "--set",
       "match.half_s=15", "--seed", "263", "--set", "match.halves=1", "--set",
       "sim.camera=rc2026-b", "--set", "a.strategy=rowdy", "--set", "b.strategy=cobalt1"});
  ASSERT_EQ(answer.code, io::kDone) << answer.err;
}

// The packets of a tracker that follows a log.
class TrackerPackets final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override {
    constexpr int kEvery = 5;
    const Tracks& tracks = tracker_.update(frame);
    if (frame.number % kEvery != 0) return;
    league::TrackerPacket packet;
    fill_tracker(tracks, {"0c", "AutoRef"}, frame.time_s, packet);
    records.push_back({league::to_ns(frame.time_s),
                       static_cast<std::int32_t>(MessageKind::kTracker2020),
                       packet.SerializeAsString()});
  }

  std::vector<LogRecord> records;

 private:
  tracking::Tracker tracker_;
};

// Part of a game in which the referee commands a corner kick and robots foul: vision, referee and
// tracker packets, and an index.
std::vector<LogRecord> game_records(const TemporaryFolder& folder) {
  constexpr std::int64_t kFrom_ns = 4'500'000'000;
  constexpr std::int64_t kTo_ns = 18'000'000'000;
  const fs::path log = folder / "game.log";
  write_mutated_game(log);
  TrackerPackets tracker;
  league::read_log(log, tracker);
  std::vector<LogRecord> records = records_in(log);
  records.insert(records.end(), tracker.records.begin(), tracker.records.end());
  std::erase_if(records, [](const LogRecord& record) {
    return record.time_ns < kFrom_ns || record.time_ns > kTo_ns;
  });
  std::stable_sort(records.begin(), records.end(),
                   [](const LogRecord& a, const LogRecord& b) { return a.time_ns < b.time_ns; });
  records.push_back({0, static_cast<std::int32_t>(MessageKind::kIndex2021), "INDEXED"});
  return records;
}

void expect_valid(const RefereedLog& log, std::size_t bytes) {
  EXPECT_LE(log.frames.size(), bytes / 16) << "more frames than records";
  EXPECT_FALSE(log.report.empty());
  for (const Frame& frame : log.frames) EXPECT_TRUE(is_finite(frame));
  for (const referee::Decision& decision : log.decisions)
    EXPECT_TRUE(is_finite(decision)) << game::decision_json(decision);
}

enum class MutationOutcome : std::uint8_t { kJudged, kRefused, kNotALog };

MutationOutcome outcome_of(const fs::path& log, const std::string& bytes) {
  write_content(log, bytes);
  try {
    expect_valid(refereed(log), bytes.size());
    return MutationOutcome::kJudged;
  } catch (const league::LogError&) {
    return MutationOutcome::kNotALog;
  } catch (const io::InputError&) {
    return MutationOutcome::kRefused;
  }
}

TEST(MutatedLogs, AreRefusedOrJudgedWithFiniteNumbersInTime) {
  constexpr double kLongestReading_s =
      AUTOREF_LONGEST_READING_S;  // of processor time; a fiftieth of a second is usual
  const TemporaryFolder folder;
  const std::vector<LogRecord> records = game_records(folder);
  std::map<MutationOutcome, std::uint64_t> outcomes;
  for (std::uint64_t seed = 1; seed <= kLogs; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const double began_s = io::processor_s_of(RUSAGE_SELF);
    EXPECT_NO_THROW(++outcomes[outcome_of(folder / "mutated.log", mutated(records, seed))]);
    EXPECT_LT(io::processor_s_of(RUSAGE_SELF) - began_s, kLongestReading_s);
  }
  fmt::print("{} mutated logs: {} judged, {} refused, {} not logs\n", kLogs,
             outcomes[MutationOutcome::kJudged], outcomes[MutationOutcome::kRefused],
             outcomes[MutationOutcome::kNotALog]);
  EXPECT_GT(outcomes[MutationOutcome::kJudged], kLogs / 2);
}

TEST(MutatedLogs, AreMadeFromALogThatIsJudged) {
  const TemporaryFolder folder;
  const fs::path log = folder / "whole.log";
  write_content(log, bytes_of(game_records(folder)));
  const RefereedLog whole = refereed(log);
  const auto has = [&whole](referee::Event event) {
    return std::any_of(whole.decisions.begin(), whole.decisions.end(),
                       [event](const referee::Decision& d) { return d.finding.event == event; });
  };
  EXPECT_TRUE(has(referee::Event::kCornerKick));
  EXPECT_TRUE(has(referee::Event::kAttackerStaysNearArea));
  for (const char* kind : {"vision", "referee", "tracker", "index"})
    EXPECT_NE(whole.report.find(kind), std::string::npos) << whole.report;
}

}  // namespace
}  // namespace autoref::logs
