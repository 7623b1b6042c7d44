// Reads how scenes are played and scored.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runner/experiments/kinds/keys.hpp"
#include "runner/game/scene.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {

// The keys that read_scene() reads.
std::vector<std::string> scene_key_names();

// Those at the top level of a file, which are read into `scene`.
std::vector<Key> scene_keys(const std::shared_ptr<Scene>& scene);

// Reads lasts_s, score and ends_on, as far as `entries` has them. `branch` is the path of their
// mapping, or empty. Throws InputError.
void read_scene(const YamlFile& file, const std::vector<YamlEntry>& entries,
                std::string_view branch, Scene& scene);

}  // namespace autoref::runner
