#include "runner/live/record_source.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "runner/io/errors.hpp"

namespace autoref::runner {
namespace {

using league::MessageKind;

// Two ports of this computer instead of the league's groups.
class RecordSourceTest : public testing::Test {
 protected:
  std::string next() {
    const auto record = source_.take(RecordSource::Clock::now() + std::chrono::seconds(1));
    if (!record) return "nothing";
    return (record->kind == MessageKind::kVision2014 ? "vision " : "referee ") + record->bytes;
  }

  RecordSource source_{kLoopback,
                       {{MessageKind::kVision2014, "", 0, "--vision-port"},
                        {MessageKind::kReferee2013, "", 0, "--referee-port"}}};
  DatagramSender vision_{kLoopback, {kLoopback, source_.port(0)}};
  DatagramSender referee_{kLoopback, {kLoopback, source_.port(1)}};
};

TEST_F(RecordSourceTest, PacketsOfSeveralPortsComeInTheOrderOfTheirArrival) {
  // Linux begins to note times of arrival a little after the first socket has asked for them.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
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
  const auto record = source_.take(RecordSource::Clock::now() + std::chrono::seconds(10));
  ASSERT_TRUE(record);
  EXPECT_EQ(record->host, kLoopback);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto age_ns = std::chrono::nanoseconds(now).count() - record->arrived_ns;
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
  EXPECT_FALSE(source_.take(RecordSource::Clock::now()));
}

TEST(RecordSource, AnAddressOfAnotherComputerIsAnError) {
  EXPECT_THROW(RecordSource("192.0.2.1", {{MessageKind::kVision2014, "", 0, "--vision-port"}}),
               InputError);
}

}  // namespace
}  // namespace autoref::runner
