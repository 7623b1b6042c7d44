// Receives vision, referee and tracker packets from the network, in the order of their arrival.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "league/log_file.hpp"
#include "live/network/network.hpp"

namespace autoref::live {

struct ReceivedRecord {
  std::int64_t arrived_ns = 0;  // Unix time at which the packet arrived at this computer
  league::MessageKind kind = league::MessageKind::kUnknown;
  std::string bytes;
  std::string host;  // host that sent the packet

  // The time from `first_ns` to the arrival, in s.
  double arrived_after_s(std::int64_t first_ns) const {
    return static_cast<double>(arrived_ns - first_ns) * 1e-9;
  }
};

// A multicast group to listen to. Packets that are broadcast to its port are received as well.
// `flag` is the option that sets the port.
struct RecordGroup {
  league::MessageKind kind = league::MessageKind::kUnknown;
  std::string group;  // empty: packets sent to this computer
  int port = 0;       // 0: any free port
  std::string flag;
};

// Reads the sockets in the caller's thread. The system buffers up to 4 MB of unread packets, or as
// much as it allows; datagrams longer than kLongestDatagram are dropped and counted.
class RecordSource {
 public:
  using Clock = std::chrono::steady_clock;

  // Throws InputError if a group cannot be joined. Waiting packets of several groups are read in
  // the order of their arrival. The first group is read last, so that packets of this group that
  // arrive in the meantime do not overtake packets of the other groups.
  RecordSource(const std::string& interface, const std::vector<RecordGroup>& groups);
  ~RecordSource();
  RecordSource(const RecordSource&) = delete;
  RecordSource& operator=(const RecordSource&) = delete;

  // The next packet; nullopt if none arrives by the deadline.
  std::optional<ReceivedRecord> next(Clock::time_point deadline);

  int port(std::size_t group) const;
  std::int64_t oversized() const { return oversized_; }

 private:
  class Socket;
  bool wait(Clock::time_point deadline);
  void read_all();

  std::vector<std::unique_ptr<Socket>> sockets_;
  std::deque<ReceivedRecord> records_;
  std::int64_t oversized_ = 0;
};

}  // namespace autoref::live
