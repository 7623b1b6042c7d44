// Reads the settings for playing and scoring scenes.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/keys.hpp"
#include "game/loop/start_scene.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// The keys that read_scene() reads.
std::vector<std::string> scene_key_names();

// The scene's keys at the top level of a scenario file, which are read into `scene`.
std::vector<Key> scene_keys(const std::shared_ptr<game::Scene>& scene);

// Reads the keys lasts_s, score and ends_on, as far as `entries` contains them. `branch` is the
// path of the mapping that contains the keys, or empty. Throws InputError.
void read_scene(const game::YamlFile& file, const std::vector<game::YamlEntry>& entries,
                std::string_view branch, game::Scene& scene);

}  // namespace autoref::experiments
