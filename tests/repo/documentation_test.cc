#include "documentation.h"

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::repo {
namespace {

TEST(Documentation, EveryLinkLeadsSomewhere) {
  EXPECT_EQ(dead_links(read_tree(base::source_folder())), Findings{});
}

TEST(Documentation, ALinkToAMissingFileIsFoundAtItsLine) {
  const Findings findings = dead_links({{"docs/a.md", "text\n[b](b.md) and [c](../c.md)\n"}, {"c.md", ""}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0], (Finding{"docs/a.md", 2, "there is no `docs/b.md`"}));
}

TEST(Documentation, ALinkToAMissingHeadingIsFound) {
  const Tree tree = {{"a.md", "# The two commands\n[x](#the-two-commands)\n[y](#the-third)\n"}};
  ASSERT_EQ(dead_links(tree).size(), 1U);
  EXPECT_EQ(dead_links(tree)[0].line, 3U);
}

TEST(Documentation, CodeAndOtherSitesAreNoLinksOfOurs) {
  const Tree tree = {{"a.md", "`[x](y)` [site](https://example.org)\n```\n[z](nowhere)\n```\n"}};
  EXPECT_EQ(dead_links(tree), Findings{});
}

TEST(Documentation, EveryExampleStandsInAFile) {
  EXPECT_EQ(stale_examples(read_tree(base::source_folder())), Findings{});
}

TEST(Documentation, AnExampleMayBeAPieceOfItsFile) {
  const Tree tree = {{"a.md", "<!-- from x.cnl -->\n```cnl\nbody\n  output = 1;\n```\n"},
                     {"x.cnl", "procedure\n  body\n    output = 1;\npend\n"}};
  EXPECT_EQ(stale_examples(tree), Findings{});
}

TEST(Documentation, AnExampleThatDiffersFromItsFileIsFound) {
  const Tree tree = {
      {"a.md", "<!-- from x.cnl -->\n```cnl\noutput = 2;\n```\n<!-- from y.cnl -->\n```\nz\n```\n"},
      {"x.cnl", "output = 1;\n"}};
  const Findings findings = stale_examples(tree);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].message, "the example does not stand in `x.cnl` as it is shown");
  EXPECT_EQ(findings[1].message, "there is no `y.cnl`");
}

}  // namespace
}  // namespace mlab::repo
