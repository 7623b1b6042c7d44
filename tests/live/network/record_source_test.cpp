#include "live/network/record_source.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "benchmarks/beside_live_game.hpp"
#include "io/errors.hpp"
#include "live/live_options.hpp"
#include "live/network/network.hpp"

namespace autoref::live {
namespace {

using league::MessageKind;

// Two ports of this computer instead of the league's groups.
class RecordSourceTest : public testing::Test {
 protected:
  // The next packet, which may take a minute.
  std::optional<ReceivedRecord> next_record() {
    const auto deadline = RecordSource::Clock::now() + std::chrono::minutes(1);
    std::optional<ReceivedRecord> record;
    while (!record && RecordSource::Clock::now() < deadline) record = source_.next(deadline);
    return record;
  }
  std::string next() {
    const auto record = next_record();
    if (!record) return "nothing";
    return (record->kind == MessageKind::kVision2014 ? "vision " : "referee ") + record->bytes;
  }

  // Linux begins to note times of arrival a little after the first socket has asked for them;
  // until then, a packet has the time at which it is read.
  void wait_for_times_of_arrival() {
    for (int attempt = 0; attempt < 6000; ++attempt) {
      vision_.send("0");
      const std::int64_t sent_ns = now_ns();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      const auto record = next_record();
      if (record && record->arrived_ns <= sent_ns) return;
    }
    FAIL() << "no times of arrival";
  }

  static std::int64_t now_ns() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::nanoseconds(now).count();
  }

  RecordSource source_{kLoopback,
                       {{MessageKind::kVision2014, "", 0, "--vision-port"},
                        {MessageKind::kReferee2013, "", 0, "--referee-port"}}};
  DatagramSender vision_{kLoopback, {kLoopback, source_.port(0)}};
  DatagramSender referee_{kLoopback, {kLoopback, source_.port(1)}};
};

TEST_F(RecordSourceTest, PacketsOfSeveralPortsComeInTheOrderOfTheirArrival) {
  ASSERT_NO_FATAL_FAILURE(wait_for_times_of_arrival());
  vision_.send("1");
  referee_.send("2");
  vision_.send("3");
  referee_.send("4");
  EXPECT_EQ(next(), "vision 1");
  EXPECT_EQ(next(), "referee 2");
  EXPECT_EQ(next(), "vision 3");
  EXPECT_EQ(next(), "referee 4");
}

TEST_F(RecordSourceTest, APacketComesWithItsSenderAndTheTimeOfArrival) {
  vision_.send("1");
  const auto record = next_record();
  ASSERT_TRUE(record);
  EXPECT_EQ(record->host, kLoopback);
  const std::int64_t age_ns = now_ns() - record->arrived_ns;
  EXPECT_GE(age_ns, 0);
  EXPECT_LT(age_ns, 100'000'000'000);
}

TEST_F(RecordSourceTest, OversizedPacketsAreCountedAndDropped) {
  vision_.send(std::string(kLongestDatagram + 1, 'x'));
  vision_.send("2");
  EXPECT_EQ(next(), "vision 2");
  EXPECT_EQ(source_.oversized(), 1);
}

TEST_F(RecordSourceTest, WithoutPacketsNothingIsTakenByTheDeadline) {
  EXPECT_FALSE(source_.next(RecordSource::Clock::now()));
}

TEST(RecordSource, AnAddressOfAnotherComputerIsAnError) {
  EXPECT_THROW(RecordSource("192.0.2.1", {{MessageKind::kVision2014, "", 0, "--vision-port"}}),
               io::InputError);
}

// Networks that do not pass multicast on: the league's game controller can broadcast.
TEST(RecordSourceOfAGroup, ReceivesWhatIsBroadcast) {
  NetworkThread thread;
  const int port = benchmarks::free_ports(thread, 1)[0];
  RecordSource source(kLoopback,
                      {{MessageKind::kReferee2013, kRefereeGroup, port, "--referee-port"}});
  DatagramSender everybody(kLoopback, {*broadcast_address(kLoopback), port});
  everybody.send("stop");
  const auto deadline = RecordSource::Clock::now() + std::chrono::minutes(1);
  std::optional<ReceivedRecord> record;
  while (!record && RecordSource::Clock::now() < deadline) record = source.next(deadline);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->kind, MessageKind::kReferee2013);
  EXPECT_EQ(record->bytes, "stop");
}

TEST(BroadcastAddress, BelongsToAnInterface) {
  EXPECT_EQ(broadcast_address(kLoopback), "127.255.255.255");
  EXPECT_EQ(broadcast_address("192.0.2.99"), std::nullopt);
}

}  // namespace
}  // namespace autoref::live
