// What networks and recorders do to the packets of a game does not change how it is judged, and is
// said.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <functional>
#include <optional>
#include <regex>
#include <thread>

#include "io/errors.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/logs/sketched_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

using league::LogRecord;
using league::MessageKind;
using Records = std::vector<LogRecord>;

MessageKind kind_of(const LogRecord& record) { return static_cast<MessageKind>(record.kind); }

std::optional<std::uint32_t> camera_of(const LogRecord& record) {
  league::VisionPacket packet;
  const bool is_detection = kind_of(record) == MessageKind::kVision2014 &&
                            packet.ParseFromString(record.message) && packet.has_detection();
  return is_detection ? std::optional(packet.detection().camera_id()) : std::nullopt;
}

LogRecord with_clock_ahead(const LogRecord& record, double ahead_s) {
  league::VisionPacket packet;
  packet.ParseFromString(record.message);
  packet.mutable_detection()->set_t_capture(packet.detection().t_capture() + ahead_s);
  return {record.time_ns, record.kind, packet.SerializeAsString()};
}

// A packet of another game controller, in HALT before the first half.
LogRecord packet_of_another_controller(const LogRecord& record) {
  league::RefereePacket packet;
  packet.ParseFromString(record.message);
  packet.set_stage(0);
  packet.set_command(0);
  packet.set_command_counter(1);
  packet.set_source_identifier("forgotten\n");
  return {record.time_ns, record.kind, packet.SerializeAsString()};
}

std::string packets_of_cameras(const std::string& info) {
  const std::size_t begin = info.find("camera ");
  return info.substr(begin, info.find("\n\n", begin) - begin);
}

class DisturbedLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TemporaryFolder folder;
    const std::string log = folder / "game.log";
    const std::string game = in_checkout("scenarios/paper-game.yaml");
    const app::Answer played = app::answer_to(
        {"play", game.c_str(), "--set", "match.rules=2026-b", "--set", "sim.camera=realistic",
         "--set", "match.half_s=60", "--set", "a.strategy=cobalt", "--set", "b.strategy=counter",
         "--seed", "9", "--log", log.c_str()});
    ASSERT_EQ(played.code, io::kDone) << played.err;
    league::LogReader reader(log);
    LogRecord record;
    while (reader.read(record)) whole_.push_back(record);
    judged_ = referee_answer(log);
    std::smatch calls;
    ASSERT_TRUE(std::regex_search(judged_.out, calls, std::regex(", (\\d+) by AutoRef")));
    ASSERT_GE(std::stoi(calls[1]), 5) << judged_.out;
    ASSERT_EQ(judged_.err, "");
    cameras_ = packets_of_cameras(app::answer_to({"log", "info", log.c_str()}).out);
  }

  static app::Answer referee_answer(const std::string& log) {
    return app::answer_to(
        {"referee", "log", log.c_str(), "--camera", "realistic", "--rules", "2026-b"});
  }

  void write(const Records& records, const std::string& name = "disturbed.log") const {
    league::LogWriter writer(folder_ / name);
    for (const LogRecord& record : records)
      writer.write(record.time_ns, kind_of(record), record.message);
    writer.close();
  }

  // Writes the log with each record replaced.
  void write_each(const std::function<void(const LogRecord&, Records&)>& replace) const {
    Records records;
    for (const LogRecord& record : whole_) replace(record, records);
    write(records);
  }

  // The same calls and the same packets of every camera; `said` is said once, and nothing else.
  void expect_judged_alike(const std::string& said) const {
    const app::Answer answer = referee_answer(log_);
    EXPECT_EQ(answer.code, io::kDone);
    EXPECT_EQ(answer.out, judged_.out);
    EXPECT_EQ(answer.err, said.empty() ? "" : "autoref: " + log_ + ": " + said + "\n");
    EXPECT_EQ(packets_of_cameras(app::answer_to({"log", "info", log_.c_str()}).out), cameras_);
  }

  static inline Records whole_;
  static inline app::Answer judged_;
  static inline std::string cameras_;
  TemporaryFolder folder_;
  std::string log_ = folder_ / "disturbed.log";
};

