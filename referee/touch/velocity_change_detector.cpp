#include "referee/touch/velocity_change_detector.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::referee {
namespace {

// Noise in two coordinates exceeds this many standard deviations once in 270 000 detections, by the
// tail of the Rayleigh distribution, exp(-5^2 / 2).
constexpr double kChangeDeviations = 5.0;

struct Ranking {
  const Candidate* best = nullptr;
  const Candidate* second = nullptr;
};

bool is_better(const Candidate& a, const Candidate& b) {
  if (a.explains != b.explains) return a.explains;
  return a.gap_m < b.gap_m;
}

Ranking ranking_of(const Candidates& candidates, Side side) {
  Ranking ranking;
  for (const Candidate& candidate : candidates) {
    if (candidate.robot.side != side) continue;
    if (ranking.best == nullptr || is_better(candidate, *ranking.best)) {
      ranking = {&candidate, ranking.best};
    } else if (ranking.second == nullptr || is_better(candidate, *ranking.second)) {
      ranking.second = &candidate;
    }
  }
  return ranking;
}

// Whether `a` rather than `b` touched the ball; false if neither explains the velocity change.
bool is_clearly_better(const Candidate& a, const Candidate* b, const TouchParameters& p) {
  if (b == nullptr) return true;
  if (!a.explains) return false;
  if (!b->explains) return b->gap_m > p.pinned_m;
  return a.gap_m + p.lead_m <= b->gap_m;
}

std::optional<RobotId> id_of(const Candidate* candidate) {
  return candidate == nullptr ? std::nullopt : std::optional(candidate->robot);
}

Verdict unknown(double gap_m, double share) {
  Verdict verdict;
  verdict.is_touch = true;
  verdict.gap_m = gap_m;
  verdict.share = share;
  return verdict;
}

Verdict touched_by(const Ranking& own, const Ranking& other, const TouchParameters& parameters) {
  Verdict verdict = unknown(own.best->gap_m, own.best->share);
  verdict.side = own.best->robot.side;
  if (is_clearly_better(*own.best, own.second, parameters)) verdict.robot = own.best->robot;
  verdict.runner_up = id_of(other.best != nullptr ? other.best : own.second);
  return verdict;
}

}  // namespace

VelocityChangeDetector::Line VelocityChangeDetector::line_through(int newest_back,
                                                                  int oldest_back) const {
  const double count = oldest_back - newest_back + 1;
  Line line;
  for (int back = newest_back; back <= oldest_back; ++back) {
    line.middle_s += ball(back).time_s / count;
    line.middle_m += ball(back).position_m / count;
  }
  double spread_s2 = 0;
  Vec2 slope_ms(0, 0);
  for (int back = newest_back; back <= oldest_back; ++back) {
    const double away_s = ball(back).time_s - line.middle_s;
    spread_s2 += away_s * away_s;
    slope_ms += away_s * (ball(back).position_m - line.middle_m);
  }
  line.velocity_mps = slope_ms / spread_s2;
  line.variance_m2ps2 = parameters_.position_noise_m * parameters_.position_noise_m / spread_s2;
  return line;
}

std::optional<VelocityChange> VelocityChangeDetector::update() {
  known_ = std::min(known_ + 1, kUsed);
  if (known_ < kUsed) {
    former_excess_ = 0;
    return std::nullopt;
  }
  const Line after = line_through(0, kHalf);
  const Line before = line_through(kHalf, 2 * kHalf);
  const Vec2 change_mps = unexplained_change_mps(before, after);
  const double noise_mps = std::sqrt(after.variance_m2ps2 + before.variance_m2ps2);
  const double excess = change_mps.norm() / (kChangeDeviations * noise_mps);
  const bool is_past_peak = former_excess_ > 1 && excess < former_excess_;
  std::optional<VelocityChange> found;
  if (is_past_peak) {
    found = former_;
    found->before = &frames_.detection(kHalf + 2);
    found->after = &frames_.detection(kHalf);
  }
  former_.since_s = ball(2 * kHalf).time_s;
  former_.segment = {before.at(ball(kHalf + 1).time_s), after.at(ball(kHalf - 1).time_s)};
  former_.impulse = {change_mps, after.velocity_mps};
  former_excess_ = is_past_peak ? 0 : excess;
  return found;
}

// The velocity change minus the deceleration that friction can explain.
Vec2 VelocityChangeDetector::unexplained_change_mps(const Line& before, const Line& after) const {
  const Vec2 change_mps = after.velocity_mps - before.velocity_mps;
  const double carpet_mps = parameters_.carpet_mps2 * (after.middle_s - before.middle_s);
  const Vec2 forwards = direction_of(before.velocity_mps, Vec2(0, 0));
  const double lost_mps = std::clamp(-change_mps.dot(forwards), 0.0, carpet_mps);
  return change_mps + lost_mps * forwards;
}

Verdict attribute_touch(const Candidates& candidates, double gap_to_goals_m,
                        std::optional<Side> had_it, const TouchParameters& parameters) {
  if (candidates.empty()) return {};
  const Ranking west = ranking_of(candidates, Side::kWest);
  const Ranking east = ranking_of(candidates, Side::kEast);
  const bool both = west.best != nullptr && east.best != nullptr;
  const double nearest_m = both ? std::min(west.best->gap_m, east.best->gap_m) : 0;
  const double latest = both ? std::max(west.best->share, east.best->share) : 0;
  Verdict verdict = unknown(nearest_m, latest);
  if (west.best != nullptr && is_clearly_better(*west.best, east.best, parameters)) {
    verdict = touched_by(west, east, parameters);
  } else if (east.best != nullptr && is_clearly_better(*east.best, west.best, parameters)) {
    verdict = touched_by(east, west, parameters);
  }
  if (gap_to_goals_m > parameters.reach_m || verdict.side == had_it) return verdict;
  if (gap_to_goals_m + parameters.lead_m <= verdict.gap_m) return {};
  if (gap_to_goals_m <= verdict.gap_m + parameters.lead_m) {
    return unknown(verdict.gap_m, verdict.share);
  }
  return verdict;
}

}  // namespace autoref::referee
