#include "runner/logs/user_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner {
namespace {

// "camera 2 is 0.030 s behind, camera 3 is 0.500 s ahead".
std::string clocks_text(const std::map<std::uint32_t, double>& clocks_ahead_s) {
  std::string text;
  for (const auto& [camera, ahead_s] : clocks_ahead_s) {
    text += fmt::format("{}camera {} is {:.3f} s {}", text.empty() ? "" : ", ", camera,
                        std::abs(ahead_s), ahead_s < 0 ? "behind" : "ahead");
  }
  return text;
}

std::string named(const std::string& referee) {
  return referee.empty() ? "without a name" : fmt::format("'{}'", printable(referee));
}

// Copies everything from one descriptor to another; returns whether that worked.
bool copy_all(int from, int to) {
  std::vector<char> buffer(std::size_t{1} << 16);
  const std::int64_t most = league::LogLimits{}.bytes;
  for (std::int64_t copied = 0; copied < most;) {
    const ssize_t size = ::read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) throw Interrupted();
    if (size <= 0) return size == 0;
    for (ssize_t written = 0; written < size;) {
      const ssize_t part =
          ::write(to, buffer.data() + written, static_cast<std::size_t>(size - written));
      if (part < 0) return false;
      written += part;
    }
    copied += size;
  }
  errno = EFBIG;
  return false;
}

}  // namespace

std::string rereadable(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))
    return path;
  const int from = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (from < 0) throw InputError({path}, "", std::strerror(errno));
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const int to = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  const bool is_copied = to >= 0 && copy_all(from, to);
  const int error = errno;
  ::close(from);
  if (!is_copied) throw io_error(fmt::format("cannot copy {} to {}", path, folder.string()), error);
  return fmt::format("/proc/self/fd/{}", to);
}

std::vector<std::string> texts_of(const league::MessageFaults& faults) {
  std::vector<std::string> texts;
  const auto add = [&texts](std::int64_t count, const std::string& text) {
    if (count > 0) texts.push_back(fmt::format("{} {}", count, text));
  };
  add(faults.unreadable, "messages are unreadable and ignored");
  add(faults.late, "packets came too late and are ignored");
  add(faults.copies, "messages came twice; the copies are ignored");
  add(faults.of_other_referee,
      fmt::format("packets of another referee, {}, are ignored; the one followed is {}",
                  named(faults.other_referee), named(faults.referee)));
  if (!faults.clocks_ahead_s.empty()) {
    texts.push_back(fmt::format("the cameras' clocks differ: {}; adjusted",
                                clocks_text(faults.clocks_ahead_s)));
  }
  if (faults.clock_restarts > 0) {
    texts.push_back(fmt::format("the cameras' clock restarts {} times; adjusted to continue",
                                faults.clock_restarts));
  }
  return texts;
}

std::string damage_text(const std::string& path, const league::LogSummary& log) {
  std::string text;
  if (log.damage) {
    text = fmt::format("autoref: {}: the log is only readable up to byte {}: {}\n", path,
                       log.damage->offset, log.damage->what);
  }
  const auto add = [&](const std::string& line) {
    text += fmt::format("autoref: {}: {}\n", path, line);
  };
  if (const auto unknown = log.records.find(league::MessageKind::kUnknown);
      unknown != log.records.end())
    add(fmt::format("{} messages are of an unknown kind and ignored", unknown->second));
  for (const std::string& line : texts_of(log.faults)) add(line);
  if (log.faults.unreadable > 0)
    add(fmt::format("the first unreadable message is at byte {}", log.unreadable_at));
  if (log.frames_are_tracked) {
    add(fmt::format(
        "{}using the frames of its tracker{}",
        log.source == league::FrameSource::kTracker ? "" : "the log begins without vision; ",
        log.trackers > 1 ? fmt::format(" (it has {})", log.trackers) : ""));
  }
  if (log.unnumbered > 0) {
    add(fmt::format("{} detections of robots with numbers from {} are ignored", log.unnumbered,
                    kMaxRobots));
  }
  if (log.field_changes > 0)
    add(fmt::format("the field changes {} times; using the last one", log.field_changes));
  return text;
}

std::string damage_text(const std::string& path, const RecordedFacts& facts) {
  std::string text = damage_text(path, facts.log);
  const auto add = [&](const std::string& line) {
    text += fmt::format("autoref: {}: {}\n", path, line);
  };
  if (facts.unknown_signals > 0) {
    add(fmt::format("{} referee packets have an unknown stage or command and are ignored",
                    facts.unknown_signals));
  }
  if (facts.games.size() > 1) {
    add(fmt::format("the log contains {} games; the second starts at {:.1f} s", facts.games.size(),
                    facts.games[1].begins_s));
  }
  return text;
}

league::LogSummary read_user_log(const std::string& path, league::LogVisitor& visitor) {
  league::LogSummary log;
  try {
    log = league::read_log(rereadable(path), visitor);
  } catch (const league::LogError& error) {
    throw InputError({}, "", error.what());
  }
  write_message(stderr, damage_text(path, log));
  if (log.frames > 0) return log;
  throw InputError({path}, "", "the log contains no vision frame: there is nothing to show");
}

Field field_shown(const std::string& path, const league::LogSummary& log, const std::string& book) {
  const std::optional<GameSetup> setup = find_game_setup(book);
  if (!setup) {
    throw InputError(
        {"--rules"}, "",
        fmt::format("unknown rule book '{}'; expected one of {}", book, listed(rule_book_names())));
  }
  if (log.field) return *log.field;
  write_message(stderr, fmt::format("autoref: {}: the log has no geometry; using the field of "
                                    "the rules {} (change with --rules)\n",
                                    path, book));
  return setup->field;
}

}  // namespace autoref::runner
