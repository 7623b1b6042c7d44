#include "soccer/rules/game_event.hpp"

#include <algorithm>
#include <array>

namespace autoref {
namespace {

struct NamedType {
  GameEventType type;
  std::string_view name;
};

constexpr auto kGameEventTypes = std::to_array<NamedType>({
#define AUTOREF_GAME_EVENT(id, number, name) {GameEventType::id, name},
#include "soccer/rules/game_events.def"
#undef AUTOREF_GAME_EVENT
});

}  // namespace

std::string_view name_of(GameEventType type) {
  const auto found = std::find_if(kGameEventTypes.begin(), kGameEventTypes.end(),
                                  [type](const NamedType& known) { return known.type == type; });
  return found == kGameEventTypes.end() ? std::string_view() : found->name;
}

std::optional<GameEventType> game_event_type(std::string_view name) {
  const auto found = std::find_if(kGameEventTypes.begin(), kGameEventTypes.end(),
                                  [name](const NamedType& known) { return known.name == name; });
  return found == kGameEventTypes.end() ? std::nullopt : std::optional(found->type);
}

}  // namespace autoref
