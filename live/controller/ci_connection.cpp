#include "live/controller/ci_connection.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "io/errors.hpp"
#include "league/team/delimited.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::live {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kNoWait{0};

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses addresses_of(const Address& address) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found) != 0)
    found = nullptr;
  return {found, freeaddrinfo};
}

int milliseconds_of(milliseconds time) { return static_cast<int>(time.count()); }

// Whether the socket becomes ready for `events` within this time. A signal starts the wait again.
bool is_ready(int socket, short events, milliseconds longest_wait) {
  pollfd entry{socket, events, 0};
  int ready = 0;
  do {
    ready = poll(&entry, 1, milliseconds_of(longest_wait));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

}  // namespace

CiConnection::CiConnection(const Address& controller)
    : name_(fmt::format("{}:{}", controller.host, controller.port)) {
  const Addresses addresses = addresses_of(controller);
  if (!addresses) fail("unknown host");
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket_ < 0 || connect(socket_, addresses->ai_addr, addresses->ai_addrlen) != 0) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    fail(reason);
  }
  const int on = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

CiConnection::~CiConnection() { close(socket_); }

league::CiOutput CiConnection::exchange(const league::CiInput& input) {
  read_until_silence(kNoWait);
  send(input);
  std::optional<league::CiOutput> answer = next_output_by(steady_clock::now() + kLongestAnswer);
  if (!answer) fail("no answer");
  std::optional<league::CiOutput> newer = read_until_silence(kNoWait);
  return newer ? *std::move(newer) : *std::move(answer);
}

void CiConnection::send(const league::CiInput& input) {
  std::string bytes;
  league::append_delimited(input, bytes);
  write(bytes);
}

std::optional<league::CiOutput> CiConnection::read_until(const Condition& condition,
                                                         milliseconds longest) {
  const auto deadline = steady_clock::now() + longest;
  std::optional<league::CiOutput> newest;
  while (auto output = next_output_by(deadline)) {
    newest = std::move(output);
    if (condition(*newest)) break;
  }
  return newest;
}

std::optional<league::CiOutput> CiConnection::read_until_silence(milliseconds silence) {
  const auto deadline = steady_clock::now() + kLongestAnswer;
  std::optional<league::CiOutput> newest;
  while (auto output = next_output_by(std::min(steady_clock::now() + silence, deadline)))
    newest = std::move(output);
  return newest;
}

std::optional<league::CiOutput> CiConnection::next_output_by(steady_clock::time_point deadline) {
  while (true) {
    if (std::optional<league::CiOutput> output = next_output()) return output;
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    if (!read(std::max(left, kNoWait))) return std::nullopt;
  }
}

void CiConnection::write(const std::string& bytes) {
  std::string_view left = bytes;
  while (!left.empty()) {
    if (!is_ready(socket_, POLLOUT, kLongestAnswer)) fail("it no longer accepts input");
    const ssize_t sent = ::send(socket_, left.data(), left.size(), MSG_NOSIGNAL);
    if (sent < 0) fail(std::strerror(errno));
    left.remove_prefix(static_cast<std::size_t>(sent));
  }
}

bool CiConnection::read(milliseconds longest_wait) {
  if (!is_ready(socket_, POLLIN, longest_wait)) return false;
  std::array<char, 65536> buffer;
  const ssize_t size = recv(socket_, buffer.data(), buffer.size(), 0);
  if (size <= 0) fail("it has closed the connection");
  input_.append(buffer.data(), static_cast<std::size_t>(size));
  return true;
}

std::optional<league::CiOutput> CiConnection::next_output() {
  try {
    const auto extent = league::find_delimited(input_);
    if (!extent) return std::nullopt;
    league::CiOutput output;
    if (!output.ParseFromArray(input_.data() + extent->begin, static_cast<int>(extent->size)))
      fail("its message is not a CI mode output");
    input_.erase(0, extent->end);
    return output;
  } catch (const league::TeamFault&) {
    fail("its message is too long");
  }
}

void CiConnection::fail(const std::string& what) const {
  throw io::InputError({"--game-controller"}, "",
                       fmt::format("the game controller at {}: {}", name_, what));
}

}  // namespace autoref::live
