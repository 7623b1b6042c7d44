#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "experiments/report/plots.hpp"
#include "io/csv.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

constexpr int kVersionsHeight_px = 460;
constexpr std::size_t kMostNamedVersions = 20;  // more names would hide each other
constexpr int kFewestShownDays = 14;            // so that a single version has an axis
constexpr int kDateSteps = 5;                   // between the labels of the axis

// Colours of the lines of versions, in turn; the first two are those of other plots.
constexpr std::array kVersionColours = {kBlue, kVermilion, "#009e73", "#cc79a7", "#e69f00"};

// The versions with a rating, by line and date.
std::vector<VersionRating> drawn_versions(const ExperimentResults& results) {
  std::vector<VersionRating> drawn;
  for (const VersionRating& team : results.versions)
    if (!team.version.date.empty() && team.rating()) drawn.push_back(team);
  return drawn;
}

std::vector<std::string> lines_of_versions(const std::vector<VersionRating>& versions) {
  std::vector<std::string> lines;
  for (const VersionRating& version : versions)
    if (lines.empty() || lines.back() != version.version.line)
      lines.push_back(version.version.line);
  return lines;
}

std::string csv_of_versions(const std::vector<VersionRating>& versions) {
  std::string csv = "row,line,team,date,taken_over,rating,low95,high95,build,offset\n";
  const std::vector<std::string> lines = lines_of_versions(versions);
  for (const VersionRating& version : versions) {
    const auto line = std::find(lines.begin(), lines.end(), version.version.line);
    const auto& [low, high] = bounds_of(version.interval());
    csv += io::csv_line({std::to_string(line - lines.begin() + 1), version.version.line,
                         version.team, version.version.date, version.offset ? "1" : "0",
                         io::number_cell(version.rating()), io::number_cell(low),
                         io::number_cell(high), version.build, io::number_cell(version.offset)}) +
           "\n";
  }
  return csv;
}

struct BuildChange {
  std::string date;   // halfway between the last version of one build and the first of another
  std::string build;  // the later build
};

// Anchors are left out, since every build plays them.
std::vector<BuildChange> build_changes(const std::vector<VersionRating>& versions) {
  std::vector<std::tuple<std::string, std::string>> builds;  // date and build
  for (const VersionRating& version : versions)
    if (!version.is_anchor) builds.emplace_back(version.version.date, version.build);
  std::stable_sort(builds.begin(), builds.end(), [](const auto& one, const auto& other) {
    return std::get<0>(one) < std::get<0>(other);
  });
  std::vector<BuildChange> changes;
  for (std::size_t i = 1; i < builds.size(); ++i) {
    const auto& [former_date, former_build] = builds[i - 1];
    const auto& [date, build] = builds[i];
    if (build == former_build) continue;
    changes.push_back({date_after(former_date, days_between(former_date, date) / 2), build});
  }
  return changes;
}

// The dates of the first and the last version.
struct DateSpan {
  std::string first;
  int days = 0;
};

DateSpan span_of(const std::vector<VersionRating>& versions) {
  std::set<std::string> dates;
  for (const VersionRating& version : versions) dates.insert(version.version.date);
  return {*dates.begin(),
          std::max(days_between(*dates.begin(), *dates.rbegin()), kFewestShownDays)};
}

// A vertical line per change, with a label on the side that has more space.
std::string marks_of(const std::vector<BuildChange>& changes, const DateSpan& span) {
  std::string script;
  for (const BuildChange& change : changes) {
    const bool is_late = 2 * days_between(span.first, change.date) > span.days;
    script += fmt::format(
        "set arrow from '{0}', graph 0 to '{0}', graph 1 nohead lc rgb '#777777' dt 2\n"
        "set label {1} at '{0}', graph 0.03 {2} font ',11' tc rgb '#555555'\n",
        change.date,
        script_text(shortened(fmt::format("then build {}", change.build), kLongestLabel)),
        is_late ? "right offset char -0.6,0" : "left offset char 0.6,0");
  }
  return script;
}

// The axis with some space on either side, so no point is at the edge.
std::string date_axis(const DateSpan& span) {
  std::vector<std::string> tics;
  for (int i = 0; i <= kDateSteps; ++i)
    tics.push_back(fmt::format("'{0}' '{0}'", date_after(span.first, span.days * i / kDateSteps)));
  return fmt::format(
      "set xdata time\n"
      "set timefmt '%Y-%m-%d'\n"
      "set xrange ['{}':'{}']\n"
      "set xtics ({})\n",
      date_after(span.first, -std::max(1, span.days / 12)),
      date_after(span.first, span.days + std::max(1, span.days / 8)), fmt::join(tics, ", "));
}

// The curve, bars and points of one line of versions.
std::string curve_of_line(std::size_t row, const std::string& title) {
  return fmt::format(
      "data using 'date':(of({0}, 'rating')) with lines lw 1.5 lc rgb '{1}' notitle, \\\n"
      "     data using 'date':(of({0}, 'rating')):'low95':'high95' with yerrorbars pt -1 lw 1.5 lc "
      "rgb '{1}' notitle, \\\n"
      "     data using 'date':(of({0}, 'rating')) with points pt 7 ps 1.1 lc rgb '{1}' {2}, \\\n"
      "     data using 'date':(column('taken_over') == 1 ? of({0}, 'rating') : NaN) with points pt "
      "7 "
      "ps 0.65 lc rgb 'white' notitle",
      row, kVersionColours[(row - 1) % kVersionColours.size()],
      title.empty() ? "notitle" : "title " + script_text(shortened(title, kLongestLabel)));
}

std::string script_of_versions(const std::vector<VersionRating>& versions) {
  const std::vector<std::string> lines = lines_of_versions(versions);
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < lines.size(); ++i) curves.push_back(curve_of_line(i + 1, lines[i]));
  if (versions.size() <= kMostNamedVersions)
    curves.emplace_back(
        "data using 'date':'rating':(stringcolumn('team')) with labels left offset char 0.8,0.6 "
        "font ',11' notitle");
  return script_head("versions", kVersionsHeight_px) + date_axis(span_of(versions)) +
         marks_of(build_changes(versions), span_of(versions)) +
         fmt::format(
             "set ylabel 'rating in goals per game, 95 % interval'\n"
             "set offsets 0, 0, graph 0.06, graph 0.06\n"
             "set key top left reverse Left\n"
             "of(row, name) = column('row') == row ? column(name) : NaN\n"
             "plot {}\n",
             fmt::join(curves, ", \\\n     "));
}

}  // namespace

std::optional<Plot> versions_plot(const ExperimentResults& results) {
  const std::vector<VersionRating> versions = drawn_versions(results);
  if (versions.empty()) return std::nullopt;
  return Plot{
      "versions",
      "Rating of each version of a team over its date, in goals per game, with Student's 95 % "
      "interval over pair numbers. Open circles: not played again, the rating that an earlier "
      "build of AutoRef found plus the offset between the builds. A vertical line marks where the "
      "build that played the versions changes.",
      csv_of_versions(versions), script_of_versions(versions)};
}

}  // namespace autoref::experiments
