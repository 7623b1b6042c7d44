#include "experiments/kinds/effective.hpp"

#include <fmt/format.h>

#include "experiments/reading/settings_text.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "io/yaml_bounds.hpp"
#include "io/yaml_scalar.hpp"

namespace autoref::experiments {
namespace {

std::string body_of(const Scenario& scenario) {
  Scenario copy = scenario;
  if (auto* game = std::get_if<game::GameSettings>(&copy.content))
    return text_of(game::settings_of(*game));
  std::string text;
  for (const Key& key : copy.experiment().keys()) {
    if (key.text) text += key.text();
  }
  return text;
}

}  // namespace

std::string effective_text(const Scenario& scenario) {
  std::string text = fmt::format("schema: 1\nkind: {}\nabout: {}\n", kind_of(scenario),
                                 io::quoted_scalar(scenario.about)) +
                     body_of(scenario);
  if (text.size() <= io::YamlBounds{}.bytes) return text;
  throw io::InputError(
      {}, "",
      fmt::format("the scenario has {} bytes with every setting spelt out, but at most "
                  "{} can be read back; use fewer teams",
                  text.size(), io::YamlBounds{}.bytes));
}

}  // namespace autoref::experiments
