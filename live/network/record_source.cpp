#include "live/network/record_source.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <utility>  // needed before Asio in Boost 1.74

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstring>

#include "live/network/network_context.hpp"

namespace autoref::live {
namespace {

constexpr int kSourceBuffer_bytes = 1 << 22;
constexpr int kMostFromSocket = 4096;  // packets read from a socket before others get their turn
constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr const char* kEveryHost = "255.255.255.255";

std::int64_t arrival_ns(msghdr& message) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec time{};
    std::memcpy(&time, CMSG_DATA(part), sizeof time);
    return time.tv_sec * kNsPerS + time.tv_nsec;
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace

class RecordSource::Socket {
 public:
  Socket(const std::string& interface, const RecordGroup& group) : kind_(group.kind), socket_(io_) {
    open_for_group(socket_, {interface, group.group, group.port, group.flag}, kSourceBuffer_bytes);
    const int on = 1;
    ::setsockopt(handle(), SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
    // Sets a buffer larger than the system's limit if the user is allowed to exceed it.
    ::setsockopt(handle(), SOL_SOCKET, SO_RCVBUFFORCE, &kSourceBuffer_bytes,
                 sizeof kSourceBuffer_bytes);
  }

  int handle() { return socket_.native_handle(); }
  int port() const { return socket_.local_endpoint().port(); }

  // Adds the waiting packets to `records` and returns how many were too long.
  int read(std::deque<ReceivedRecord>& records) {
    int oversized = 0;
    for (int i = 0; i < kMostFromSocket; ++i) {
      sockaddr_in from{};
      iovec part{buffer_.data(), buffer_.size()};
      alignas(cmsghdr) std::array<char, 256> control{};
      msghdr message{};
      message.msg_name = &from;
      message.msg_namelen = sizeof from;
      message.msg_iov = &part;
      message.msg_iovlen = 1;
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      const ssize_t size = ::recvmsg(handle(), &message, MSG_DONTWAIT);
      if (size < 0) break;
      if ((message.msg_flags & MSG_TRUNC) != 0) {
        ++oversized;
        continue;
      }
      records.push_back({arrival_ns(message), kind_,
                         std::string(buffer_.data(), static_cast<std::size_t>(size)),
                         host_of(from)});
    }
    return oversized;
  }

 private:
  static std::string host_of(const sockaddr_in& from) {
    return boost::asio::ip::address_v4(ntohl(from.sin_addr.s_addr)).to_string();
  }

  league::MessageKind kind_;
  boost::asio::io_context io_;
  boost::asio::ip::udp::socket socket_;
  std::array<char, kLongestDatagram> buffer_{};
};

RecordSource::RecordSource(const std::string& interface, const std::vector<RecordGroup>& groups) {
  sockets_.reserve(groups.size());
  for (const RecordGroup& group : groups)
    sockets_.push_back(std::make_unique<Socket>(interface, group));
  for (RecordGroup group : groups) {
    if (group.group.empty()) continue;
    std::vector<std::string> addresses;
    if (const auto network = broadcast_address(interface)) addresses.push_back(*network);
    if (interface != kLoopback) addresses.emplace_back(kEveryHost);
    for (std::string& address : addresses) {
      group.group = std::move(address);
      sockets_.push_back(std::make_unique<Socket>(interface, group));
    }
  }
}

RecordSource::~RecordSource() = default;

std::optional<ReceivedRecord> RecordSource::next(Clock::time_point deadline) {
  if (records_.empty() && wait(deadline)) read_all();
  if (records_.empty()) return std::nullopt;
  ReceivedRecord record = std::move(records_.front());
  records_.pop_front();
  return record;
}

bool RecordSource::wait(Clock::time_point deadline) {
  std::vector<pollfd> handles;
  handles.reserve(sockets_.size());
  for (const auto& socket : sockets_) handles.push_back({socket->handle(), POLLIN, 0});
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  const int timeout_ms = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1000));
  return ::poll(handles.data(), handles.size(), timeout_ms) > 0;
}

void RecordSource::read_all() {
  for (auto socket = sockets_.rbegin(); socket != sockets_.rend(); ++socket)
    oversized_ += (*socket)->read(records_);
  std::stable_sort(
      records_.begin(), records_.end(),
      [](const ReceivedRecord& a, const ReceivedRecord& b) { return a.arrived_ns < b.arrived_ns; });
}

int RecordSource::port(std::size_t group) const { return sockets_.at(group)->port(); }

}  // namespace autoref::live
