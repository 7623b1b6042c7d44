#include "experiments/report/document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/report/bracket_drawing.hpp"
#include "tests/support/has_part.hpp"

namespace autoref::experiments {
namespace {

const Document kNasty{"a <b> & *c*",
                      {Paragraph{"1. [x](y) `z` | _u_\n# next"},
                       Table{{{"team", "n"}, {"<script>|\"'", "-1"}}, 1}, Verbatim{"```\n<pre>"}}};

TEST(Markdown, EscapesMarkup) {
  const std::string text = markdown_of(kNasty);
  EXPECT_TRUE(text.starts_with("# a \\<b\\> \\& \\*c\\*\n")) << text;
  EXPECT_TRUE(has(text, "\n1\\. \\[x\\](y) \\`z\\` \\| \\_u\\_ \\# next\n")) << text;
  EXPECT_TRUE(has(text, "\n| \\<script\\>\\|\"' | -1 |\n")) << text;
}

TEST(Markdown, UsesALongerFenceThanAnyInVerbatimText) {
  EXPECT_TRUE(has(markdown_of(kNasty), "\n````\n```\n<pre>\n````\n")) << markdown_of(kNasty);
}

TEST(Markdown, AlignsNumbersInTablesRight) {
  EXPECT_TRUE(has(markdown_of(kNasty), "\n| team | n |\n|---|--:|\n"));
}

TEST(Markdown, StartsNoListInAParagraph) {
  EXPECT_EQ(markdown_of({"t", {Paragraph{"- 12 goals"}}}), "# t\n\n\\- 12 goals\n");
  EXPECT_EQ(markdown_of({"t", {Paragraph{"12 goals"}}}), "# t\n\n12 goals\n");
}

TEST(Html, EscapesMarkup) {
  const std::string text = html_of(kNasty);
  EXPECT_TRUE(has(text, "<title>a &lt;b&gt; &amp; *c*</title>")) << text;
  EXPECT_TRUE(has(text, "<td class=\"name\">&lt;script&gt;|&quot;&#39;</td><td>-1</td>")) << text;
  EXPECT_TRUE(has(text, ">```\n&lt;pre&gt;</pre>")) << text;
}

// The page may be sent without the other files, so a link to one of them would be dead.
TEST(Html, NamesFilesInsteadOfLinkingToThem) {
  const std::string text = html_of({"t",
                                    {Link{"effective.yaml", "Every setting"},
                                     Figure{"plots", "scores", "Goals.", "<svg><g/></svg>"}}});
  EXPECT_FALSE(has(text, "href"));
  EXPECT_TRUE(has(text, "Every setting: <code>effective.yaml</code>")) << text;
}

TEST(Html, LetsLongWordsBreak) {
  const std::string build(200, 'x');
  const std::string text = html_of({"t", {Table{{{"experiment", ""}, {"build", build}}, 2}}});
  EXPECT_TRUE(has(text, build));
  EXPECT_TRUE(has(text, "class=\"wide words\""));
  EXPECT_TRUE(has(text, ".words .name{white-space:normal;overflow-wrap:anywhere}"));
}

// A printed page cannot scroll, so the font shrinks with the number of characters.
TEST(Html, GivesTheWidthOfTablesAndLinesInCharacters) {
  EXPECT_TRUE(
      has(html_of({"t", {Verbatim{"12345\n\xc2\xb1 1\n"}}}), "<pre style=\"--letters:5\">"));
  EXPECT_TRUE(has(html_of({"t", {Table{{{"team", "n"}, {"x", "-1"}}, 1}}}),
                  "<table style=\"--letters:12\">"));
}

// Three teams: the best seed has a bye in the semi-finals.
const Document kCup{
    "A cup",
    {CupBracket{{{"semi-final 1",
                  BracketPlace{2, 1},
                  {{{"b_<i>", true, "1 (4)", true}, {"c_*", true, "1 (2)", false}}},
                  "shoot-out"},
                 {"final",
                  BracketPlace{1, 0},
                  {{{"a", true, "", false}, {"winner of semi-final 1", false, "", false}}},
                  ""}}}}};

TEST(Html, DrawsABracketWithTheTeamThatGoesOnInBold) {
  const std::string text = html_of(kCup);
  EXPECT_TRUE(has(text, "--rounds:2;--lines:2")) << text;
  EXPECT_TRUE(has(text, "<div class=\"tie leads-up\" style=\"grid-area:3/1/span 1\">")) << text;
  EXPECT_TRUE(has(text, "<div class=\"tie is-fed\" style=\"grid-area:2/2/span 2\">")) << text;
  EXPECT_TRUE(has(text, "<strong>b_&lt;i&gt;</strong><strong>1 (4)</strong>")) << text;
  EXPECT_TRUE(has(text, "<span>c_*</span><span>1 (2)</span>")) << text;
  EXPECT_TRUE(has(text, "<p class=\"tie-name\">shoot-out</p>")) << text;
  EXPECT_TRUE(has(text, ".bracket {")) << text;
  EXPECT_FALSE(has(html_of(kNasty), ".bracket {"));
}

TEST(Markdown, ShowsABracketWithAColumnPerRound) {
  const std::string text = markdown_of(kCup);
  EXPECT_TRUE(has(text,
                  "\n| semi-finals | final |\n|---|---|\n"
                  "|  | a : winner of semi-final 1 |\n"
                  "| **b\\_\\<i\\>** 1 (4) : 1 (2) c\\_\\*, shoot-out |  |\n"))
      << text;
}

// A cup of 128 teams, of which only the ties of the last rounds are laid out.
TEST(Bracket, OfALargeCupBeginsWithARoundOf32Ties) {
  CupBracket cup;
  for (std::size_t ties = 64; ties >= 1; ties /= 2) {
    for (std::size_t i = 0; i < ties; ++i)
      cup.ties.push_back({fmt::format("tie {} of {}", i, ties),
                          BracketPlace{ties, i},
                          {{{"a", false, "", false}, {"b", false, "", false}}},
                          ""});
  }
  EXPECT_EQ(rounds_of(cup), (std::vector<std::size_t>{32, 16, 8, 4, 2, 1}));
  const std::string html = html_of({"t", {cup}});
  EXPECT_FALSE(has(html, "tie 63 of 64"));
  EXPECT_TRUE(has(html, "tie 31 of 32"));
  const std::string markdown = markdown_of({"t", {cup}});
  EXPECT_EQ(std::count(markdown.begin(), markdown.end(), ':'), 63);
}

TEST(Html, EmbedsTheDrawingsOfFigures) {
  const std::string text =
      html_of({"t", {Figure{"plots", "scores", "Goals.", "<?xml?>\n<svg><g/></svg>\n"}}});
  EXPECT_TRUE(has(text, "<svg><g/></svg>\n<figcaption>Goals.")) << text;
  EXPECT_FALSE(has(text, "<?xml"));
  EXPECT_TRUE(has(text, "script: <code>plots/scores.gp</code>"));
}

}  // namespace
}  // namespace autoref::experiments