TEST_F(DisturbedLog, WithEveryPacketTwice) {
  std::int64_t copies = 0;
  write_each([&copies](const LogRecord& record, Records& records) {
    records.insert(records.end(), 2, record);
    copies += camera_of(record) || kind_of(record) == MessageKind::kReferee2013 ? 1 : 0;
  });
  expect_judged_alike(std::to_string(copies) + " messages are ignored as duplicates");
}

TEST_F(DisturbedLog, WithACopyOfEveryPacketTwoFramesLater) {
  std::int64_t copies = 0;
  Records waiting;
  write_each([&](const LogRecord& record, Records& records) {
    constexpr std::size_t kBehind = 8;
    records.push_back(record);
    waiting.push_back(record);
    if (waiting.size() <= kBehind) return;
    const LogRecord& copy = waiting[waiting.size() - 1 - kBehind];
    records.push_back({record.time_ns, copy.kind, copy.message});
    copies += camera_of(copy) || kind_of(copy) == MessageKind::kReferee2013 ? 1 : 0;
  });
  expect_judged_alike(std::to_string(copies) + " messages are ignored as duplicates");
}

TEST_F(DisturbedLog, WithASecondGameController) {
  std::int64_t others = 0;
  write_each([&others](const LogRecord& record, Records& records) {
    records.push_back(record);
    if (kind_of(record) != MessageKind::kReferee2013) return;
    records.push_back(packet_of_another_controller(record));
    ++others;
  });
  expect_judged_alike(std::to_string(others) +
                      " packets are from another referee and ignored, first from 'forgotten?'; the "
                      "referee followed is one without a name");
}

TEST_F(DisturbedLog, WithoutTheKindsOfItsMessages) {
  write_each([](const LogRecord& record, Records& records) {
    records.push_back({record.time_ns, static_cast<int>(MessageKind::kUnknown), record.message});
  });
  expect_judged_alike("");
  // Every other message only, as after cutting logs of two recorders together.
  int count = 0;
  write_each([&count](const LogRecord& record, Records& records) {
    const MessageKind kind = ++count % 2 == 0 ? MessageKind::kUnknown : kind_of(record);
    records.push_back({record.time_ns, static_cast<int>(kind), record.message});
  });
  expect_judged_alike("");
}

TEST_F(DisturbedLog, WithAnUnknownMessage) {
  write_each([](const LogRecord& record, Records& records) {
    records.push_back(record);
    if (records.size() == 1)
      records.push_back({record.time_ns, static_cast<int>(MessageKind::kUnknown), "something"});
  });
  expect_judged_alike("1 message is of an unknown kind and ignored");
}

TEST_F(DisturbedLog, WithClocksOfTwoComputers) {
  for (const double ahead_s : {-0.03, 0.02, 0.5, 86400.0}) {
    write_each([ahead_s](const LogRecord& record, Records& records) {
      const bool is_other = camera_of(record).value_or(0) >= 2;
      records.push_back(is_other ? with_clock_ahead(record, ahead_s) : record);
    });
    const std::string apart =
        fmt::format("{:.3f} s {}", std::abs(ahead_s), ahead_s < 0 ? "behind" : "ahead");
    expect_judged_alike(fmt::format(
        "the cameras' clocks differ and were corrected: camera 2's is {0}, camera 3's is {0}",
        apart));
  }
}

// Only what these packets showed may be judged otherwise.
TEST_F(DisturbedLog, WithLostPacketsLosesNothingElse) {
  int detections = 0;
  int lost = 0;
  write_each([&](const LogRecord& record, Records& records) {
    const bool is_lost = camera_of(record) && ++detections % 97 == 0;
    lost += is_lost ? 1 : 0;
    if (!is_lost) records.push_back(record);
  });
  EXPECT_GT(lost, 20);
  EXPECT_EQ(referee_answer(log_).err, "");
  const std::string info = app::answer_to({"log", "info", log_.c_str(), "--json"}).out;
  EXPECT_NE(info.find("\"late\": 0"), std::string::npos) << info;
  std::ptrdiff_t used = 0;
  const std::regex packets("\"packets\": (\\d+)");
  for (std::sregex_iterator one(info.begin(), info.end(), packets); one != std::sregex_iterator();
       ++one)
    used += std::stol((*one)[1]);
  EXPECT_EQ(used, detections - lost);
}

