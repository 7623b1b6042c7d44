#include "referee/touch/verdict.hpp"

#include <algorithm>

namespace autoref::referee {
namespace {

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

// Whether `a` touched the ball rather than `b`; false if neither explains the velocity change.
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
