#include "game/team_programs/commands_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>
#include <variant>

#include "io/errors.hpp"

namespace autoref::game {
namespace {

using Format = CommandsFormat;

constexpr std::chrono::seconds kFlushEvery{1};  // of a growing file

gzFile gz_of(void* file) { return static_cast<gzFile>(file); }

template <typename Number>
void put(Number number, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put_requests(const TeamRequests& requests, std::string& bytes) {
  put(static_cast<std::int8_t>(requests.keeper), bytes);
  put(static_cast<std::int8_t>(requests.leaves.value_or(-1)), bytes);
  put(static_cast<std::uint8_t>(requests.timeout ? 1 : 0), bytes);
}

void put_command(const RobotCommand& command, const RobotCommand& last, std::string& bytes) {
  const std::array<float, 4> now = Format::numbers_of(command);
  const std::array<float, 4> before = Format::numbers_of(last);
  unsigned flags =
      (command.chip ? Format::kHasChip : 0U) | (command.dribble ? Format::kHasDribble : 0U);
  for (std::size_t i = 0; i < now.size(); ++i) flags |= now[i] != before[i] ? 1U << i : 0U;
  put(static_cast<std::uint8_t>(flags), bytes);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != before[i]) put(now[i], bytes);
  }
}

void put_commands(const TeamCommands& commands, const TeamCommands& last, std::string& bytes) {
  unsigned changed = 0;
  for (std::size_t i = 0; i < commands.size(); ++i)
    changed |= is_same(commands[i], last[i]) ? 0U : 1U << i;
  put(static_cast<std::uint16_t>(changed), bytes);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if ((changed >> i & 1U) != 0) put_command(commands[i], last[i], bytes);
  }
}

void put_vector(const Vec2& vector, std::string& bytes) {
  put(vector.x(), bytes);
  put(vector.y(), bytes);
}

void put_robot_id(RobotId robot, std::string& bytes) {
  put(static_cast<std::uint8_t>(robot.side), bytes);
  put(static_cast<std::uint8_t>(robot.number), bytes);
}

struct PutChange {
  std::string& bytes;
  void kind(unsigned kind) const {
    put(static_cast<std::uint8_t>(Format::kChange | kind << Format::kChangeShift), bytes);
  }
  void operator()(const sim::BallState& ball) const {
    kind(Format::kBall);
    put_vector(ball.position_m, bytes);
    put_vector(ball.velocity_mps, bytes);
    put(ball.height_m, bytes);
    put(ball.vertical_mps, bytes);
    put(ball.is_rolling ? 1.0 : 0.0, bytes);
  }
  void operator()(const PlacedRobot& placed) const {
    kind(Format::kPlaced);
    put_robot_id(placed.robot, bytes);
    put_vector(placed.state.position_m, bytes);
    put_vector(placed.state.velocity_mps, bytes);
    put_vector(placed.state.heading, bytes);
    put(placed.state.angular_velocity_radps, bytes);
  }
  void operator()(const RemovedRobot& removed) const {
    kind(Format::kRemoved);
    put_robot_id(removed.robot, bytes);
  }
};

}  // namespace

CommandsWriter::CommandsWriter(const std::filesystem::path& path, io::FileKind kind)
    : path_(path), kind_(kind), pending_(path, kind), bytes_(Format::kHeader) {}

// Not before there is something to write: zlib would write even an empty file.
void CommandsWriter::open() {
  pending_.begin();
  errno = 0;
  const int descriptor = fcntl(pending_.descriptor(), F_DUPFD_CLOEXEC, 0);
  if (descriptor < 0) fail();
  file_ = gzdopen(descriptor, "wb6");
  if (file_ == nullptr) {
    ::close(descriptor);
    fail();
  }
}

CommandsWriter::~CommandsWriter() {
  if (file_ != nullptr) gzclose(gz_of(file_));
}

void CommandsWriter::fail() const {
  throw io::io_error(fmt::format("{} cannot be written", path_.string()), errno);
}

void CommandsWriter::write() {
  if (file_ == nullptr) open();
  errno = 0;
  const int written = gzwrite(gz_of(file_), bytes_.data(), static_cast<unsigned>(bytes_.size()));
  if (written <= 0) fail();
  bytes_.clear();
  if (kind_ != io::FileKind::kGrowing || Clock::now() < flushed_ + kFlushEvery) return;
  flushed_ = Clock::now();
  if (gzflush(gz_of(file_), Z_SYNC_FLUSH) != Z_OK) fail();
}

void CommandsWriter::add(char team, const TeamEntry& entry) {
  TeamEntry& last = last_[Format::index_of(team)];
  const bool has_requests = !is_same(entry.requests, last.requests);
  const auto letter = static_cast<unsigned>(Format::index_of(team)) + 1;
  const bool has_fault = !entry.fault.empty();
  put(static_cast<std::uint8_t>(letter | (has_requests ? Format::kHasRequests : 0U) |
                                (has_fault ? Format::kHasFault : 0U)),
      bytes_);
  if (has_requests) put_requests(entry.requests, bytes_);
  if (has_fault) {
    const std::string_view fault = std::string_view(entry.fault).substr(0, Format::kLongestFault);
    put(static_cast<std::uint16_t>(fault.size()), bytes_);
    bytes_ += fault;
  } else {
    put_commands(entry.commands, last.commands, bytes_);
  }
  write();
  last = entry;
}

void CommandsWriter::add(const ChangedRobot& changed) {
  ChangedRobot robot = changed;
  put(static_cast<std::uint8_t>(Format::kChangedRobot), bytes_);
  put_robot_id(robot.robot, bytes_);
  for (const double* limit : Format::limits_of(robot)) put(*limit, bytes_);
  write();
}

void CommandsWriter::add(const WorldChange& change) {
  std::visit(PutChange{bytes_}, change);
  write();
}

void CommandsWriter::close(std::uint64_t final_state, bool is_interrupted) {
  put(static_cast<std::uint8_t>(Format::kEnd | (is_interrupted ? Format::kIsInterrupted : 0U)),
      bytes_);
  put(final_state, bytes_);
  write();
  errno = 0;
  if (gzclose(gz_of(std::exchange(file_, nullptr))) != Z_OK) fail();
  pending_.commit();
}

}  // namespace autoref::game
