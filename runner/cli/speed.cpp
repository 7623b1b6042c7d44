#include "runner/cli/speed.hpp"

#include <fmt/format.h>

#include <optional>

#include "league/simulator/simulator_command.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
double speed_factor_in(const std::string& text, std::string_view others) {
  const std::optional<double> factor = number_in(text);
  if (factor && *factor >= league::kSlowestSimulation && *factor <= league::kFastestSimulation)
    return *factor;
  const char* separator = others.find(" or ") == std::string_view::npos ? " or " : ", ";
  throw InputError(
      {"--speed"}, "",
      fmt::format("expected a factor from {} to {}{}{}, found '{}'", league::kSlowestSimulation,
                  league::kFastestSimulation, separator, others, text));
}

}  // namespace autoref::runner
