#include "game/team_programs/commands_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::game {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kHeader = "autoref-commands 1\n";
constexpr std::size_t kLongestFault = 4000;

constexpr unsigned kTeamBits = 3;
constexpr unsigned kEnd = 3;
constexpr unsigned kChange = 0;  // bits 0-1; the kinds in bits 2-3
constexpr unsigned kChangeShift = 2;
constexpr unsigned kBall = 0;
constexpr unsigned kPlaced = 1;
constexpr unsigned kRemoved = 2;
constexpr unsigned kChangedRobot = kChange | 3U << kChangeShift;  // the first byte
constexpr double kLargestChange = 1e4;
constexpr unsigned kHasRequests = 4;
constexpr unsigned kHasFault = 8;
constexpr unsigned kHasChip = 16;
constexpr unsigned kHasDribble = 32;

gzFile gz_file(void* file) { return static_cast<gzFile>(file); }

std::size_t index_of(char team) { return team == 'a' ? 0 : 1; }

template <typename Number>
void put(Number number, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::array<float, 4> numbers_of(const RobotCommand& c) {
  return {static_cast<float>(c.velocity_mps.x()), static_cast<float>(c.velocity_mps.y()),
          static_cast<float>(c.angular_velocity_radps), static_cast<float>(c.kick_mps)};
}

bool is_same(const RobotCommand& a, const RobotCommand& b) {
  return numbers_of(a) == numbers_of(b) && a.chip == b.chip && a.dribble == b.dribble;
}

bool is_same(const TeamRequests& a, const TeamRequests& b) {
  return a.keeper == b.keeper && a.leaves == b.leaves && a.timeout == b.timeout;
}

void put_requests(const TeamRequests& requests, std::string& bytes) {
  put(static_cast<std::int8_t>(requests.keeper), bytes);
  put(static_cast<std::int8_t>(requests.leaves.value_or(-1)), bytes);
  put(static_cast<std::uint8_t>(requests.timeout ? 1 : 0), bytes);
}

void put_command(const RobotCommand& command, const RobotCommand& last, std::string& bytes) {
  const std::array<float, 4> now = numbers_of(command);
  const std::array<float, 4> before = numbers_of(last);
  unsigned flags = (command.chip ? kHasChip : 0U) | (command.dribble ? kHasDribble : 0U);
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

// A robot's limits in the file's order.
std::array<double*, 9> limits_of(ChangedRobot& robot) {
  return {&robot.mass_kg,
          &robot.speed_mps,
          &robot.acceleration_mps2,
          &robot.braking_mps2,
          &robot.wheel_acceleration_mps2,
          &robot.angular_speed_radps,
          &robot.angular_acceleration_radps2,
          &robot.kick_limit_mps,
          &robot.chip_limit_mps};
}

struct PutChange {
  std::string& bytes;
  void kind(unsigned kind) const {
    put(static_cast<std::uint8_t>(kChange | kind << kChangeShift), bytes);
  }
  void operator()(const sim::BallState& ball) const {
    kind(kBall);
    put_vector(ball.position_m, bytes);
    put_vector(ball.velocity_mps, bytes);
    put(ball.height_m, bytes);
    put(ball.vertical_mps, bytes);
    put(ball.is_rolling ? 1.0 : 0.0, bytes);
  }
  void operator()(const PlacedRobot& placed) const {
    kind(kPlaced);
    put_robot_id(placed.robot, bytes);
    put_vector(placed.state.position_m, bytes);
    put_vector(placed.state.velocity_mps, bytes);
    put_vector(placed.state.heading, bytes);
    put(placed.state.angular_velocity_radps, bytes);
  }
  void operator()(const RemovedRobot& removed) const {
    kind(kRemoved);
    put_robot_id(removed.robot, bytes);
  }
};

}  // namespace

bool is_same(const TeamEntry& a, const TeamEntry& b) {
  return is_same(a.requests, b.requests) &&
         std::equal(a.commands.begin(), a.commands.end(), b.commands.begin(),
                    [](const RobotCommand& c, const RobotCommand& d) { return is_same(c, d); });
}

CommandsWriter::CommandsWriter(const std::filesystem::path& path, io::FileKind kind)
    : path_(path), pending_(path, kind), bytes_(kHeader) {
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
  if (file_ != nullptr) gzclose(gz_file(file_));
}

void CommandsWriter::fail() const {
  throw io::io_error(fmt::format("{} cannot be written", path_.string()), errno);
}

void CommandsWriter::write() {
  errno = 0;
  const int written = gzwrite(gz_file(file_), bytes_.data(), static_cast<unsigned>(bytes_.size()));
  if (written <= 0) fail();
  bytes_.clear();
}

void CommandsWriter::add(char team, const TeamEntry& entry) {
  TeamEntry& last = last_[index_of(team)];
  const bool has_requests = !is_same(entry.requests, last.requests);
  const auto letter = static_cast<unsigned>(index_of(team)) + 1;
  const bool has_fault = !entry.fault.empty();
  put(static_cast<std::uint8_t>(letter | (has_requests ? kHasRequests : 0U) |
                                (has_fault ? kHasFault : 0U)),
      bytes_);
  if (has_requests) put_requests(entry.requests, bytes_);
  if (has_fault) {
    const std::string_view fault = std::string_view(entry.fault).substr(0, kLongestFault);
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
  put(static_cast<std::uint8_t>(kChangedRobot), bytes_);
  put_robot_id(robot.robot, bytes_);
  for (const double* limit : limits_of(robot)) put(*limit, bytes_);
  write();
}

void CommandsWriter::add(const WorldChange& change) {
  std::visit(PutChange{bytes_}, change);
  write();
}

void CommandsWriter::close(std::uint64_t final_state) {
  put(static_cast<std::uint8_t>(kEnd), bytes_);
  put(final_state, bytes_);
  write();
  errno = 0;
  if (gzclose(gz_file(std::exchange(file_, nullptr))) != Z_OK) fail();
  pending_.commit();
}

CommandsReader::CommandsReader(std::filesystem::path path, io::FileKind kind)
    : path_(std::move(path)) {
  errno = 0;
  const int descriptor = kind == io::FileKind::kFile ? io::open_regular_file(path_, O_RDONLY)
                                                     : open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  file_ = descriptor < 0 ? nullptr : gzdopen(descriptor, "rb");
  if (file_ == nullptr && descriptor >= 0) ::close(descriptor);
  if (file_ == nullptr) throw io::io_error(fmt::format("cannot read {}", path_.string()), errno);
  std::string header(kHeader.size(), '\0');
  const int size = gzread(gz_file(file_), header.data(), static_cast<unsigned>(header.size()));
  if (size == static_cast<int>(header.size()) && header == kHeader) return;
  gzclose(gz_file(file_));
  refuse("is not a file of recorded commands (autoref play --record FILE writes one)");
}

CommandsReader::~CommandsReader() { gzclose(gz_file(file_)); }

void CommandsReader::refuse(const std::string& what) const {
  throw io::InputError({path_.string()}, "", what);
}

void CommandsReader::read(void* bytes, std::size_t size) {
  const int got = gzread(gz_file(file_), bytes, static_cast<unsigned>(size));
  if (got != static_cast<int>(size)) refuse("is damaged, or ends in the middle of an entry");
}

template <typename Number>
Number CommandsReader::number() {
  Number number{};
  read(&number, sizeof number);
  return number;
}

int CommandsReader::robot() {
  const auto byte = number<std::uint8_t>();
  return byte < kMaxRobots ? byte : -1;
}

void CommandsReader::read_command(RobotCommand& command) {
  const auto flags = number<std::uint8_t>();
  std::array<float, 4> numbers = numbers_of(command);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if ((flags >> i & 1U) != 0) numbers[i] = number<float>();
  }
  command = {Vec2(numbers[0], numbers[1]), numbers[2], numbers[3], (flags & kHasChip) != 0,
             (flags & kHasDribble) != 0};
  if (!is_finite(command)) refuse("is damaged: a command contains a value that is not finite");
}

const TeamEntry& CommandsReader::next(char team) {
  const auto kind = number<std::uint8_t>();
  const std::size_t index = index_of(team);
  if ((kind & kTeamBits) != index + 1) {
    refuse(
        fmt::format("has no commands from team {} where the game needs them; it belongs to "
                    "another game",
                    team));
  }
  TeamEntry& entry = last_[index];
  if ((kind & kHasRequests) != 0) {
    entry.requests.keeper = robot();
    const int leaves = robot();
    entry.requests.leaves = leaves < 0 ? std::nullopt : std::optional<int>(leaves);
    entry.requests.timeout = number<std::uint8_t>() != 0;
  }
  if ((kind & kHasFault) != 0) {
    entry.fault.resize(std::min<std::size_t>(number<std::uint16_t>(), kLongestFault));
    read(entry.fault.data(), entry.fault.size());
    return entry;
  }
  const auto changed = number<std::uint16_t>();
  for (std::size_t i = 0; i < entry.commands.size(); ++i) {
    if ((changed >> i & 1U) != 0) read_command(entry.commands[i]);
  }
  return entry;
}

void CommandsReader::change_robots(GameConfiguration& game) {
  int kind = 0;
  while ((kind = gzgetc(gz_file(file_))) == static_cast<int>(kChangedRobot)) {
    const auto side = number<std::uint8_t>() == 0 ? Side::kWest : Side::kEast;
    ChangedRobot changed;
    changed.robot = {side, robot()};
    for (double* limit : limits_of(changed)) *limit = number<double>();
    try {
      apply(changed, game);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("changes a robot in an impossible way: {}", error.what()));
    }
  }
  gzungetc(kind, gz_file(file_));
}

