// State of a search for weaknesses, computed from its rows by repeating the search.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/weakness/weakness_trials.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {

// Scenes of a situation compared with the usual scenes: those drawn from its whole family, with the
// same robots.
struct ComparedScenes {
  SceneTrial trial;
  SceneGroup scenes;
  SceneGroup usual;
  PairedDifference excess;  // scores of `scenes` minus those of `usual`
};

// The result of a search.
struct Find {
  SearchName search;
  // Mean score of the candidates in the last iteration. Higher than the result deserves, since the
  // search chose what scored well.
  Score searched;
  // The test on new scenes; nullopt until it has been played, or if no scene can be drawn because
  // robots overlap. p values are corrected over all finds.
  std::optional<ComparedScenes> test = {};
  // Whether the attackers score more than usual: the test's corrected p value is at most
  // kSignificant.
  bool is_confirmed = false;
  std::vector<RobotOfSituation> left_out = {};  // in the order in which they were left out
  // The final test without these robots; nullopt until it has been played, if all robots are
  // needed, or if no scene can be drawn. p values are corrected over all final tests.
  std::optional<ComparedScenes> reduced = {};
  bool is_reduction_confirmed = false;  // like is_confirmed, by the final test

  // The confirmed test with the fewest robots.
  const std::optional<ComparedScenes>& last_test() const {
    return is_reduction_confirmed ? reduced : test;
  }
};

// An iteration of a search.
struct SearchStep {
  SearchName search;
  int iteration = 1;
  std::optional<double> mean_score;  // mean score of the candidates,
  std::optional<double> best_score;  // and the highest; nullopt if none could be drawn
};

struct WeaknessState {
  std::vector<SceneTrial> trials;                          // all trials known, in playing order
  std::vector<SearchStep> steps;                           // all iterations that have been played
  std::map<std::string, std::optional<SceneGroup>> usual;  // by family; nullopt until played
  std::vector<Find> finds;  // by family and search; empty until the tests have been played
  // The expected number of scenes after those of `trials`; positive until the experiment is
  // complete.
  std::size_t scenes_to_come = 0;
  bool is_complete = false;
};

// Considers trials in playing order until one lacks a row, so the state depends neither on the
// number of workers nor on the order of the rows.
WeaknessState state_of(const Weakness& weakness, const RowsById& rows);

// The state if every candidate scored 0 and no find were confirmed.
WeaknessState state_without_finds(const Weakness& weakness);

}  // namespace autoref::experiments
