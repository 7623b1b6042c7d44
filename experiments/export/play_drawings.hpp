// Drawings of where teams shot, where their possession chains began and ended, and where they lost
// the ball, over the games of a results folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/export/export_folder.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/run/result_folder.hpp"

namespace autoref::experiments {

inline constexpr std::size_t kMostDrawnTeams = 12;

// Replays the games as exported() does and draws a map of the shots, one of the possession chains
// and one of the losses (view/play_maps.hpp) with a panel for each team. `chosen` are names in the
// folder's rows; empty: all teams. The teams of a game with equal names have panels "a: NAME" and
// "b: NAME". Throws like exported(). Also throws InputError if no game can be drawn, if a chosen
// team has none, if there are more than kMostDrawnTeams teams, or if their fields differ.
std::vector<ResultDrawing> play_drawings(const ResultFolder& folder, const ReplayOptions& options,
                                         const std::vector<std::string>& chosen);

// Writes these drawings into `into`, which is the results folder or a subfolder, marked with the
// rows that they show.
void store_play_drawings(const ResultFolder& folder, const std::vector<ResultDrawing>& drawings,
                         const std::filesystem::path& into);

// The drawings stored in `into`, except those that show other rows than the folder has now.
std::vector<ResultDrawing> stored_play_drawings(const ResultFolder& folder,
                                                const std::filesystem::path& into);

}  // namespace autoref::experiments
