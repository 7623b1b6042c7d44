#include "runner/experiments/reading/scene_reader.hpp"

#include <fmt/format.h>

#include "runner/io/words.hpp"
#include "runner/settings/mapping.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::runner {
namespace {

// One measure, or a mapping of measures to weights.
SceneWeights weights_in(const YamlFile& file, const YamlEntry& entry, const std::string& path) {
  const std::vector<std::string> measures = parameter_names<SceneWeights>();
  SceneWeights weights{0, 0, 0, 0};
  if (entry.value.IsMap()) {
    Mapping(file, entry, path, measures).parameters(weights);
    if (weights == SceneWeights{0, 0, 0, 0})
      file.refuse(entry.location, path, "all weights are 0; give at least one");
    return weights;
  }
  const std::string expected = fmt::format(
      "one of {}, or a weight for each such as {{ goal: 1, gained_m: 0.1 }}", listed(measures));
  const std::string word = file.scalar(entry, path, expected, false);
  SceneWeights::visit(weights, [&word](double& weight, const Parameter& about) {
    if (about.name == word) weight = 1;
  });
  if (weights == SceneWeights{0, 0, 0, 0}) {
    file.refuse(
        value_location(entry), path,
        fmt::format("expected {}, found '{}'{}", expected, word, suggestion(word, measures)));
  }
  return weights;
}

void read_ends(const YamlFile& file, const YamlEntry& entry, const std::string& path,
               Scene& scene) {
  std::vector<std::string> known = all_names<SceneEnd>();
  std::erase(known, name_of(SceneEnd::kTime));  // which ends every scene
  scene.ends = {};
  scene.ends[static_cast<std::size_t>(SceneEnd::kTime)] = true;
  for (const std::string& word : file.words(entry, path)) {
    const std::optional<SceneEnd> end = find_named<SceneEnd>(word);
    if (!end || *end == SceneEnd::kTime) {
      file.refuse(value_location(entry), path,
                  fmt::format("expected a list of {}, found '{}'{}", listed(known), word,
                              suggestion(word, known)));
    }
    scene.ends[static_cast<std::size_t>(*end)] = true;
  }
}

}  // namespace

const std::vector<std::string>& scene_keys() {
  static const std::vector<std::string> kKeys = {"lasts_s", "score", "ends_on"};
  return kKeys;
}

void read_scene(const YamlFile& file, const std::vector<YamlEntry>& entries,
                std::string_view branch, Scene& scene) {
  const std::string prefix = branch.empty() ? "" : fmt::format("{}.", branch);
  if (const YamlEntry* entry = find_entry(entries, "lasts_s"))
    assign_entry(file, *entry, {prefix + "lasts_s", &scene.lasts_s, {0, 600, true}, {}, "s", ""});
  if (const YamlEntry* entry = find_entry(entries, "score"))
    scene.weights = weights_in(file, *entry, prefix + "score");
  if (const YamlEntry* entry = find_entry(entries, "ends_on"))
    read_ends(file, *entry, prefix + "ends_on", scene);
}

}  // namespace autoref::runner
