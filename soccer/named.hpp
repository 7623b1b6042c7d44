// Enumerations that are written and read by name. Each comes with a list of its names:
//
//   constexpr auto names_of(AfterGame /*any*/) {
//     return std::to_array<Named<AfterGame>>(
//         {{AfterGame::kHalt, "halt"}, {AfterGame::kNewGame, "new_game"}});
//   }
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autoref {

template <typename Enumeration>
struct Named {
  Enumeration value;
  std::string_view name;  // the name used in files, messages and settings
};

template <typename Enumeration>
concept HasNames = requires(Enumeration value) {
  names_of(value)[0].name;
};

// The enumerator's name; empty if the enumerator is not in the list.
template <HasNames Enumeration>
constexpr std::string_view name_of(Enumeration value) {
  for (const Named<Enumeration>& one : names_of(value))
    if (one.value == value) return one.name;
  return "";
}

// The enumerator with that name; nullopt if there is none.
template <HasNames Enumeration>
constexpr std::optional<Enumeration> find_named(std::string_view name) {
  for (const Named<Enumeration>& one : names_of(Enumeration{}))
    if (one.name == name) return one.value;
  return std::nullopt;
}

template <HasNames Enumeration>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Named<Enumeration>& one : names_of(Enumeration{})) names.emplace_back(one.name);
  return names;
}

}  // namespace autoref
