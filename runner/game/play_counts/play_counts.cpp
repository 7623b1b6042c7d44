#include "runner/game/play_counts/play_counts.hpp"

#include <fmt/format.h>

namespace autoref::runner {
namespace {

constexpr std::array kCountFields = {
    CountField{"shots", &PlayCounts::shots},
    CountField{"shots_on_goal", &PlayCounts::shots_on_goal},
    CountField{"passes_tried", &PlayCounts::passes_tried},
    CountField{"passes_completed", &PlayCounts::passes_completed},
    CountField{"possession_s", nullptr, &PlayCounts::possession_s},
    CountField{"fouls", &PlayCounts::fouls},
    CountField{"duels_won", &PlayCounts::duels_won},
};

std::string value_of(const PlayCounts& counts, const CountField& field) {
  return field.count != nullptr ? std::to_string(counts.*field.count)
                                : fmt::format("{:.3f}", counts.*field.seconds);
}

}  // namespace

std::span<const CountField> count_fields() { return kCountFields; }

std::vector<NamedCount> named(const std::array<PlayCounts, 2>& counts) {
  std::vector<NamedCount> all;
  all.reserve(2 * kCountFields.size());
  for (const CountField& field : kCountFields) {
    all.push_back({fmt::format("{}_a", field.name), value_of(counts[0], field)});
    all.push_back({fmt::format("{}_b", field.name), value_of(counts[1], field)});
  }
  return all;
}

}  // namespace autoref::runner
