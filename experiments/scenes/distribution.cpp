#include "experiments/scenes/distribution.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "game/settings/mapping.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr double kCutOff = 3;  // in standard deviations

// Even if the mean is at an end of the range, half of the draws are inside the range.
constexpr int kMostDraws = 64;

double drawn_normal(double mean, double sd, const Range& range, RandomStream& random) {
  const double low = std::max(range.low, mean - kCutOff * sd);
  const double high = std::min(range.high, mean + kCutOff * sd);
  for (int i = 0; i < kMostDraws; ++i) {
    const double value = mean + sd * random.normal();
    if (value >= low && value <= high) return value;
  }
  return mean;
}

class DistributionReader {
 public:
  DistributionReader(const game::YamlFile& file, const game::YamlEntry& entry, std::string path,
                     const Range& range, std::string_view unit)
      : file_(file), entry_(entry), path_(std::move(path)), range_(range), unit_(unit) {}

  Distribution read() const {
    if (entry_.value.IsSequence()) return uniform();
    if (entry_.value.IsMap()) return normal();
    return {number(file_.scalar(entry_, path_, expected(), true))};
  }

 private:
  std::string expected() const {
    return fmt::format("a number from {} to {} {}, [low, high] or {{ mean: ..., sd: ... }}",
                       range_.low, range_.high, unit_);
  }

  [[noreturn]] void refuse(const std::string& found) const {
    file_.refuse(game::value_location(entry_), path_,
                 fmt::format("expected {}, found {}", expected(), found));
  }

  double number(const std::string& text) const {
    const std::optional<double> number = io::number_in(text);
    if (!number || *number < range_.low || *number > range_.high) refuse(fmt::format("'{}'", text));
    return *number;
  }

  Distribution uniform() const {
    const std::vector<std::string> words = file_.words(entry_, path_);
    if (words.size() != 2) refuse(fmt::format("a list of {}", words.size()));
    const double low = number(words[0]);
    const double high = number(words[1]);
    if (low > high) refuse(fmt::format("[{}], whose ends are reversed", io::listed(words)));
    return Distribution::uniform(low, high);
  }

  Distribution normal() const {
    const game::Mapping from(file_, entry_, path_, {"mean", "sd"});
    for (const char* key : {"mean", "sd"}) {
      if (from.find(key) == nullptr)
        file_.refuse(entry_.location, path_, fmt::format("the key '{}' is missing", key));
    }
    double mean = 0;
    double sd = 0;
    from.number("mean", mean, range_, unit_);
    from.number("sd", sd, {0, range_.high - range_.low}, unit_);
    return Distribution::normal(mean, sd);
  }

  const game::YamlFile& file_;
  const game::YamlEntry& entry_;
  std::string path_;
  Range range_;
  std::string_view unit_;
};

}  // namespace

std::string text_of(const Distribution& distribution) {
  std::string first = io::text_of(distribution.first);
  switch (distribution.kind) {
    case Distribution::Kind::kUniform:
      return fmt::format("[{}, {}]", first, io::text_of(distribution.second));
    case Distribution::Kind::kNormal:
      return fmt::format("{{ mean: {}, sd: {} }}", first, io::text_of(distribution.second));
    case Distribution::Kind::kFixed:
      break;
  }
  return first;
}

double drawn(const Distribution& distribution, const Range& range, RandomStream& random) {
  switch (distribution.kind) {
    case Distribution::Kind::kUniform:
      return distribution.first + (distribution.second - distribution.first) * random.uniform();
    case Distribution::Kind::kNormal:
      return drawn_normal(distribution.first, distribution.second, range, random);
    case Distribution::Kind::kFixed:
      break;
  }
  return distribution.first;
}

Distribution read_distribution(const game::YamlFile& file, const game::YamlEntry& entry,
                               const std::string& path, const Range& range, std::string_view unit) {
  return DistributionReader(file, entry, path, range, unit).read();
}

}  // namespace autoref::experiments
