#include "runner/experiments/kinds/effective.hpp"

#include <fmt/format.h>

#include "runner/experiments/reading/settings_text.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/yaml_bounds.hpp"
#include "runner/io/yaml_scalar.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

std::string body_of(const Scenario& scenario) {
  Scenario copy = scenario;
  if (auto* game = std::get_if<GameSettings>(&copy.content)) return text_of(settings_of(*game));
  std::string text;
  for (const Key& key : copy.experiment().keys()) {
    if (key.text) text += key.text();
  }
  return text;
}

}  // namespace

std::string effective_text(const Scenario& scenario) {
  std::string text = fmt::format("schema: 1\nkind: {}\nabout: {}\n", kind_of(scenario),
                                 quoted_scalar(scenario.about)) +
                     body_of(scenario);
  if (text.size() <= YamlBounds{}.bytes) return text;
  throw InputError(
      {}, "",
      fmt::format("the scenario has {} bytes with every setting spelt out, but at most "
                  "{} can be read back; use fewer teams",
                  text.size(), YamlBounds{}.bytes));
}

}  // namespace autoref::runner
