#include "experiments/report/group_names.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "experiments/report/plot.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr double kAxisMargin = 0.06;   // fraction of the values' span, on each side
constexpr double kDodge = 0.004;       // fraction of the span
constexpr std::size_t kMostTics = 16;  // maximum number of tics at values; more would overlap

struct Span {
  double low = 0;
  double high = 0;
  double width() const { return high > low ? high - low : 1; }
};

Span span_of(const NumericFactor& factor) {
  const auto [low, high] = std::minmax_element(factor.values.begin(), factor.values.end());
  return {*low, *high};
}

std::string tics_of(const NumericFactor& factor, const std::vector<Group>& groups) {
  std::vector<std::string> tics;
  tics.reserve(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    tics.push_back(fmt::format("{} {}", script_text(groups[i].values.front()), factor.values[i]));
  }
  return fmt::format("set xtics ({})\n", fmt::join(tics, ", "));
}

}  // namespace

std::vector<std::string> value_heads(const Scenario& scenario, const std::vector<Group>& groups) {
  std::vector<std::string> heads = scenario.experiment().value_columns();
  if (groups.empty() || heads.size() == groups.front().values.size()) return heads;
  heads = {"a", "b"};
  heads.resize(groups.front().values.size());
  return heads;
}

std::string axis_name(const Scenario& scenario) {
  const std::vector<std::string> paths = scenario.experiment().value_columns();
  return paths.empty() ? "matchup" : io::listed(paths);
}

std::vector<std::string> names_of(const Scenario& scenario, const std::vector<Group>& groups) {
  const char* between = scenario.experiment().value_columns().empty() ? " : " : ", ";
  std::vector<std::string> names;
  names.reserve(groups.size());
  for (const Group& group : groups) {
    names.push_back(fmt::format("{}", fmt::join(group.values, between)));
  }
  return names;
}

std::optional<NumericFactor> numeric_factor(const Scenario& scenario,
                                            const std::vector<Group>& groups) {
  const std::vector<Factor> factors = scenario.experiment().varied_settings();
  if (factors.size() != 1 || groups.size() < 2) return std::nullopt;
  const Factor& factor = factors.front();
  const std::optional<std::vector<double>> values = numbers_of(factor);
  if (!values) return std::nullopt;
  return NumericFactor{factor.path, *values};
}

std::string factor_axis(const NumericFactor& factor, const std::vector<Group>& groups) {
  const Span span = span_of(factor);
  double left = span.low - kAxisMargin * span.width();
  double right = span.high + kAxisMargin * span.width();
  if (factor.is_falling()) std::swap(left, right);
  return fmt::format("set xlabel {}\nset xrange [{:.6g}:{:.6g}]\n", script_text(factor.path), left,
                     right) +
         (groups.size() <= kMostTics ? tics_of(factor, groups) : "");
}

double dodge_of(const NumericFactor& factor) { return kDodge * span_of(factor).width(); }

bool has_games(const std::vector<Group>& groups) {
  return std::any_of(groups.begin(), groups.end(),
                     [](const Group& group) { return !group.differences.empty(); });
}

}  // namespace autoref::experiments
