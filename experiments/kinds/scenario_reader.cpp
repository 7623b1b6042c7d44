#include "experiments/kinds/scenario_reader.hpp"

#include <fmt/format.h>
#include <memory>

#include "experiments/kinds/all_kinds.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"
#include "io/yaml_text.hpp"

namespace autoref::experiments {
namespace {

// Halves as long as the rule book of the file has them do not count as given: another rule book on
// the command line brings its own.
void forget_usual_halves(game::GameSettings& game) {
  game::GameSettings usual;
  game::choose_rules(game.match.rules.name, usual);
  for (const char* path : {"match.half_s", "match.extra_half_s"}) {
    if (game::value_at(game, path) == game::value_at(usual, path)) game.given.erase(path);
  }
}

// Reads one document, top level first.
class ScenarioReader {
 public:
  ScenarioReader(const game::YamlFile& file, const game::Assignments& assignments)
      : top_(file, assignments) {}

  Scenario read() {
    read_schema();
    const game::YamlEntry& kind_entry = top_.required("kind");
    refuse_other_files(kind_entry);
    std::vector<std::string> known = {std::string(kGameKind)};
    for (const Kind* kind : kinds_of_experiments()) known.emplace_back(kind->name);
    const std::string name = top_.word(kind_entry, "kind", known);
    Scenario scenario;
    if (const game::YamlEntry* about = top_.find("about")) {
      scenario.about = top_.file().scalar(*about, "about", "a sentence", false);
    }
    const Kind* const kind = find_kind(name);
    if (kind == nullptr) {
      scenario.content = read_game();
    } else {
      std::unique_ptr<Experiment> experiment = kind->make();
      read_keys(top_, *experiment);
      scenario.content = std::move(experiment);
    }
    return scenario;
  }

 private:
  void refuse_other_files(const game::YamlEntry& kind) const {
    const std::string text = kind.value.IsScalar() ? kind.value.Scalar() : "";
    if (text == "lab") {
      top_.file().refuse(game::value_location(kind), "kind",
                         "this is a scene; play it with: autoref experiment lab FILE");
    }
    if (text == "robot") {
      top_.file().refuse(game::value_location(kind), "kind",
                         "this is a robot type; name it in a scenario as a team's type");
    }
    if (text == "measured") {
      top_.file().refuse(game::value_location(kind), "kind",
                         "this is a preset; name it in a scenario as sim.ball or sim.camera");
    }
  }

  void read_schema() const {
    const game::YamlEntry& schema = top_.required("schema");
    const std::string expected = "1, the only schema so far";
    const std::string text = top_.file().scalar(schema, "schema", expected, true);
    if (io::whole_number_in(text) == 1) return;
    top_.file().refuse(game::value_location(schema), "schema",
                       fmt::format("expected {}, found '{}'", expected, text));
  }

  game::GameSettings read_game() {
    game::GameSettings game;
    game::SettingsReader settings(top_.file(), game, top_.locations());
    top_.allow(settings.names());
    read_settings(top_.entries(), settings);
    top_.check([&game] { game::check_game(game); });
    forget_usual_halves(game);
    top_.assign_all(game);
    // The game has the presets' values; only the factors of experiments need their names.
    game.measured_balls.clear();
    game.measured_cameras.clear();
    return game;
  }

  TopReader top_;
};

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

Scenario read_scenario_text(const std::string& text, const std::string& file_name,
                            const game::Assignments& assignments) {
  const game::YamlFile file(text, file_name);
  return ScenarioReader(file, assignments).read();
}

Scenario read_scenario(const std::filesystem::path& file, const game::Assignments& assignments) {
  return read_scenario_text(io::read_user_file(file), file.string(), assignments);
}

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