TEST_F(DisturbedLog, InPartsThatAreAppendedToEachOther) {
  const std::size_t half = whole_.size() / 2;
  for (const char* ending : {"log", "log.gz"}) {
    write({whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(half)},
          std::string("one.") + ending);
    write({whole_.begin() + static_cast<std::ptrdiff_t>(half), whole_.end()},
          std::string("two.") + ending);
    write_content(log_, content_of(folder_ / (std::string("one.") + ending)) +
                            content_of(folder_ / (std::string("two.") + ending)));
    expect_judged_alike("");
  }
}

TEST_F(DisturbedLog, FromAPipe) {
  write(whole_, "game.log.gz");
  for (const char* verb : {"referee", "info"}) {
    ASSERT_EQ(::mkfifo(log_.c_str(), 0600), 0);
    std::thread writer(
        [this] { write_content(log_, content_of(folder_ / "game.log.gz"), std::ios::app); });
    const app::Answer answer = verb == std::string("referee")
                                   ? referee_answer(log_)
                                   : app::answer_to({"log", "info", log_.c_str()});
    writer.join();
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
    if (verb == std::string("referee")) {
      EXPECT_EQ(answer.out, judged_.out);
    } else {
      EXPECT_EQ(packets_of_cameras(answer.out), cameras_);
    }
    std::filesystem::remove(log_);
  }
}

// Nobody has switched the ends in the controller after half-time.
TEST_F(DisturbedLog, WhoseEndsWereNotSwitchedIsJudgedByThoseThatAreSeen) {
  std::optional<bool> first;
  write_each([&first](const LogRecord& record, Records& records) {
    records.push_back(record);
    league::RefereePacket packet;
    if (kind_of(record) != MessageKind::kReferee2013 || !packet.ParseFromString(record.message))
      return;
    first = first.value_or(packet.blue_team_on_positive_half());
    packet.set_blue_team_on_positive_half(*first);
    records.back().message = packet.SerializeAsString();
  });
  expect_judged_alike(
      "the referee packets and the positions of both keepers disagree about which ends the teams "
      "defend in "
      "SECOND_HALF_PRE, SECOND_HALF; using the keepers' positions");
}

// Nor at the beginning, so that they are wrong in the first half and right in the second.
TEST_F(DisturbedLog, WhoseEndsAreWrongFromTheBeginningIsJudgedByThoseThatAreSeen) {
  write_each([](const LogRecord& record, Records& records) {
    records.push_back(record);
    league::RefereePacket packet;
    if (kind_of(record) != MessageKind::kReferee2013 || !packet.ParseFromString(record.message))
      return;
    packet.set_blue_team_on_positive_half(!packet.blue_team_on_positive_half());
    records.back().message = packet.SerializeAsString();
  });
  const app::Answer answer = referee_answer(log_);
  EXPECT_EQ(answer.out, judged_.out);
  EXPECT_NE(answer.err.find("the positions of both keepers disagree"), std::string::npos)
      << answer.err;
}

// A recorder that is killed leaves what it had written; what is missing is the last second.
TEST_F(DisturbedLog, OfARecorderThatWasKilled) {
  for (const char* ending : {"log", "log.gz"}) {
    const std::filesystem::path path = folder_ / (std::string("killed.") + ending);
    league::LogWriter writer(path);
    std::int64_t last_ns = 0;
    for (const LogRecord& record : whole_) {
      writer.write(record.time_ns, kind_of(record), record.message);
      last_ns = record.time_ns;
      if (last_ns > 13'700'000'000) break;
    }
    write_content(log_, content_of(path));  // as it is on the disk now
    const app::Answer info = app::answer_to({"log", "info", log_.c_str(), "--json"});
    const std::size_t at = info.out.find("\"length_s\": ");
    ASSERT_NE(at, std::string::npos) << info.err;
    EXPECT_GT(std::stod(info.out.substr(at + 12)), 1e-9 * static_cast<double>(last_ns) - 1.02)
        << ending;
  }
}

}  // namespace
}  // namespace autoref::logs
