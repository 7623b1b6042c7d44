#include "experiments/kinds/weakness/weakness_state.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

// The scenes of a trial; nullopt if one of them has not been played.
using Scenes = std::function<std::optional<SceneGroup>(const SceneTrial&)>;

// If all pairs have the same difference, p is that of the sign test: all of them have its sign.
ComparedScenes compared_scenes(SceneTrial trial, SceneGroup scenes, SceneGroup usual) {
  ComparedScenes compared{std::move(trial), std::move(scenes), std::move(usual), {}};
  PairedDifference& excess = compared.excess;
  excess = paired_difference(compared.scenes.pair_scores, compared.usual.pair_scores);
  if (!excess.p && excess.pairs > 1 && excess.mean != 0.0)
    excess.p = std::ldexp(1.0, 1 - static_cast<int>(excess.pairs));
  return compared;
}

// A search that is being repeated.
struct RepeatedSearch {
  SearchName name;
  std::unique_ptr<Optimiser> optimiser;
  // The candidates' trials in this iteration; nullopt if a candidate cannot be drawn.
  std::vector<std::optional<SceneTrial>> candidates = {};
};

// An attempt to leave one more robot out of a find.
struct Attempt {
  RobotOfSituation robot;
  ReducedTrials trials;
};

class RepeatedRun {
 public:
  RepeatedRun(const Weakness& weakness, Scenes scenes)
      : weakness_(weakness), scenes_(std::move(scenes)) {}

  WeaknessState run() {
    for (const auto& [family, situation] : weakness_.situations) state_.usual[family];
    state_.is_complete = search() && test() && reduce() && test_reduced();
    return std::move(state_);
  }

 private:
  const SituationSetup& family_of(const SearchName& search) const {
    return weakness_.situations.at(search.family);
  }

  // Plays trials as a round. Returns false if one of their scenes has not been played.
  bool play(const std::vector<SceneTrial>& trials) {
    bool is_played = true;
    for (const SceneTrial& trial : trials) {
      state_.trials.push_back(trial);
      std::optional<SceneGroup> scenes = scenes_(trial);
      is_played = is_played && scenes.has_value();
      if (scenes) played_[trial.name] = std::move(*scenes);
    }
    return is_played;
  }

  SituationSetup situation_of(const RepeatedSearch& search, const Point& point) const {
    return situation_at(family_of(search.name), weakness_.base.field, point, weakness_.spread);
  }

  bool search() {
    for (const SearchName& name : searches_of(weakness_)) {
      searches_.push_back(
          {name, optimiser_of(family_of(name), weakness_.base.field, weakness_.iterations,
                              seed_of_search(weakness_, name))});
    }
    for (int iteration = 1; iteration <= weakness_.iterations; ++iteration) {
      std::vector<SceneTrial> trials;
      for (RepeatedSearch& search : searches_) {
        ask(search, iteration);
        for (const auto& candidate : search.candidates)
          if (candidate) trials.push_back(*candidate);
      }
      if (!play(trials)) {
        expect_searches_after(iteration);
        return false;
      }
      for (RepeatedSearch& search : searches_) report_scores(search, iteration);
    }
    return true;
  }

  void ask(RepeatedSearch& search, int iteration) const {
    search.candidates.clear();
    for (const Candidate& candidate : search.optimiser->ask()) {
      SceneTrial trial = candidate_trial(weakness_, search.name, iteration, candidate.name,
                                         situation_of(search, candidate.point));
      search.candidates.push_back(drawable(std::move(trial)));
    }
  }

  void report_scores(RepeatedSearch& search, int iteration) {
    std::vector<Score> scores;
    std::vector<double> known;
    for (const auto& candidate : search.candidates) {
      scores.push_back(candidate ? mean_of(played_.at(candidate->name).scores) : std::nullopt);
      if (scores.back()) known.push_back(*scores.back());
    }
    search.optimiser->tell(scores);
    const auto best = std::max_element(known.begin(), known.end());
    state_.steps.push_back({search.name, iteration, mean_of(known),
                            best == known.end() ? std::nullopt : std::optional(*best)});
  }

  void expect_searches_after(int iteration) {
    std::size_t candidates = 0;
    for (const RepeatedSearch& search : searches_) candidates += search.candidates.size();
    const auto iterations = static_cast<std::size_t>(weakness_.iterations - iteration);
    state_.scenes_to_come =
        2 * (iterations * candidates * static_cast<std::size_t>(weakness_.pairs) +
             (weakness_.situations.size() + searches_.size()) *
                 static_cast<std::size_t>(weakness_.test_pairs));
  }

  // Tests the centre of each search after its last iteration.
  bool test() {
    std::vector<SceneTrial> trials;
    for (const auto& [family, situation] : weakness_.situations)
      trials.push_back(usual_trial(weakness_, family));
    std::vector<std::optional<SceneTrial>> tests;
    for (const RepeatedSearch& search : searches_) {
      tests.push_back(drawable(
          test_trial(weakness_, search.name, situation_of(search, search.optimiser->centre()))));
      if (tests.back()) trials.push_back(*tests.back());
    }
    if (!play(trials)) {
      state_.scenes_to_come = 1;
      return false;
    }
    for (const auto& [family, situation] : weakness_.situations)
      state_.usual[family] = played_.at(usual_trial(weakness_, family).name);
    for (std::size_t i = 0; i < tests.size(); ++i) {
      Find find{searches_[i].name, last_score(searches_[i].name)};
      if (tests[i]) {
        find.test = compared_scenes(*tests[i], played_.at(tests[i]->name),
                                    *state_.usual.at(tests[i]->family));
      }
      state_.finds.push_back(std::move(find));
    }
    confirm(&Find::test, &Find::is_confirmed);
    return true;
  }

