// A team of few lines in flat records (docs/team-programs.md): robot 1 drives in curves.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

constexpr std::uint16_t kFrame = 2;
constexpr std::uint16_t kEnd = 3;
constexpr std::uint16_t kOutput = 4;

struct Output {
  std::uint32_t length = sizeof(Output);
  std::uint16_t kind = kOutput;
  std::uint16_t timeout = 0;
  std::int64_t frame = 0;
  std::int32_t keeper = 0;
  std::int32_t leaves = -1;
  std::uint16_t commands = 1;
  std::uint16_t text_bytes = 0;
  std::uint32_t reserved = 0;
  double vx_mps = 0.5;
  double vy_mps = 0;
  double angular_velocity_radps = 0;
  double kick_mps = 0;
  std::int32_t robot = 1;
  std::uint8_t chip = 0;
  std::uint8_t dribble = 0;
  std::uint16_t more_reserved = 0;
};
static_assert(sizeof(Output) == 72);

template <typename Number>
Number number_at(const char* bytes) {
  Number number{};
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

}  // namespace

int main() {
  static std::array<char, 1U << 16U> record;
  std::puts("autoref-team 1 flat");
  std::fflush(stdout);
  for (;;) {
    if (std::fread(record.data(), 4, 1, stdin) != 1) return 1;
    const auto length = number_at<std::uint32_t>(record.data());
    if (length < 16 || length > record.size()) return 2;
    if (std::fread(record.data() + 4, length - 4, 1, stdin) != 1) return 3;
    const auto kind = number_at<std::uint16_t>(record.data() + 4);
    if (kind == kEnd) return 0;
    if (kind != kFrame) continue;
    Output output;
    output.frame = number_at<std::int64_t>(record.data() + 8);
    output.angular_velocity_radps = static_cast<double>(output.frame % 50) / 10;
    std::fwrite(&output, sizeof output, 1, stdout);
    std::fflush(stdout);
  }
}
