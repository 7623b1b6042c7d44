#include "game/team_programs/program_spec.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>

#include "io/errors.hpp"

namespace autoref::game {
namespace {

// systemd's range for dynamic users: https://systemd.io/UIDS-GIDS
constexpr int kFirstUser = 61184;
constexpr int kUsers = 4336;
constexpr const char* kLocks = "/run/autoref-users";
constexpr const char* kCannot =
    "AutoRef is running as root, but cannot start programs as another user; start it as an "
    "ordinary user";

// Whether root of this user namespace is an ordinary user outside, who cannot switch to another
// user.
bool is_a_user_outside() {
  std::ifstream map("/proc/self/uid_map");
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  std::int64_t count = 0;
  bool is_root_outside = false;
  bool has_others = false;
  while (map >> inside >> outside >> count) {
    is_root_outside = is_root_outside || (inside == 0 && outside == 0);
    has_others = has_others || inside + count > kFirstUser;
  }
  return map.eof() && !is_root_outside && !has_others;
}

bool has_account(int id) {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> text{};
  getpwuid_r(static_cast<uid_t>(id), &entry, text.data(), text.size(), &found);
  return found != nullptr;
}

// Locks the byte that stands for the id in a file owned by root. The lock ends with the descriptor,
// however the process ends. Returns false if another process holds the lock; throws if that cannot
// be determined.
bool lock(int file, int id) {
  struct flock byte {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = id;
  byte.l_len = 1;
  if (fcntl(file, F_OFD_SETLK, &byte) == 0) return true;
  if (errno == EAGAIN || errno == EACCES) return false;
  throw io::io_error(fmt::format("{}: {}", kCannot, kLocks), errno);
}

}  // namespace

bool runs_as_root() {
  uid_t real = 0;
  uid_t effective = 0;
  uid_t saved = 0;
  const bool is_called_root =
      getresuid(&real, &effective, &saved) == 0 && (real == 0 || effective == 0 || saved == 0);
  return is_called_root && !is_a_user_outside();
}

ProgramUser::LockFile::LockFile()
    : descriptor(open(kLocks, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600)) {
  if (descriptor < 0) throw io::io_error(fmt::format("{}: {}", kCannot, kLocks), errno);
}

ProgramUser::LockFile::~LockFile() { close(descriptor); }

ProgramUser::ProgramUser() {
  int tried = 0;
  do {
    if (tried == kUsers)
      throw io::InputOutputError(kLocks + std::string(": all user ids for programs are in use"));
    id_ = kFirstUser + (61 * getpid() + tried++) % kUsers;
  } while (has_account(id_) || !lock(locks_.descriptor, id_));
  const auto id = static_cast<uid_t>(id_);
  if (chown(folder_.path().c_str(), id, id) != 0) {
    const int error_number = errno;
    throw io::io_error(fmt::format("{}: the owner of {} cannot be changed to user {}", kCannot,
                                   folder_.path().string(), id_),
                       error_number);
  }
}

void ProgramUser::give(int descriptor) const {
  const auto id = static_cast<uid_t>(id_);
  if (fchown(descriptor, id, id) != 0) throw io::io_error(kCannot, errno);
}

std::vector<std::string> ProgramUser::environment() const {
  return {"HOME=" + folder_.path().string(), "TMPDIR=" + folder_.path().string()};
}

}  // namespace autoref::game
