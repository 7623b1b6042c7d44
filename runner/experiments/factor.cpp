#include "runner/experiments/factor.hpp"

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

}  // namespace autoref::runner
