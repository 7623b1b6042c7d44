#include "runner/experiments/kinds/scenario_reader.hpp"

#include <fmt/format.h>

#include <memory>

#include "runner/experiments/kinds/all_kinds.hpp"
#include "runner/experiments/reading/base_reader.hpp"
#include "runner/experiments/reading/top_reader.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {
namespace {

// Reads one document, top level first.
class ScenarioReader {
 public:
  ScenarioReader(const YamlFile& file, const Assignments& assignments) : top_(file, assignments) {}

  Scenario read() {
    read_schema();
    const YamlEntry& kind_entry = top_.required("kind");
    refuse_other_files(kind_entry);
    std::vector<std::string> known = {std::string(kGameKind)};
    for (const Kind* kind : kinds_of_experiments()) known.emplace_back(kind->name);
    const std::string name = top_.word(kind_entry, "kind", known);
    Scenario scenario;
    if (const YamlEntry* about = top_.find("about")) {
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
  void refuse_other_files(const YamlEntry& kind) const {
    const std::string text = kind.value.IsScalar() ? kind.value.Scalar() : "";
    if (text == "lab") {
      top_.file().refuse(value_location(kind), "kind",
                         "this is a scene; play it with: autoref lab FILE");
    }
    if (text == "robot") {
      top_.file().refuse(value_location(kind), "kind",
                         "this is a robot type; name it in a scenario as a team's type");
    }
  }

  void read_schema() const {
    const YamlEntry& schema = top_.required("schema");
    const std::string expected = "1, the only schema so far";
    const std::string text = top_.file().scalar(schema, "schema", expected, true);
    if (whole_number_in(text) == 1) return;
    top_.file().refuse(value_location(schema), "schema",
                       fmt::format("expected {}, found '{}'", expected, text));
  }

  GameSettings read_game() {
    GameSettings game;
    SettingsReader settings(top_.file(), game, top_.locations());
    top_.allow(settings.names());
    read_settings(top_.entries(), settings);
    top_.check([&game] { check_game(game); });
    top_.assign_all(game);
    return game;
  }

  TopReader top_;
};

}  // namespace

Scenario read_scenario_text(const std::string& text, const std::string& file_name,
                            const Assignments& assignments) {
  const YamlFile file(text, file_name);
  return ScenarioReader(file, assignments).read();
}

Scenario read_scenario(const std::filesystem::path& file, const Assignments& assignments) {
  return read_scenario_text(read_user_file(file), file.string(), assignments);
}

}  // namespace autoref::runner
