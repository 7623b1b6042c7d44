#include "runner/settings/renamed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace autoref::runner {
namespace {

struct Renamed {
  std::string_view before;
  std::string_view now;
};

// Settings, rules and events that now have the league's names.
constexpr std::array kNames = {
    Renamed{"calm_substeps", "contact_free_substeps"},
    Renamed{"orders", "commands"},
    Renamed{"hop_z", "hop_first_z"},
    Renamed{"attacker_near_area", "attacker_too_close_to_defense_area"},
    Renamed{"defender_partly_in_area", "defender_in_defense_area_partially"},
    Renamed{"defender_in_area", "defender_in_defense_area"},
    Renamed{"attacker_in_area", "attacker_touched_ball_in_defense_area"},
    Renamed{"kick_speed", "bot_kicked_ball_too_fast"},
    Renamed{"dribbling", "bot_dribbled_ball_too_far"},
    Renamed{"crash_drawn", "bot_crash_drawn"},
    Renamed{"crash", "bot_crash_unique"},
    Renamed{"pushing", "bot_pushed_bot"},
    Renamed{"stop_speed", "bot_too_fast_in_stop"},
    Renamed{"restart_distance", "defender_too_close_to_kick_point"},
    Renamed{"placement_interference", "bot_interfered_placement"},
    Renamed{"double_touch", "attacker_double_touched_ball"},
    Renamed{"keeper_holding", "keeper_held_ball"},
    Renamed{"no_progress", "no_progress_in_game"},
    Renamed{"penalty_failed", "penalty_kick_failed"},
    Renamed{"goal_invalid", "invalid_goal"},
    Renamed{"goal_valid", "invalid_goal"},
    Renamed{"chip_goal", "chipped_goal"},
    Renamed{"yellow_card", "multiple_fouls"},
    Renamed{"red_card", "multiple_cards"},
};

constexpr std::array kVerbs = {Renamed{"plan", "sample-size"}};
constexpr std::array kKinds = {Renamed{"match", "sprt"}};

template <std::size_t Size>
std::optional<std::string_view> find(std::string_view before,
                                     const std::array<Renamed, Size>& table) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [before](const Renamed& it) { return it.before == before; });
  return found == table.end() ? std::nullopt : std::optional(found->now);
}

}  // namespace

std::optional<std::string_view> new_name_of(std::string_view old_name) {
  return find(old_name, kNames);
}

std::optional<std::string_view> new_verb_of(std::string_view old_verb) {
  return find(old_verb, kVerbs);
}

std::optional<std::string_view> new_kind_of(std::string_view old_kind) {
  return find(old_kind, kKinds);
}

std::string renamed_message(std::string_view old_name, std::string_view new_name) {
  return fmt::format("unknown key '{}'; its name is '{}' now", old_name, new_name);
}

}  // namespace autoref::runner
