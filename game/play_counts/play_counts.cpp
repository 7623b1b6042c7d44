#include "game/play_counts/play_counts.hpp"

namespace autoref::game {
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

}  // namespace

std::span<const CountField> count_fields() { return kCountFields; }

}  // namespace autoref::game
