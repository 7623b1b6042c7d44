#include "strategies/registry.hpp"

#include "strategies/basic/basic.hpp"
#include "strategies/dummy.hpp"

namespace autoref::strategies {
namespace {

std::unique_ptr<Strategy> make_basic(const Briefing& briefing) {
  return std::make_unique<basic::Basic>(briefing);
}

std::unique_ptr<Strategy> make_dummy(const Briefing& /*briefing*/) {
  return std::make_unique<Dummy>();
}

}  // namespace

const std::vector<Entry>& all_strategies() {
  static const std::vector<Entry> kEntries = {
      {"basic",
       "Keeper, wall, markers, a supporter and an attacker who shoots at the open side.",
       make_basic,
       {"shot_mps", "pass_mps"}},
      {"dummy", "Does nothing: its robots stand where they are.", make_dummy, {}},
  };
  return kEntries;
}

const Entry* find_strategy(std::string_view name) {
  for (const Entry& entry : all_strategies()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace autoref::strategies
