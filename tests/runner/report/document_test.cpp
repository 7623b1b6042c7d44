#include "runner/report/document.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const Document kNasty{"a <b> & *c*",
                      {Paragraph{"1. [x](y) `z` | _u_\n# next"},
                       Table{{{"team", "n"}, {"<script>|\"'", "-1"}}, 1}, Verbatim{"```\n<pre>"}}};

TEST(Markdown, TakesNoTextForMarkup) {
  const std::string text = markdown_of(kNasty);
  EXPECT_TRUE(text.starts_with("# a \\<b\\> \\& \\*c\\*\n")) << text;
  EXPECT_TRUE(has(text, "\n1\\. \\[x\\](y) \\`z\\` \\| \\_u\\_ \\# next\n")) << text;
  EXPECT_TRUE(has(text, "\n| \\<script\\>\\|\"' | -1 |\n")) << text;
}

TEST(Markdown, FencesVerbatimTextLongerThanWhatIsInIt) {
  EXPECT_TRUE(has(markdown_of(kNasty), "\n````\n```\n<pre>\n````\n")) << markdown_of(kNasty);
}

TEST(Markdown, PutsNumbersOfTablesToTheRight) {
  EXPECT_TRUE(has(markdown_of(kNasty), "\n| team | n |\n|---|--:|\n"));
}

TEST(Markdown, BeginsNoListInAParagraph) {
  EXPECT_EQ(markdown_of({"t", {Paragraph{"- 12 goals"}}}), "# t\n\n\\- 12 goals\n");
  EXPECT_EQ(markdown_of({"t", {Paragraph{"12 goals"}}}), "# t\n\n12 goals\n");
}

TEST(Html, TakesNoTextForMarkup) {
  const std::string text = html_of(kNasty);
  EXPECT_TRUE(has(text, "<title>a &lt;b&gt; &amp; *c*</title>")) << text;
  EXPECT_TRUE(has(text, "<td class=\"name\">&lt;script&gt;|&quot;&#39;</td><td>-1</td>")) << text;
  EXPECT_TRUE(has(text, "<pre>```\n&lt;pre&gt;</pre>")) << text;
}

TEST(Html, HasTheDrawingsOfFiguresInThePage) {
  const std::string text =
      html_of({"t", {Figure{"plots", "scores", "Goals.", "<?xml?>\n<svg><g/></svg>\n"}}});
  EXPECT_TRUE(has(text, "<figure>\n<svg><g/></svg>\n<figcaption>Goals.")) << text;
  EXPECT_FALSE(has(text, "<?xml"));
  EXPECT_TRUE(has(text, "href=\"plots/scores.gp\""));
}

}  // namespace
}  // namespace autoref::runner
