#include "live/controller/ci_connection.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <future>
#include <thread>

#include "io/errors.hpp"
#include "league/team/delimited.hpp"

namespace autoref::live {
namespace {

using std::chrono::milliseconds;

// A controller that answers each input with outputs whose command counters are in a list.
class ListedController {
 public:
  struct Output {
    std::uint32_t counter = 0;
    milliseconds later{0};  // how long after the one before
  };

  ListedController() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(socket_, any, size), 0);
    EXPECT_EQ(listen(socket_, 1), 0);
    EXPECT_EQ(getsockname(socket_, any, &size), 0);
    address_ = {kLoopback, ntohs(address.sin_port)};
  }
  ~ListedController() {
    if (thread_.joinable()) thread_.join();
    close(socket_);
  }
  ListedController(const ListedController&) = delete;
  ListedController& operator=(const ListedController&) = delete;

  // Accepts one connection, sends the outputs after the first input, and closes the connection once
  // its client has.
  void run(std::vector<Output> outputs) {
    thread_ = std::thread([this, outputs = std::move(outputs)] {
      const int client = accept(socket_, nullptr, nullptr);
      std::array<char, 4096> buffer;
      ASSERT_GT(recv(client, buffer.data(), buffer.size(), 0), 0);
      for (const Output& output : outputs) {
        std::this_thread::sleep_for(output.later);
        league::CiOutput message;
        league::RefereePacket& packet = *message.mutable_referee_msg();
        packet.set_command_counter(output.counter);
        for (league::TeamInfo* team : {packet.mutable_yellow(), packet.mutable_blue()}) {
          team->set_name("");
          team->set_score(0);
          team->set_red_cards(0);
          team->set_yellow_cards(0);
          team->set_timeouts(0);
          team->set_timeout_time(0);
          team->set_goalkeeper(0);
        }
        packet.set_packet_timestamp(0);
        packet.set_stage(0);
        packet.set_command(0);
        packet.set_command_timestamp(0);
        std::string bytes;
        league::append_delimited(message, bytes);
        ASSERT_EQ(send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
      }
      while (recv(client, buffer.data(), buffer.size(), 0) > 0) {
      }
      close(client);
    });
  }

  const Address& address() const { return address_; }

 private:
  int socket_;
  Address address_;
  std::thread thread_;
};

std::uint32_t counter_of(const std::optional<league::CiOutput>& output) {
  return output ? output->referee_msg().command_counter() : 0;
}

TEST(CiConnectionTest, AnInputIsAnsweredByAnOutput) {
  ListedController controller;
  controller.run({{1}});
  CiConnection connection(controller.address());
  EXPECT_EQ(counter_of(connection.exchange({})), 1U);
}

TEST(CiConnectionTest, OutputsOfChangesMayComeLater) {
  ListedController controller;
  controller.run({{1}, {2, milliseconds(100)}, {3}});
  CiConnection connection(controller.address());
  connection.exchange({});
  const auto is_second = [](const league::CiOutput& output) { return counter_of(output) == 2; };
  EXPECT_EQ(counter_of(connection.read_until(is_second, milliseconds(5000))), 2U);
  EXPECT_EQ(counter_of(connection.read_until_silence(milliseconds(200))), 3U);
}

TEST(CiConnectionTest, AConditionThatIsNeverMetIsNotAwaitedForEver) {
  ListedController controller;
  controller.run({{1}, {2, milliseconds(100)}});
  CiConnection connection(controller.address());
  connection.exchange({});
  const auto is_second = [](const league::CiOutput& output) { return counter_of(output) == 2; };
  connection.read_until(is_second, milliseconds(5000));
  const auto never = [](const league::CiOutput&) { return false; };
  EXPECT_EQ(connection.read_until(never, milliseconds(1)), std::nullopt);
  EXPECT_EQ(connection.read_until_silence(), std::nullopt);
}

TEST(CiConnectionTest, NoControllerIsAnErrorThatNamesTheAddress) {
  Address address;
  {
    const ListedController controller;
    address = controller.address();
  }
  try {
    const CiConnection connection(address);
    FAIL() << "connected";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(address.host), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace autoref::live
