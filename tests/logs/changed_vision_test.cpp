// Recorded games are judged alike whatever vision recorded them.
#include "tests/logs/changed_vision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/temporary_folder.hpp"

namespace autoref::logs {
namespace {

constexpr double kHalf_s = 60;
constexpr int kGames = AUTOREF_CHANGED_GAMES;  // of each rule book

struct Counts {
  int calls = 0;  // with the unchanged vision
  int same = 0;
  int others = 0;  // with the changed vision only

  double share() const { return static_cast<double>(same) / std::max(1, calls + others); }
};

struct ChangedVision {
  std::string name;
  double least = 0;  // share of equal calls
  std::function<RecordedVision(RecordedVision, RandomStream)> change;
  double same_s = 0.1;  // calls within this time are equal
  // Whether calls count at that time.
  std::function<bool(double time_s)> counts = [](double) { return true; };
};

void PrintTo(const ChangedVision& changed, std::ostream* out) { *out << changed.name; }

bool has_same(const std::vector<Call>& calls, const Call& call, double same_s) {
  return std::any_of(calls.begin(), calls.end(), [&](const Call& other) {
    return other.event == call.event && other.side == call.side &&
           std::abs(other.stop_s - call.stop_s) <= same_s;
  });
}

void count(const std::vector<Call>& whole, const std::vector<Call>& judged,
           const ChangedVision& changed, Counts& counts) {
  for (const Call& call : whole) {
    if (!changed.counts(call.stop_s)) continue;
    ++counts.calls;
    counts.same += has_same(judged, call, changed.same_s) ? 1 : 0;
  }
  for (const Call& call : judged) {
    const bool is_extra = changed.counts(call.stop_s) && !has_same(whole, call, changed.same_s);
    counts.others += is_extra ? 1 : 0;
  }
}

// A game and AutoRef's calls with its unchanged vision.
struct EvaluatedGame {
  RecordedVision vision;
  std::vector<Call> calls;
};

const std::vector<EvaluatedGame>& games() {
  static const std::vector<EvaluatedGame> all = [] {
    const TemporaryFolder folder;
    std::vector<EvaluatedGame> played;
    for (const char* book : {"2026-b", "paper"}) {
      for (std::uint64_t seed = 1; seed <= kGames; ++seed) {
        RecordedVision vision = played_vision(book, kHalf_s, seed);
        std::vector<Call> calls = judged_calls(vision, folder / "game.log");
        played.push_back({std::move(vision), std::move(calls)});
      }
    }
    return played;
  }();
  return all;
}

std::vector<Call> later(std::vector<Call> calls, double by_s) {
  for (Call& call : calls) call.stop_s += by_s;
  return calls;
}

class LogWithChangedVision : public testing::TestWithParam<ChangedVision> {};

TEST_P(LogWithChangedVision, IsJudgedAlike) {
  const TemporaryFolder folder;
  Counts counts;
  std::uint64_t seed = 0;
  for (const EvaluatedGame& game : games()) {
    const RecordedVision changed = GetParam().change(game.vision, RandomStream(++seed));
    const double begin_s = changed.frames.front().t_capture();
    count(game.calls, later(judged_calls(changed, folder / "game.log"), begin_s), GetParam(),
          counts);
  }
  EXPECT_GE(counts.calls, 20);
  EXPECT_GE(counts.share(), GetParam().least)
      << counts.same << " of " << counts.calls << " calls, and " << counts.others << " others";
  RecordProperty("share", std::to_string(counts.share()));
}

ChangedVision rate(double rate_hz, double least) {
  return {"At" + std::to_string(std::lround(rate_hz)) + "Hz", least,
          [rate_hz](RecordedVision vision, RandomStream) {
            return at_rate(std::move(vision), rate_hz);
          },
          std::max(0.1, 1.5 / rate_hz)};
}

ChangedVision cameras(int count, bool is_staggered, double least) {
  return {(is_staggered ? "ByTurnsOf" : "Of") + std::to_string(count) + "Cameras", least,
          [=](RecordedVision vision, RandomStream chance) {
            return through_cameras(std::move(vision), count, 0.02, is_staggered, chance);
          }};
}

ChangedVision false_balls(double per_s, double least) {
  return {"With" + std::to_string(std::lround(per_s)) + "FalseBallsPerSecond", least,
          [per_s](RecordedVision vision, RandomStream chance) {
            return with_false_balls(std::move(vision), per_s, chance);
          }};
}

constexpr double kSilence_s = 3;
constexpr double kEvery_s = 15;
constexpr double kMiddle_s = 30;

// The floors are about 0.1 below the least share in sets of six games with other seeds.
const std::vector<ChangedVision> kChanges = {
    {"Unchanged", 1, [](RecordedVision vision, RandomStream) { return vision; }},
    rate(10, 0.35),
    rate(20, 0.5),
    rate(30, 0.6),
    rate(60, 0.65),
    rate(120, 0.5),
    {"WithFramesMissing", 0.5,
     [](RecordedVision vision, RandomStream chance) {
       return irregular(std::move(vision), 0.5, 0, chance);
     }},
    {"WithIrregularTimes", 0.55,
     [](RecordedVision vision, RandomStream chance) {
       return irregular(std::move(vision), 0.2, 0.002, chance);
     }},
    {"SilentForSeconds", 0.85,
     [](RecordedVision vision, RandomStream) {
       return with_silences(std::move(vision), kSilence_s, kEvery_s);
     },
     0.1,
     [](double time_s) {
       const double phase_s = std::fmod(time_s, kEvery_s);
       return phase_s > 0.6 && phase_s < kEvery_s - kSilence_s - 0.1;
     }},
    cameras(1, false, 0.55),
    cameras(2, false, 0.55),
    cameras(4, false, 0.55),
    cameras(8, false, 0.45),
    cameras(2, true, 0.5),
    cameras(8, true, 0.45),
    false_balls(1, 0.85),
    false_balls(10, 0.6),
    {"WithABallBesideTheField", 0.9,
     [](RecordedVision vision, RandomStream) {
       const double beside_m = vision.field.half_width_m() + 0.2;
       return with_second_ball(std::move(vision), {0, beside_m});
     }},
    {"WithASecondBall", 0.9,
     [](RecordedVision vision, RandomStream) {
       return with_second_ball(std::move(vision), {2, 1});
     }},
    {"WithDoubleRobots", 0.95,
     [](RecordedVision vision, RandomStream chance) {
       return with_double_robots(std::move(vision), 0.1, 0.015, chance);
     }},
    {"BeginningInTheMiddle", 0.95,
     [](RecordedVision vision, RandomStream) { return from(std::move(vision), kMiddle_s); }, 0.1,
     [](double time_s) { return time_s > kMiddle_s + 2; }},
    {"WithoutReferee", 0.6,
     [](RecordedVision vision, RandomStream) { return without_referee(std::move(vision)); }},
};

// Its frames lag, since a tracker smooths, and false balls and unseen robots come from it, too.
TEST(LogWithTracker, IsJudgedFromItIfChosen) {
  const TemporaryFolder folder;
  Counts counts;
  for (const EvaluatedGame& game : games()) {
    const RecordedVision both = with_tracker(game.vision);
    RecordedVision alone = both;
    alone.frames.resize(1);
    EXPECT_EQ(judged_calls(both, folder / "both.log").size(), game.calls.size());
    const std::vector<Call> chosen =
        judged_calls(both, folder / "tracker.log", league::FrameSource::kTracker);
    EXPECT_EQ(chosen.size(),
              judged_calls(alone, folder / "alone.log", league::FrameSource::kTracker).size());
    count(game.calls, chosen, kChanges.front(), counts);
  }
  EXPECT_GT(counts.share(), 0.5) << counts.same << " of " << counts.calls << " calls";
}

INSTANTIATE_TEST_SUITE_P(All, LogWithChangedVision, testing::ValuesIn(kChanges),
                         [](const auto& changed) { return changed.param.name; });

}  // namespace
}  // namespace autoref::logs
