#include "runner/cli/speed.hpp"

#include <fmt/format.h>

#include <optional>

#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

constexpr double kSlowest = 0.01;
constexpr double kFastest = 1000;

}  // namespace

double speed_factor_in(const std::string& text, std::string_view others) {
  const std::optional<double> factor = number_in(text);
  if (factor && *factor >= kSlowest && *factor <= kFastest) return *factor;
  const char* separator = others.find(" or ") == std::string_view::npos ? " or " : ", ";
  throw InputError({"--speed"}, "",
                   fmt::format("expected a factor from {} to {}{}{}, found '{}'", kSlowest,
                               kFastest, separator, others, text));
}

}  // namespace autoref::runner
