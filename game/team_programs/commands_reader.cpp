#include "game/team_programs/commands_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "io/errors.hpp"

namespace autoref::game {
namespace {

using Format = CommandsFormat;

constexpr double kLargestChange = 1e4;

gzFile gz_file(void* file) { return static_cast<gzFile>(file); }

// The file ends in the middle of a step.
class Truncated : public io::InputError {
 public:
  explicit Truncated(const std::string& path)
      : io::InputError({path}, "", "is damaged, or ends in the middle of an entry") {}
};

}  // namespace

CommandsReader::CommandsReader(std::filesystem::path path, io::FileKind kind)
    : path_(std::move(path)), kind_(kind) {
  errno = 0;
  const int descriptor = kind == io::FileKind::kFile ? io::open_regular_file(path_, O_RDONLY)
                                                     : open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  file_ = descriptor < 0 ? nullptr : gzdopen(descriptor, "rb");
  if (file_ == nullptr && descriptor >= 0) ::close(descriptor);
  if (file_ == nullptr) throw io::io_error(fmt::format("cannot read {}", path_.string()), errno);
  std::string header(Format::kHeader.size(), '\0');
  const int size = gzread(gz_file(file_), header.data(), static_cast<unsigned>(header.size()));
  if (size == static_cast<int>(header.size()) && header == Format::kHeader) return;
  gzclose(gz_file(file_));
  refuse("is not a file of recorded commands (autoref play --record FILE writes one)");
}

CommandsReader::~CommandsReader() { gzclose(gz_file(file_)); }

void CommandsReader::refuse(const std::string& what) const {
  throw io::InputError({path_.string()}, "", what);
}

std::uint8_t CommandsReader::peek() {
  std::uint8_t byte = 0;
  read(&byte, sizeof byte);
  gzungetc(byte, gz_file(file_));
  return byte;
}

void CommandsReader::read(void* bytes, std::size_t size) {
  const int got = gzread(gz_file(file_), bytes, static_cast<unsigned>(size));
  if (got == static_cast<int>(size)) return;
  int code = Z_OK;
  gzerror(gz_file(file_), &code);
  if (code == Z_OK || code == Z_BUF_ERROR) throw Truncated(path_.string());
  refuse("is damaged");
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
  std::array<float, 4> numbers = Format::numbers_of(command);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if ((flags >> i & 1U) != 0) numbers[i] = number<float>();
  }
  command = {Vec2(numbers[0], numbers[1]), numbers[2], numbers[3], (flags & Format::kHasChip) != 0,
             (flags & Format::kHasDribble) != 0};
  if (!is_finite(command)) refuse("is damaged: a command contains a value that is not finite");
}

const TeamEntry& CommandsReader::next(char team) {
  const std::size_t index = Format::index_of(team);
  if (std::exchange(is_kept_[index], false)) return last_[index];
  if ((peek() & Format::kTeamBits) != index + 1) {
    refuse(
        fmt::format("has no commands from team {} where the game needs them; it belongs to "
                    "another game",
                    team));
  }
  read_entry(index);
  return last_[index];
}

void CommandsReader::read_entry(std::size_t index) {
  const auto kind = number<std::uint8_t>();
  TeamEntry& entry = last_[index];
  if ((kind & Format::kHasRequests) != 0) {
    entry.requests.keeper = robot();
    const int leaves = robot();
    entry.requests.leaves = leaves < 0 ? std::nullopt : std::optional<int>(leaves);
    entry.requests.timeout = number<std::uint8_t>() != 0;
  }
  if ((kind & Format::kHasFault) != 0) {
    entry.fault.resize(std::min<std::size_t>(number<std::uint16_t>(), Format::kLongestFault));
    read(entry.fault.data(), entry.fault.size());
    return;
  }
  const auto changed = number<std::uint16_t>();
  for (std::size_t i = 0; i < entry.commands.size(); ++i) {
    if ((changed >> i & 1U) != 0) read_command(entry.commands[i]);
  }
}

void CommandsReader::change_robots(GameConfiguration& game) {
  while (peek() == Format::kChangedRobot) {
    number<std::uint8_t>();
    const auto side = number<std::uint8_t>() == 0 ? Side::kWest : Side::kEast;
    ChangedRobot changed;
    changed.robot = {side, robot()};
    for (double* limit : Format::limits_of(changed)) *limit = number<double>();
    try {
      apply(changed, game);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("changes a robot in an impossible way: {}", error.what()));
    }
  }
}

Vec2 CommandsReader::vector() {
  const auto x = number<double>();
  const auto y = number<double>();
  if (std::abs(x) <= kLargestChange && std::abs(y) <= kLargestChange) return {x, y};
  refuse("is damaged: a change of the world is impossible");
}

// A step has at most one entry of each team.
void CommandsReader::read_step(std::vector<WorldChange>& changes) {
  while ((peek() & Format::kTeamBits) == Format::kChange) changes.push_back(read_change());
  for (;;) {
    const unsigned team = peek() & Format::kTeamBits;
    if (team == Format::kChange || team == Format::kEnd || is_kept_[team - 1]) return;
    read_entry(team - 1);
    is_kept_[team - 1] = true;
  }
}

std::optional<std::vector<WorldChange>> CommandsReader::read_step() {
  std::vector<WorldChange> changes;
  try {
    read_step(changes);
  } catch (const Truncated&) {
    if (kind_ == io::FileKind::kFile) throw;
    is_truncated_ = true;
    return std::nullopt;
  }
  const bool has_entries = is_kept_[0] || is_kept_[1];
  const bool is_interrupted = peek() == (Format::kEnd | Format::kIsInterrupted);
  return is_interrupted && !has_entries ? std::nullopt : std::optional(std::move(changes));
}

WorldChange CommandsReader::read_change() {
  const unsigned of = static_cast<unsigned>(number<std::uint8_t>()) >> Format::kChangeShift;
  if (of == Format::kBall) {
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
  if (id.number < 0 || of > Format::kRemoved)
    refuse("is damaged: a change of the world is impossible");
  if (of == Format::kRemoved) return RemovedRobot{id};
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

std::optional<std::uint64_t> CommandsReader::final_state() {
  if (is_kept_[0] || is_kept_[1] || (number<std::uint8_t>() & Format::kTeamBits) != Format::kEnd)
    refuse("has more commands than the game needs; it belongs to another game");
  try {
    return number<std::uint64_t>();
  } catch (const Truncated&) {
    if (kind_ == io::FileKind::kFile) throw;
    is_truncated_ = true;
    return std::nullopt;
  }
}

}  // namespace autoref::game
