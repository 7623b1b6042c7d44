#include "runner/experiments/scenario.hpp"

namespace autoref::runner {
namespace {

struct AsNumber {
  std::optional<double> operator()(const std::string& /*word*/) const { return std::nullopt; }
  std::optional<double> operator()(auto number) const { return static_cast<double>(number); }
};

}  // namespace

std::optional<std::vector<double>> numbers_of(const Factor& factor) {
  std::vector<double> numbers;
  numbers.reserve(factor.values.size());
  for (const SettingValue& value : factor.values) {
    const std::optional<double> number = std::visit(AsNumber{}, value);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

// In the order of the variant's types, as is kVerbs below.
const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds = {
      "game", "sweep", "judge", "roundrobin", "sprt", "gauntlet", "knockout", "situations", "tune"};
  return kKinds;
}

std::string_view kind_of(const Scenario& scenario) { return kinds()[scenario.content.index()]; }

std::string_view verb_of(const Scenario& scenario) {
  static const std::vector<std::string> kVerbs = {"play", "run", "judge", "run", "run",
                                                  "run",  "run", "run",   "tune"};
  return kVerbs[scenario.content.index()];
}

}  // namespace autoref::runner
