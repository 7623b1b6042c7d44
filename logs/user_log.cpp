#include "logs/user_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"
#include "logs/log_game.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::logs {
namespace {

// "camera 2's is 0.030 s behind, camera 3's is 0.500 s ahead".
std::string clocks_text(const std::map<std::uint32_t, double>& clocks_ahead_s) {
  std::string text;
  for (const auto& [camera, ahead_s] : clocks_ahead_s) {
    text += fmt::format("{}camera {}'s is {:.3f} s {}", text.empty() ? "" : ", ", camera,
                        std::abs(ahead_s), ahead_s < 0 ? "behind" : "ahead");
  }
  return text;
}

std::string quoted_name(const std::string& referee) {
  return referee.empty() ? "one without a name" : fmt::format("'{}'", io::printable(referee));
}

// "1 message is", "2 messages are".
std::string count_text(std::int64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? " is" : "s are");
}

std::string referees_text(const league::MessageFaults& faults) {
  return fmt::format("{} from another referee and ignored, first from {}; {} {}",
                     count_text(faults.of_other_referee, "packet"),
                     quoted_name(faults.other_referee),
                     faults.referee_changes == 0 ? "the referee followed is"
                                                 : "the referee followed has changed and is now",
                     quoted_name(faults.referee));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

// Fills the whole buffer; reads less only at the end of the file.
std::size_t fill(int from, std::vector<char>& buffer) {
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t size = ::read(from, buffer.data() + filled, buffer.size() - filled);
    if (size < 0 && errno == EINTR) throw io::Interrupted();
    if (size < 0) throw io::io_error("cannot read the log", errno);
    if (size == 0) break;
    filled += static_cast<std::size_t>(size);
  }
  return filled;
}

void copy_log(int from, int to, const std::string& path) {
  std::vector<char> buffer(std::size_t{1} << 16);
  std::size_t size = fill(from, buffer);
  if (!league::may_begin_log({buffer.data(), size}))
    throw io::InputError({}, "", fmt::format("{}: is not an SSL log", path));
  for (std::int64_t copied = 0; size > 0; size = fill(from, buffer)) {
    io::write_all(to, {buffer.data(), size}, path);
    copied += static_cast<std::int64_t>(size);
    if (copied > league::LogLimits{}.bytes)
      throw io::InputError({}, "", fmt::format("{}: is too long for a log", path));
  }
}

bool is_log_name(const std::string& name) {
  return name.ends_with(".log") || name.ends_with(".log.gz");
}

std::vector<std::string> logs_in_folder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::string> logs;
  std::size_t files = 0;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    if (++files > kMostLogs) {
      throw io::InputError({folder}, "",
                           fmt::format("contains more than {} files; name the logs", kMostLogs));
    }
    std::error_code none;
    const std::string path = file->path().string();
    if (is_log_name(path) && !file->is_directory(none)) logs.push_back(path);
  }
  if (error) throw io::InputError({folder}, "", error.message());
  if (logs.empty()) throw io::InputError({folder}, "", "contains no .log or .log.gz file");
  std::sort(logs.begin(), logs.end());
  return logs;
}

}  // namespace

std::vector<std::string> logs_in(const std::vector<std::string>& paths) {
  std::vector<std::string> logs;
  for (const std::string& path : paths) {
    std::error_code none;
    const bool is_folder = std::filesystem::is_directory(path, none);
    for (const std::string& log : is_folder ? logs_in_folder(path) : std::vector{path})
      logs.push_back(log);
  }
  return logs;
}

std::string seekable_log(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))
    return path;
  const Descriptor from(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (from.number() < 0 && errno == EINTR) throw io::Interrupted();
  if (from.number() < 0)
    throw io::InputError({}, "", fmt::format("{}: {}", path, std::strerror(errno)));
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  Descriptor to(error ? -1 : ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (to.number() < 0) {
    throw io::io_error(fmt::format("{} must be copied to a temporary file, but none can be created "
                                   "in {} (set TMPDIR to another folder)",
                                   path, error ? "TMPDIR" : folder.string()),
                       error ? error.value() : errno);
  }
  copy_log(from.number(), to.number(), path);
  return fmt::format("/proc/self/fd/{}", to.release());
}

std::string text_of(const league::LogError& error, const std::string& copy,
                    const std::string& path) {
  const std::string_view what = error.what();
  return what.starts_with(copy) ? path + std::string(what.substr(copy.size())) : std::string(what);
}

RecordedFacts read_facts(const std::string& path, const std::string& copy,
                         league::FrameSource source) {
  try {
    return facts_of(copy, source);
  } catch (const league::LogError& error) {
    throw io::InputError({}, "", text_of(error, copy, path));
  }
}

std::vector<std::string> texts_of(const league::MessageFaults& faults) {
  std::vector<std::string> texts;
  const auto add = [&texts](std::int64_t count, std::string_view what, std::string_view text) {
    if (count > 0) texts.push_back(fmt::format("{} {}", count_text(count, what), text));
  };
  add(faults.unreadable, "unreadable message", "ignored");
  add(faults.late, "late packet", "ignored");
  add(faults.copies, "message", "ignored as duplicates");
  if (faults.of_other_referee > 0) texts.push_back(referees_text(faults));
  if (!faults.clocks_ahead_s.empty()) {
    texts.push_back(fmt::format("the cameras' clocks differ and were corrected: {}",
                                clocks_text(faults.clocks_ahead_s)));
  }
  if (faults.clock_restarts > 0) {
    texts.push_back(fmt::format(
        "the cameras' clock restarts {}; times were adjusted to continue",
        faults.clock_restarts == 1 ? "once" : fmt::format("{} times", faults.clock_restarts)));
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
    add(fmt::format("{} of an unknown kind and ignored", count_text(unknown->second, "message")));
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
    add(fmt::format("the field changes {} times; using the last field", log.field_changes));
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
  const std::string copy = seekable_log(path);
  try {
    log = league::read_log(copy, visitor);
  } catch (const league::LogError& error) {
    throw io::InputError({}, "", text_of(error, copy, path));
  }
  io::write_message(stderr, damage_text(path, log));
  if (log.frames > 0) return log;
  throw io::InputError({path}, "",
                       "the log contains no vision frames, so there is nothing to show");
}

Field field_shown(const std::string& path, const league::LogSummary& log, const std::string& book) {
  const std::optional<GameSetup> setup = find_game_setup(book);
  if (!setup) {
    const std::vector<std::string> known = rule_book_names();
    throw io::InputError({"--rules"}, "",
                         fmt::format("expected one of {}, found '{}'{}", io::listed(known), book,
                                     io::suggestion(book, known)));
  }
  if (log.field) return field_in(log, find_game_setup(guessed_rules(log).book)->field);
  io::write_message(stderr, fmt::format("autoref: {}: the log has no geometry; using the field of "
                                        "the rules {} (change with --rules)\n",
                                        path, book));
  return setup->field;
}

}  // namespace autoref::logs
