#include "experiments/scenes/scene_reader.hpp"

#include <fmt/format.h>

#include "experiments/reading/top_reader.hpp"
#include "game/settings/mapping.hpp"
#include "io/words.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::experiments {
namespace {

constexpr game::SceneWeights kNothing{0, 0, 0, 0, 0};
constexpr const char* kLasts = "lasts_s";
constexpr const char* kScore = "score";
constexpr const char* kEnds = "ends_on";

game::Setting lasts_setting(const std::string& path, game::Scene& scene) {
  return {path, &scene.lasts_s, {0, 600, true}, {}, "s", ""};
}

// The events that can end a scene early.
std::vector<std::string> ends_of_scenes() {
  std::vector<std::string> ends = all_names<game::SceneEnd>();
  std::erase(ends, name_of(game::SceneEnd::kTime));
  return ends;
}

// Reads one measure, or a mapping of measures to weights.
game::SceneWeights weights_in(const game::YamlFile& file, const game::YamlEntry& entry,
                              const std::string& path) {
  const std::vector<std::string> measures = parameter_names<game::SceneWeights>();
  game::SceneWeights weights = kNothing;
  if (entry.value.IsMap()) {
    game::Mapping(file, entry, path, measures).parameters(weights);
    if (weights == kNothing)
      file.refuse(entry.location, path, "all weights are 0; give at least one");
    return weights;
  }
  const std::string expected = fmt::format(
      "one of {}, or a weight for each such as {{ goal: 1, gained_m: 0.1 }}", io::listed(measures));
  const std::string word = file.scalar(entry, path, expected, false);
  game::SceneWeights::visit(weights, [&word](double& weight, const Parameter& about) {
    if (about.name == word) weight = 1;
  });
  if (weights == kNothing) {
    file.refuse(
        game::value_location(entry), path,
        fmt::format("expected {}, found '{}'{}", expected, word, io::suggestion(word, measures)));
  }
  return weights;
}

void read_ends(const game::YamlFile& file, const game::YamlEntry& entry, const std::string& path,
               game::Scene& scene) {
  const std::vector<std::string> known = ends_of_scenes();
  scene.ends = {};
  scene.ends[static_cast<std::size_t>(game::SceneEnd::kTime)] = true;
  for (const std::string& word : file.words(entry, path)) {
    const std::optional<game::SceneEnd> end = find_named<game::SceneEnd>(word);
    if (!end || *end == game::SceneEnd::kTime) {
      file.refuse(game::value_location(entry), path,
                  fmt::format("expected a list of {}, found '{}'{}", io::listed(known), word,
                              io::suggestion(word, known)));
    }
    scene.ends[static_cast<std::size_t>(*end)] = true;
  }
}

}  // namespace

std::vector<std::string> scene_key_names() { return {kLasts, kScore, kEnds}; }

std::vector<Key> scene_keys(const std::shared_ptr<game::Scene>& scene) {
  game::Scene usual;
  std::vector<Key> keys = {
      {kLasts, rows_of({lasts_setting(kLasts, usual)}).front().value, "seconds of play in a scene"},
      {kScore,
       fmt::format("one of {}, or a weight for each; goal",
                   io::listed(parameter_names<game::SceneWeights>())),
       "what a scene is worth"},
      {kEnds, fmt::format("list of {}; all", io::listed(ends_of_scenes())),
       "what ends a scene early"}};
  keys.front().read = [scene](TopReader& top) {
    read_scene(top.file(), top.entries(), "", *scene);
  };
  return keys;
}

void read_scene(const game::YamlFile& file, const std::vector<game::YamlEntry>& entries,
                std::string_view branch, game::Scene& scene) {
  const std::string prefix = branch.empty() ? "" : fmt::format("{}.", branch);
  if (const game::YamlEntry* entry = game::find_entry(entries, kLasts))
    game::assign_entry(file, *entry, lasts_setting(prefix + kLasts, scene));
  if (const game::YamlEntry* entry = game::find_entry(entries, kScore))
    scene.weights = weights_in(file, *entry, prefix + kScore);
  if (const game::YamlEntry* entry = game::find_entry(entries, kEnds))
    read_ends(file, *entry, prefix + kEnds, scene);
}

}  // namespace autoref::experiments
