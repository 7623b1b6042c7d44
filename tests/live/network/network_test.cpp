#include "live/network/network.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>
#include <vector>

#include "io/errors.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::seconds kPatience{60};

TEST(Network, ADatagramArrivesWithItsSender) {
  NetworkThread thread;
  std::promise<std::string> arrived;
  const DatagramReceiver receiver(thread, {}, [&](std::string_view bytes, const Address& from) {
    arrived.set_value(std::string(bytes) + " from " + from.host);
    return std::nullopt;
  });
  DatagramSender sender(kLoopback, {kLoopback, receiver.port()});
  sender.send("hello");
  std::future<std::string> result = arrived.get_future();
  ASSERT_EQ(result.wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(result.get(), "hello from 127.0.0.1");
  EXPECT_EQ(sender.dropped(), 0);
}

TEST(Network, AnEmptyAnswerIsSent) {
  NetworkThread thread;
  std::promise<std::size_t> answered;
  DatagramReceiver asking(thread, {}, [&](std::string_view bytes, const Address&) {
    answered.set_value(bytes.size());
    return std::nullopt;
  });
  const DatagramReceiver answering(thread, {},
                                   [](std::string_view, const Address&) { return std::string(); });
  asking.send("hello", {kLoopback, answering.port()});
  std::future<std::size_t> result = answered.get_future();
  ASSERT_EQ(result.wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(result.get(), 0U);
}

TEST(Network, OversizedDatagramsAreCountedAndDropped) {
  NetworkThread thread;
  std::promise<std::size_t> arrived;
  const DatagramReceiver receiver(thread, {}, [&](std::string_view bytes, const Address&) {
    arrived.set_value(bytes.size());
    return std::nullopt;
  });
  DatagramSender sender(kLoopback, {kLoopback, receiver.port()});
  sender.send(std::string(kLongestDatagram + 1, 'x'));
  sender.send(std::string(kLongestDatagram, 'x'));
  std::future<std::size_t> result = arrived.get_future();
  ASSERT_EQ(result.wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(result.get(), kLongestDatagram);
  EXPECT_EQ(receiver.oversized(), 1);
}

TEST(Network, APortInUseIsAnErrorThatNamesItsOption) {
  NetworkThread thread;
  const auto ignore = [](std::string_view, const Address&) { return std::nullopt; };
  const DatagramReceiver first(thread, {}, ignore);
  try {
    const DatagramReceiver second(thread, {kLoopback, "", first.port(), "--blue-port"}, ignore);
    FAIL() << "the port is free";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--blue-port"), std::string::npos) << error.what();
  }
}

TEST(Network, AnAddressThatIsNoneIsAnError) {
  EXPECT_THROW(DatagramSender("localhost", {kLoopback, 1}), io::InputError);
  EXPECT_THROW(DatagramSender(kLoopback, {"somewhere", 1}), io::InputError);
}

}  // namespace
}  // namespace autoref::live