Vec2 CommandsReader::vector() {
  const auto x = number<double>();
  const auto y = number<double>();
  if (std::abs(x) <= kLargestChange && std::abs(y) <= kLargestChange) return {x, y};
  refuse("is damaged: a change of the world is impossible");
}

std::optional<WorldChange> CommandsReader::next_change() {
  const int kind = gzgetc(gz_file(file_));
  if (kind < 0 || (static_cast<unsigned>(kind) & kTeamBits) != kChange) {
    gzungetc(kind, gz_file(file_));
    return std::nullopt;
  }
  const unsigned of = static_cast<unsigned>(kind) >> kChangeShift;
  if (of == kBall) {
    sim::BallState ball;
    ball.position_m = vector();
    ball.velocity_mps = vector();
    const Vec2 upward = vector();
    ball.height_m = upward.x();
    ball.vertical_mps = upward.y();
    ball.is_rolling = number<double>() != 0;
    return ball;
  }
  const auto side = number<std::uint8_t>() == 0 ? Side::kWest : Side::kEast;
  const RobotId id{side, robot()};
  if (id.number < 0 || of > kRemoved) refuse("is damaged: a change of the world is impossible");
  if (of == kRemoved) return RemovedRobot{id};
  PlacedRobot placed{id, {}};
  placed.state.number = id.number;
  placed.state.position_m = vector();
  placed.state.velocity_mps = vector();
  placed.state.heading = vector();
  const auto turn_radps = number<double>();
  placed.state.angular_velocity_radps = std::abs(turn_radps) <= kLargestChange ? turn_radps : 0;
  if (std::abs(placed.state.heading.norm() - 1) > 1e-6)
    refuse("is damaged: a heading is not a unit vector");
  return placed;
}

std::uint64_t CommandsReader::final_state() {
  if (number<std::uint8_t>() != kEnd)
    refuse("has more commands than the game needs; it belongs to another game");
  return number<std::uint64_t>();
}

}  // namespace autoref::game
