#include "experiments/kinds/weakness/weakness_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// The optimiser's step as a fraction of a range.
constexpr double kSearchStep = 0.25;
constexpr double kRoundedTo = 1e3;  // steps per unit

double to_thousandths(double value) { return std::round(value * kRoundedTo) / kRoundedTo; }

struct SearchedValue {
  std::string path;
  Distribution* place;
};

void add_if_range(const std::string& path, Distribution& place, std::vector<SearchedValue>& all) {
  if (place.kind == Distribution::Kind::kUniform) all.push_back({path, &place});
}

template <typename Numbers>
void add_ranges(const std::string& branch, const Numbers& numbers,
                std::vector<SearchedValue>& all) {
  for (const auto& number : numbers)
    add_if_range(fmt::format("{}.{}", branch, number.key), *number.place, all);
}

// The values given as ranges, in a fixed order.
std::vector<SearchedValue> searched_values(SituationSetup& family, const Field& field) {
  std::vector<SearchedValue> all;
  add_ranges("ball", numbers_of(family.ball, field), all);
  for (auto* const robots : {&family.attackers, &family.defenders}) {
    for (DrawnRobot& robot : *robots) {
      const std::string branch =
          path_of(RobotOfSituation{robots == &family.attackers, robot.number});
      add_ranges(branch, numbers_of(robot, field), all);
      if (robot.heading_deg) add_if_range(branch + ".heading_deg", *robot.heading_deg, all);
    }
  }
  return all;
}

}  // namespace

std::vector<std::string> searched_paths(const SituationSetup& family, const Field& field) {
  SituationSetup copy = family;
  std::vector<std::string> paths;
  for (SearchedValue& value : searched_values(copy, field)) paths.push_back(std::move(value.path));
  return paths;
}

std::unique_ptr<Optimiser> optimiser_of(const SituationSetup& family, const Field& field,
                                        int iterations, std::uint64_t seed) {
  std::vector<Axis> axes(searched_paths(family, field).size());
  RandomStream random(mix_bits(seed));
  for (Axis& axis : axes) {
    axis.high = 1 / kSearchStep;
    axis.start = axis.high * random.uniform();
  }
  return make_optimiser({Method::kCmaEs, iterations, 0, seed}, axes);
}

SituationSetup situation_at(const SituationSetup& family, const Field& field, const Point& point,
                            double spread) {
  SituationSetup situation = family;
  Eigen::Index axis = 0;
  for (const SearchedValue& value : searched_values(situation, field)) {
    Distribution& range = *value.place;
    const double width = range.second - range.first;
    const double centre = range.first + width * kSearchStep * point[axis++];
    const double low = std::max(range.first, to_thousandths(centre - spread * width / 2));
    const double high = std::min(range.second, to_thousandths(centre + spread * width / 2));
    range =
        low < high ? Distribution::uniform(low, high) : Distribution(std::min(low, range.second));
  }
  return situation;
}

std::string path_of(const RobotOfSituation& robot) {
  return fmt::format("{}.{}", robot.is_attacker ? "attackers" : "defenders", robot.number);
}

std::vector<RobotOfSituation> robots_of(const SituationSetup& situation) {
  std::vector<RobotOfSituation> robots;
  for (const DrawnRobot& robot : situation.attackers) robots.push_back({true, robot.number});
  for (const DrawnRobot& robot : situation.defenders) robots.push_back({false, robot.number});
  return robots;
}

SituationSetup situation_without(SituationSetup situation, const RobotOfSituation& robot) {
  std::erase_if(robot.is_attacker ? situation.attackers : situation.defenders,
                [&robot](const DrawnRobot& one) { return one.number == robot.number; });
  return situation;
}

SituationSetup situation_without(SituationSetup situation,
                                 const std::vector<RobotOfSituation>& robots) {
  for (const RobotOfSituation& robot : robots)
    situation = situation_without(std::move(situation), robot);
  return situation;
}

}  // namespace autoref::experiments
