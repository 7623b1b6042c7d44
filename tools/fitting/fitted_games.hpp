// Simulated games to which models are fitted, and those of a team that is left out, which test the
// fit.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"

namespace autoref::tools {

// The team whose games test the fit.
inline constexpr const char* kLeftOut = "cobalt";

// "cobalt, cobalt1, dummy": the teams that play in none of the games for the fit.
std::string teams_left_out();

enum class Purpose { kFit, kTest };

// Observes a game and says as text what is to be known about it.
class GameText : public game::Observer {
 public:
  // Called after the game. Must not return an empty text.
  virtual std::string text(const game::GameRecord& record) const = 0;
};
using MakeGameText = std::function<std::unique_ptr<GameText>(const game::GameConfiguration&)>;

// The number of games in a batch.
inline constexpr std::size_t kBatch = 100;

// The texts of batch number `batch`, counted from 0. Teams that shoot play each other and
// themselves, in turn, without the team left out; or, to test, each of them plays the team left
// out, which also plays itself. Games for fitting and for testing have different seeds. The batch
// does not depend on the number of processors. Throws std::runtime_error if a game fails.
std::vector<std::string> texts_of_batch(const std::string& rules, Purpose purpose,
                                        std::size_t batch, const MakeGameText& make);

}  // namespace autoref::tools
