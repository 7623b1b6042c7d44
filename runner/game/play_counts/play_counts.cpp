#include "runner/game/play_counts/play_counts.hpp"

#include <fmt/format.h>

#include <string_view>

namespace autoref::runner {

std::vector<NamedCount> named(const std::array<PlayCounts, 2>& counts) {
  const PlayCounts& a = counts[0];
  const PlayCounts& b = counts[1];
  std::vector<NamedCount> all;
  const auto add = [&](std::string_view name, const auto& of_a, const auto& of_b) {
    all.push_back({fmt::format("{}_a", name), of_a});
    all.push_back({fmt::format("{}_b", name), of_b});
  };
  const auto add_count = [&](std::string_view name, int PlayCounts::*count) {
    add(name, std::to_string(a.*count), std::to_string(b.*count));
  };
  add_count("shots", &PlayCounts::shots);
  add_count("shots_on_goal", &PlayCounts::shots_on_goal);
  add_count("passes_tried", &PlayCounts::passes_tried);
  add_count("passes_completed", &PlayCounts::passes_completed);
  add("possession_s", fmt::format("{:.3f}", a.possession_s), fmt::format("{:.3f}", b.possession_s));
  add_count("fouls", &PlayCounts::fouls);
  add_count("duels_won", &PlayCounts::duels_won);
  return all;
}

}  // namespace autoref::runner
