#include "app/game/speed.hpp"

#include <fmt/format.h>

#include <optional>

#include "io/errors.hpp"
#include "io/words.hpp"
#include "league/simulator/simulator_command.hpp"

namespace autoref::app {
double speed_factor_in(const std::string& text, std::string_view others) {
  const std::optional<double> factor = io::number_in(text);
  if (factor && *factor >= league::kSlowestSimulation && *factor <= league::kFastestSimulation)
    return *factor;
  const char* separator = others.find(" or ") == std::string_view::npos ? " or " : ", ";
  throw io::InputError(
      {"--speed"}, "",
      fmt::format("expected a factor from {} to {}{}{}, found '{}'", league::kSlowestSimulation,
                  league::kFastestSimulation, separator, others, text));
}

}  // namespace autoref::app
