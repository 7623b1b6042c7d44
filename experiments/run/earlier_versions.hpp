// Ratings of versions taken over from an earlier results folder.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

// Reads the earlier folder of an experiment that follows ratings over time, and sets
// TeamVersions::taken_over. Does nothing if the experiment has no such folder, or if `taken_over`
// is already set, as in effective.yaml. note_program_versions() must come first.
//
// Two teams are the same if a game of the team against itself has the same configuration_hash() in
// both experiments, as this build reads their settings, and if the files of its program are known.
// If `build` played the earlier folder, only the teams that the folder itself took over are taken
// over; games of the others are played, or reused (reused_games.hpp). If another build played it,
// all teams that are the same are taken over, except the anchors.
//
// Throws InputError if the folder is not a results folder of the same kind, or if its versions.csv
// or version_pairs.csv is missing or damaged. A complete run writes these files. `autoref report`
// also writes them for an incomplete folder; the ratings then come from the games played so far.
//
// If another build played it or if ratings are taken over, also throws InputError if an anchor or a
// team of the field has changed, if no anchor is in both folders, or if fewer than two teams of a
// round robin would play.
void take_over_versions(Scenario& scenario, const std::string& build);

// "3 of 7 teams are not played again; their ratings are taken over from FOLDER"; empty if none are.
std::string note_on_taken_over(const Experiment& experiment);

// The experiment's earlier folder if `build` played it, so that its games can be taken over
// (reused_games.hpp); otherwise empty.
std::filesystem::path reusable_earlier_folder(const Experiment& experiment,
                                              const std::string& build);

// Throws InputError if `folder` is the experiment's earlier folder.
void refuse_earlier_folder(const Experiment& experiment, const std::filesystem::path& folder);

}  // namespace autoref::experiments