  std::optional<SceneTrial> drawable(SceneTrial trial) const {
    return experiments::can_be_drawn(trial, weakness_.base.field) ? std::optional(std::move(trial))
                                                                  : std::nullopt;
  }

  Score last_score(const SearchName& name) const {
    const auto last = std::find_if(state_.steps.rbegin(), state_.steps.rend(),
                                   [&name](const SearchStep& step) { return step.search == name; });
    return last == state_.steps.rend() ? std::nullopt : last->mean_score;
  }

  void confirm(std::optional<ComparedScenes> Find::*test, bool Find::*is_confirmed) {
    std::vector<PairedDifference*> all;
    for (Find& find : state_.finds)
      if (find.*test) all.push_back(&(find.*test)->excess);
    correct_by_holm(all, [](PairedDifference* one) -> PairedDifference& { return *one; });
    for (Find& find : state_.finds) {
      if (!(find.*test)) continue;
      const PairedDifference& excess = (find.*test)->excess;
      find.*is_confirmed =
          excess.p_holm && *excess.p_holm <= kSignificant && excess.mean.value_or(0) > 0;
    }
  }

  // Leaves robots out of all confirmed finds at the same time, one robot of each find per round.
  bool reduce() {
    std::vector<Find*> open;
    for (Find& find : state_.finds)
      if (find.is_confirmed) open.push_back(&find);
    for (int round = 1; !open.empty(); ++round) {
      std::map<const Find*, std::vector<Attempt>> attempts;
      std::vector<SceneTrial> trials;
      for (const Find* find : open) {
        attempts[find] = attempts_of(*find, round);
        for (const Attempt& attempt : attempts[find]) {
          trials.push_back(attempt.trials.reduced);
          trials.push_back(attempt.trials.usual);
        }
      }
      if (!play(trials)) {
        state_.scenes_to_come = 4 * static_cast<std::size_t>(weakness_.test_pairs);
        return false;
      }
      std::erase_if(open, [&](Find* find) { return !leave_out_one(*find, attempts[find]); });
    }
    return true;
  }

  // Without attackers, nobody would score.
  std::vector<Attempt> attempts_of(const Find& find, int round) const {
    const SituationSetup now = situation_without(find.test->trial.situation, find.left_out);
    std::vector<Attempt> attempts;
    for (const RobotOfSituation& robot : robots_of(now)) {
      if (robot.is_attacker && now.attackers.size() == 1) continue;
      std::vector<RobotOfSituation> left_out = find.left_out;
      left_out.push_back(robot);
      ReducedTrials trials = reduced_trials(weakness_, find.search, find.test->trial.situation,
                                            left_out, round, path_of(robot));
      if (can_be_drawn(trials)) attempts.push_back({robot, std::move(trials)});
    }
    return attempts;
  }

  bool can_be_drawn(const ReducedTrials& trials) const {
    return drawable(trials.reduced) && drawable(trials.usual);
  }

  PairedDifference excess_of(const ReducedTrials& trials) const {
    return paired_difference(played_.at(trials.reduced.name).pair_scores,
                             played_.at(trials.usual.name).pair_scores);
  }

  // Leaves out the robot without which most of the weakness remains. Returns false if too little
  // would remain without any of them. Keeps robots whose absence alone lets the attackers score,
  // such as the keeper.
  bool leave_out_one(Find& find, const std::vector<Attempt>& attempts) const {
    double most = weakness_.kept_share * *find.test->excess.mean;
    const double most_usual = mean(find.test->usual.scores) + *find.test->excess.mean - most;
    const Attempt* best = nullptr;
    for (const Attempt& attempt : attempts) {
      const std::optional<double> excess = excess_of(attempt.trials).mean;
      if (!excess || *excess < most) continue;
      if (mean(played_.at(attempt.trials.usual.name).scores) > most_usual) continue;
      most = *excess;
      best = &attempt;
    }
    if (best == nullptr) return false;
    find.left_out.push_back(best->robot);
    return true;
  }

  bool test_reduced() {
    std::map<const Find*, ReducedTrials> finals;
    std::vector<SceneTrial> trials;
    for (const Find& find : state_.finds) {
      if (find.left_out.empty()) continue;
      ReducedTrials both = reduced_trials(weakness_, find.search, find.test->trial.situation,
                                          find.left_out, 0, kFinalAttempt);
      if (!can_be_drawn(both)) continue;
      trials.push_back(both.reduced);
      trials.push_back(both.usual);
      finals[&find] = std::move(both);
    }
    if (!play(trials)) {
      state_.scenes_to_come = 1;
      return false;
    }
    for (Find& find : state_.finds) {
      const auto its = finals.find(&find);
      if (its == finals.end()) continue;
      find.reduced = compared_scenes(its->second.reduced, played_.at(its->second.reduced.name),
                                     played_.at(its->second.usual.name));
    }
    confirm(&Find::reduced, &Find::is_reduction_confirmed);
    return true;
  }

  const Weakness& weakness_;
  Scenes scenes_;
  WeaknessState state_;
  std::vector<RepeatedSearch> searches_;
  std::map<std::string, SceneGroup> played_;  // by name of the trial
};

}  // namespace

WeaknessState state_of(const Weakness& weakness, const RowsById& rows) {
  return RepeatedRun(weakness,
                     [&](const SceneTrial& trial) { return played_scenes(weakness, trial, rows); })
      .run();
}

WeaknessState state_without_finds(const Weakness& weakness) {
  return RepeatedRun(weakness,
                     [](const SceneTrial& /*trial*/) {
                       SceneGroup scenes;
                       scenes.scores = {0};
                       return std::optional(scenes);
                     })
      .run();
}

}  // namespace autoref::experiments
