#include "runner/game/play_counts/play_figures.hpp"

#include <fmt/format.h>

#include <string_view>

namespace autoref::runner {

std::vector<NamedFigure> named(const std::array<PlayFigures, 2>& figures) {
  const PlayFigures& a = figures[0];
  const PlayFigures& b = figures[1];
  std::vector<NamedFigure> all;
  const auto add = [&](std::string_view name, const auto& of_a, const auto& of_b) {
    all.push_back({fmt::format("{}_a", name), of_a});
    all.push_back({fmt::format("{}_b", name), of_b});
  };
  const auto add_count = [&](std::string_view name, int PlayFigures::*count) {
    add(name, std::to_string(a.*count), std::to_string(b.*count));
  };
  add_count("shots", &PlayFigures::shots);
  add_count("shots_on_goal", &PlayFigures::shots_on_goal);
  add_count("passes_tried", &PlayFigures::passes_tried);
  add_count("passes_completed", &PlayFigures::passes_completed);
  add("possession_s", fmt::format("{:.3f}", a.possession_s), fmt::format("{:.3f}", b.possession_s));
  add_count("fouls", &PlayFigures::fouls);
  add_count("duels_won", &PlayFigures::duels_won);
  return all;
}

}  // namespace autoref::runner
