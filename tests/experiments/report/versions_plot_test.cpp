// The plot of ratings over time.
#include <gtest/gtest.h>

#include "experiments/report/plots.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

VersionRating version_on(const std::string& date, const std::string& team, const std::string& build,
                         std::optional<double> offset = {}) {
  VersionRating rating;
  rating.team = team;
  rating.version.date = date;
  rating.build = build;
  rating.offset = offset;
  rating.by_pair = {{1, 1}, {2, 2}};
  return rating;
}

ExperimentResults rated_over_time() {
  ExperimentResults results;
  results.versions = {version_on("2026-01-01", "v1", "1.0", 0.5),
                      version_on("2026-02-01", "v2", "1.0", 0.5),
                      version_on("2026-03-01", "v3", "2.0")};
  return results;
}

TEST(VersionsPlot, HasARowPerVersion) {
  const std::string csv = versions_plot(rated_over_time()).value().csv;
  EXPECT_TRUE(
      csv.starts_with("row,line,team,date,taken_over,rating,low95,high95,build,offset\n"
                      "1,,v1,2026-01-01,1,1.5000,-4.8531,7.8531,1.0,0.5000\n"))
      << csv;
  EXPECT_TRUE(has(csv, "\n1,,v3,2026-03-01,0,1.5000,-4.8531,7.8531,2.0,\n")) << csv;
}

TEST(VersionsPlot, MarksWhereTheBuildChanges) {
  const std::string script = versions_plot(rated_over_time()).value().script;
  EXPECT_TRUE(has(script, "set arrow from '2026-02-15', graph 0")) << script;
  EXPECT_TRUE(has(script, "2.0")) << script;
  EXPECT_EQ(script.find("set arrow"), script.rfind("set arrow"));
}

TEST(VersionsPlot, HasNoMarkForAnAnchor) {
  ExperimentResults results = rated_over_time();
  results.versions[0].build = "2.0";
  results.versions[0].is_anchor = true;
  const std::string script = versions_plot(results).value().script;
  EXPECT_EQ(script.find("set arrow"), script.rfind("set arrow"));
}

TEST(VersionsPlot, NeedsAVersionWithARating) {
  ExperimentResults results = rated_over_time();
  for (VersionRating& version : results.versions) version.by_pair.clear();
  EXPECT_FALSE(versions_plot(results));
  results.versions = {version_on("", "anchor", "1.0")};
  EXPECT_FALSE(versions_plot(results));
}

TEST(VersionsPlot, IsDrawn) {
  const Drawing drawing = draw(versions_plot(rated_over_time()).value());
  if (drawing.is_missing)
    GTEST_SKIP() << "skipped: missing Debian packages: gnuplot-nox (scripts/setup --tests "
                    "installs it)";
  EXPECT_EQ(drawing.trouble, "");
}

}  // namespace
}  // namespace autoref::experiments
