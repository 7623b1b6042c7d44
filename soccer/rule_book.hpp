// The rules in force and their parameters, each with its source.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/parameters.hpp"
#include "soccer/rule_id.hpp"
#include "soccer/units.hpp"

namespace autoref {

// Which edition a rule book follows; the divisions within an edition differ in numbers.
enum class Edition : std::uint8_t { kPaper, kLaws2014, kRules2026 };

// The rules of an edition, from rules.def. For the paper: the rules it describes (section 4.2) and
// those needed for games to end.
RuleSet rules_of(Edition edition);

// The rules in force and their numbers. The defaults are those of the paper.
struct RuleBook {
  std::string name = "paper";
  Edition edition = Edition::kPaper;
  RuleSet in_force = rules_of(Edition::kPaper);

  // The numbers of rule_numbers.def, each with its default.
#define AUTOREF_NUMBER(type, name, value, ...) type name = value;
#include "soccer/rule_numbers.def"
#undef AUTOREF_NUMBER

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
#define AUTOREF_NUMBER(type, name, value, range, about, source) \
  visitor(self.name, {#name, range, about, source});
#include "soccer/rule_numbers.def"
#undef AUTOREF_NUMBER
  }

  bool has(RuleId rule) const { return in_force.has(rule); }
  bool operator==(const RuleBook&) const = default;
};

// Defaults for games under a rule book.
struct GameSetup {
  Field field;
  int robots = 6;  // per team
  double half_s = 600;
  // Kickers and dribblers: a preset of sim/robot_presets.hpp.
  std::string kickers_and_dribblers = "default";
  double latency_error_s = 0;  // sim/configuration.hpp
};

// The rule book of that name; nullopt if the name is unknown.
std::optional<RuleBook> find_rule_book(std::string_view name);
std::vector<std::string> rule_book_names();

// The setup for the rule book of that name; nullopt if the name is unknown.
std::optional<GameSetup> find_game_setup(std::string_view name);

}  // namespace autoref
