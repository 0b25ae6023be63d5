#include "web_layering.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mlab/base/testing/source_folder.h"

namespace mlab::repo {
namespace {

const WebArrows kSmall = {{"core", {}}, {"ui", {"core"}}, {"console", {"ui"}}, {"designer", {"ui"}}};

Findings found(std::string path, std::string text) {
  return web_imports({{std::move(path), std::move(text)}}, kSmall);
}

TEST(WebLayering, NoFolderImportsOneThatItMustNotKnow) {
  EXPECT_EQ(web_imports(read_tree(base::source_folder())), Findings{});
}

TEST(WebLayering, TheTableHasNoCircle) {
  EXPECT_EQ(web_circles(web_arrows()), std::set<std::string>{});
}

TEST(WebLayering, EveryFolderOfTheTableIsThere) {
  const Tree tree = read_tree(base::source_folder());
  for (const auto& [folder, known] : web_arrows()) {
    if (folder == "generated") continue;  // made by a build
    const std::string path = "web/" + folder + "/";
    EXPECT_TRUE(std::ranges::any_of(tree, [&](const File& file) { return file.path.starts_with(path); }))
        << folder;
    for (const std::string& next : known)
      EXPECT_TRUE(web_arrows().contains(next)) << folder << " -> " << next;
  }
}

TEST(WebLayering, AnImportUpwardsIsFoundAtItsLine) {
  const Findings findings = found(
      "web/ui/a.ts", "import { b } from \"../core/b.ts\";\nimport {\n  c,\n} from \"../console/c.ts\";\n");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0], (Finding{"web/ui/a.ts", 4, "`ui` must not import `console`"}));
}

TEST(WebLayering, ArrowsMayBeFollowedOverSeveralFolders) {
  EXPECT_EQ(found("web/console/a.ts", "import { b } from \"../core/b.ts\";\n"), Findings{});
}

TEST(WebLayering, EveryWayOfImportingIsSeen) {
  for (const char* line : {
           "import type { Session } from \"../console/session.ts\";",
           "import \"../console/start.css\";",
           "@import '../console/start.css';",
           "const Panel = lazy(() => import(\"../console/panel.tsx\"));",
           "let one: typeof import(\"../console/one.ts\");",
           "export * from '../console/one.ts';",
           "new Worker(new URL(\"../console/worker.ts\", import.meta.url));",
           "import url from \"../console/worker.ts?url\";",
       }) {
    EXPECT_EQ(found("web/designer/a.ts", line).size(), 1U) << line;
  }
  EXPECT_EQ(found("web/designer/a.css", "@import \"../console/start.css\";").size(), 1U);
}

TEST(WebLayering, OtherPathsAreNoImports) {
  EXPECT_EQ(found("web/designer/a.ts", "open(\"./\", \"../console\");\nimport x from \"react/x.ts\";\n"),
            Findings{});
}

TEST(WebLayering, AFolderWithoutAPlaceIsFound) {
  EXPECT_EQ(found("web/misc/a.ts", "").size(), 1U);
  EXPECT_EQ(found("web/vite.config.ts", "import { a } from \"./tools/a.ts\";"), Findings{});
}

TEST(WebLayering, ACircleIsFound) {
  WebArrows arrows = kSmall;
  arrows["core"].insert("console");
  EXPECT_EQ(web_circles(arrows), (std::set<std::string>{"console", "core", "ui"}));
}

}  // namespace
}  // namespace mlab::repo
