#include "experiments/kinds/situations/distribution_reader.hpp"

#include <fmt/format.h>

#include "game/settings/mapping.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

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

Distribution read_distribution(const game::YamlFile& file, const game::YamlEntry& entry,
                               const std::string& path, const Range& range, std::string_view unit) {
  return DistributionReader(file, entry, path, range, unit).read();
}

}  // namespace autoref::experiments
