#include "tests/logs/mutated_log.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "league/messages/referee.pb.h"
#include "league/messages/tracker.pb.h"
#include "league/messages/vision.pb.h"
#include "tests/logs/mutated_message.hpp"

namespace autoref::logs {
namespace {

using league::LogRecord;
using league::MessageKind;
using Records = std::vector<LogRecord>;

constexpr std::int64_t kMutatedSecond_ns = 1'000'000'000;

void put_number(std::uint64_t number, int bytes, std::string& text) {
  for (int byte = bytes - 1; byte >= 0; --byte)
    text.push_back(static_cast<char>(number >> (8 * byte) & 0xff));
}

std::size_t below(std::size_t count, RandomStream& chance) {
  return static_cast<std::size_t>(chance.uniform() * static_cast<double>(count));
}

// A random part of the records: one, some that follow each other, or all.
std::pair<std::size_t, std::size_t> part_of(const Records& records, RandomStream& chance) {
  const double size = chance.uniform();
  if (size < 0.2) return {0, records.size()};
  const std::size_t first = below(records.size(), chance);
  const std::size_t count = size < 0.5 ? 1 : 1 + below(records.size() / 2, chance);
  return {first, std::min(records.size(), first + count)};
}

void drop(Records& records, RandomStream& chance) {
  const auto [first, last] = part_of(records, chance);
  if (first == 0 && last == records.size()) return;
  records.erase(records.begin() + static_cast<std::ptrdiff_t>(first),
                records.begin() + static_cast<std::ptrdiff_t>(last));
}

void drop_kind(Records& records, RandomStream& chance) {
  const std::int32_t kind = records[below(records.size(), chance)].kind;
  std::erase_if(records, [kind](const LogRecord& record) { return record.kind == kind; });
}

void repeat(Records& records, RandomStream& chance) {
  const auto [first, last] = part_of(records, chance);
  const Records again(records.begin() + static_cast<std::ptrdiff_t>(first),
                      records.begin() + static_cast<std::ptrdiff_t>(last));
  const std::size_t at = below(records.size(), chance);
  records.insert(records.begin() + static_cast<std::ptrdiff_t>(at), again.begin(), again.end());
}

void reorder(Records& records, RandomStream& chance) {
  const auto [first, last] = part_of(records, chance);
  for (std::size_t i = first; i < last; ++i)
    std::swap(records[i], records[below(records.size(), chance)]);
}

void cut_short(Records& records, RandomStream& chance) {
  std::string& message = records[below(records.size(), chance)].message;
  message.resize(below(message.size() + 1, chance));
}

void flip_bytes(Records& records, RandomStream& chance) {
  const auto [first, last] = part_of(records, chance);
  for (std::size_t i = first; i < last; ++i) {
    std::string& message = records[i].message;
    if (message.empty()) continue;
    message[below(message.size(), chance)] = static_cast<char>(chance() & 0xff);
  }
}

void change_kind(Records& records, RandomStream& chance) {
  records[below(records.size(), chance)].kind = static_cast<std::int32_t>(below(9, chance)) - 1;
}

void change_times(Records& records, RandomStream& chance) {
  const std::array<std::int64_t, 8> steps_ns = {1,
                                                -1,
                                                kMutatedSecond_ns / 10,
                                                -kMutatedSecond_ns,
                                                -100 * kMutatedSecond_ns,
                                                1'700'000'000 * kMutatedSecond_ns,
                                                std::numeric_limits<std::int64_t>::max(),
                                                std::numeric_limits<std::int64_t>::min()};
  const std::int64_t step_ns = steps_ns[below(steps_ns.size(), chance)];
  const auto [first, last] = part_of(records, chance);
  for (std::size_t i = first; i < last; ++i) {
    records[i].time_ns = static_cast<std::int64_t>(static_cast<std::uint64_t>(records[i].time_ns) +
                                                   static_cast<std::uint64_t>(step_ns));
  }
}

template <typename Packet>
void change_packet(LogRecord& record, RandomStream& chance) {
  Packet packet;
  if (!packet.ParsePartialFromString(record.message)) return;
  mutate(packet, chance);
  record.message = packet.SerializePartialAsString();
}

// Changes the same field to the same value in part of the packets.
void change_fields(Records& records, RandomStream& chance) {
  const std::int32_t kind = records[below(records.size(), chance)].kind;
  const std::uint64_t seed = chance();
  const auto [first, last] = part_of(records, chance);
  for (std::size_t i = first; i < last; ++i) {
    if (records[i].kind != kind) continue;
    RandomStream same(seed);
    if (kind == static_cast<std::int32_t>(MessageKind::kVision2014))
      change_packet<league::VisionPacket>(records[i], same);
    if (kind == static_cast<std::int32_t>(MessageKind::kReferee2013))
      change_packet<league::RefereePacket>(records[i], same);
    if (kind == static_cast<std::int32_t>(MessageKind::kTracker2020))
      change_packet<league::TrackerPacket>(records[i], same);
  }
}

// Changes bytes anywhere, such as those of sizes, or cuts the file off.
void damage(std::string& bytes, RandomStream& chance) {
  if (chance.uniform() < 0.3) bytes.resize(below(bytes.size(), chance));
  const std::size_t count = bytes.empty() ? 0 : below(4, chance);
  for (std::size_t i = 0; i < count; ++i)
    bytes[below(bytes.size(), chance)] = static_cast<char>(chance() & 0xff);
}

using Mutation = void (*)(Records& records, RandomStream& chance);
// Fields are what matters most.
constexpr std::array<Mutation, 14> kMutations = {
    drop,          drop_kind,     repeat,        reorder,       cut_short,
    flip_bytes,    change_kind,   change_times,  change_fields, change_fields,
    change_fields, change_fields, change_fields, change_fields};

}  // namespace

std::vector<LogRecord> records_in(const std::filesystem::path& log) {
  Records records;
  league::LogReader reader(log);
  for (LogRecord record; reader.read(record);) records.push_back(record);
  return records;
}

std::string bytes_of(const std::vector<LogRecord>& records) {
  std::string bytes = "SSL_LOG_FILE";
  put_number(1, 4, bytes);
  for (const LogRecord& record : records) {
    put_number(static_cast<std::uint64_t>(record.time_ns), 8, bytes);
    put_number(static_cast<std::uint32_t>(record.kind), 4, bytes);
    put_number(record.message.size(), 4, bytes);
    bytes += record.message;
  }
  return bytes;
}

std::string mutated(std::vector<LogRecord> records, std::uint64_t seed) {
  RandomStream chance(seed);
  const std::size_t count = 1 + below(8, chance);
  for (std::size_t i = 0; i < count && !records.empty(); ++i)
    kMutations[below(kMutations.size(), chance)](records, chance);
  std::string bytes = bytes_of(records);
  if (chance.uniform() < 0.2) damage(bytes, chance);
  return bytes;
}

}  // namespace autoref::logs
