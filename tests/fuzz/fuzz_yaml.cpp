// Fuzzes the readers of scenarios, robot types, presets, scenes and the referee's decisions with
// arbitrary text, which they must either accept or reject. Scenarios with many games are excluded:
// reading one expands up to 100,000 games, and the fuzzer would keep generating such slow inputs.
#include <cstdint>
#include <string>

#include "experiments/kinds/scenario_reader.hpp"
#include "game/lab/lab.hpp"
#include "game/settings/measured_presets.hpp"
#include "game/settings/robot_types.hpp"
#include "io/errors.hpp"
#include "view/game_recording.hpp"

namespace {

using namespace autoref;

template <typename Read>
void expect_nothing_but_a_refusal(const Read& read) {
  try {
    read();
  } catch (const io::InputError&) {  // rejected with a message
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const bool is_game = text.find("kind: game") != std::string::npos;
  if (is_game)
    expect_nothing_but_a_refusal([&] { experiments::read_scenario_text(text, "x.yaml"); });
  expect_nothing_but_a_refusal([&] { game::read_robot_type_text(text, "x.yaml"); });
  expect_nothing_but_a_refusal([&] { game::read_measured_text(text, "x.yaml"); });
  expect_nothing_but_a_refusal([&] { game::read_lab_scene_text(text, "x.yaml"); });
  expect_nothing_but_a_refusal([&] { view::decisions_in(text, "x.jsonl"); });
  return 0;
}
