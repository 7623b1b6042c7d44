#include "referee/timekeeping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace autoref::referee {
namespace {

constexpr std::array<Stage, kMaxHalves> kBefore = {Stage::kFirstHalfPre, Stage::kSecondHalfPre,
                                                   Stage::kExtraFirstHalfPre,
                                                   Stage::kExtraSecondHalfPre};
constexpr std::array<Stage, kMaxHalves> kRunning = {
    Stage::kFirstHalf, Stage::kSecondHalf, Stage::kExtraFirstHalf, Stage::kExtraSecondHalf};
constexpr std::array<Stage, kMaxHalves - 1> kBreaks = {Stage::kHalfTime, Stage::kExtraTimeBreak,
                                                       Stage::kExtraHalfTime};

template <typename Stages>
bool contains(const Stages& stages, Stage stage) {
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

}  // namespace

Stage stage_before(int half) { return kBefore[static_cast<std::size_t>(half)]; }
Stage stage_of(int half) { return kRunning[static_cast<std::size_t>(half)]; }
Stage break_after(int half) { return kBreaks[static_cast<std::size_t>(half)]; }

bool is_running(Stage stage) { return contains(kRunning, stage); }
bool is_before_half(Stage stage) { return contains(kBefore, stage); }
bool is_break(Stage stage) { return contains(kBreaks, stage); }

Side kickoff_side(const Configuration& configuration, int half) {
  const Side first = configuration.first_kickoff;
  return half % 2 == 0 ? first : opponent_of(first);
}

double time_left_s(const Memory& memory, const Configuration& configuration, double now_s) {
  if (!is_running(memory.signal.stage)) return 0;
  return std::max(0.0, configuration.half_s - (now_s - memory.half_began_s));
}

std::optional<Finding> find_time_over(const Memory& memory, const Moment& moment) {
  const Configuration& configuration = moment.configuration;
  if (!is_running(memory.signal.stage)) return std::nullopt;
  if (!has_passed(memory.half_began_s, configuration.half_s, moment.time_s())) return std::nullopt;
  Finding finding;
  const bool last = memory.half + 1 == configuration.halves;
  finding.event = last ? Event::kGameOver : Event::kHalfOver;
  finding.rule = "paper 4.2, time-related rules";
  finding.value = moment.time_s() - memory.half_began_s;
  finding.threshold = configuration.half_s;
  finding.unit = "s";
  finding.evidence =
      fmt::format("Half {} of {} began at {:.3f} s and has lasted {:.3f} s.", memory.half + 1,
                  configuration.halves, memory.half_began_s, finding.value);
  return finding;
}

}  // namespace autoref::referee
