#include "mlab/lang/cnl/declarations.h"

#include <memory>

#include <gtest/gtest.h>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/lang/cnl/signatures.h"
#include "mlab/lang/cnl/types.h"

namespace mlab::cnl {
namespace {

Tree parsed(const std::string& name, const std::string& text, text::Diagnostics& sink) {
  Tree out = parse(std::make_shared<const text::Source>(name, text), sink);
  check_declarations(out, sink);
  return out;
}

constexpr const char* kText = R"(init
#include "secret.h"
iend

/// Speeds up.
procedure double [m/s] Hasten
  alias HASTE (v = pace)
with
  double [m/s] pace = 2 in 0 .. 10;  ///< to begin with
once
  int first = 1;
header
  double secret = 4711;
body
  output = pace + secret;
pend
)";

TEST(Declarations, SayAllOfAProcedureButWhatItDoes) {
  text::Diagnostics sink;
  const Tree tree = parsed("somewhere/private/fast.cnl", kText, sink);
  ASSERT_FALSE(sink.has_errors()) << text::render(sink);
  const std::vector<Declarations> all = declarations_of(tree);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].file, "fast.cnl");
  EXPECT_EQ(all[0].text.find("secret"), std::string::npos);
  EXPECT_EQ(all[0].text.find("first"), std::string::npos);
  const Tree again = parsed(all[0].file, all[0].text, sink);
  ASSERT_FALSE(sink.has_errors()) << text::render(sink);
  const Signatures signatures(again, [](std::string_view) { return nullptr; });
  ASSERT_EQ(signatures.behaviors().size(), 1U);
  const flow::Behavior& behavior = *signatures.behaviors()[0];
  EXPECT_EQ(behavior.name, "Hasten");
  EXPECT_EQ(behavior.help, "Speeds up.");
  EXPECT_EQ(behavior.file, "fast.cnl:6") << "where its author wrote it";
  EXPECT_EQ(behavior.aliases[0].name, "HASTE");
  EXPECT_EQ(behavior.inputs[0].help, "to begin with");
}

TEST(Declarations, OfIncludedFilesComeFirst) {
  text::Diagnostics sink;
  Tree tree = parsed("robot.cnl", "#include \"parts/fast.cnl\"\n", sink);
  std::get<Include>(tree.items.at(0)).tree =
      std::make_shared<const Tree>(parsed("parts/fast.cnl", kText, sink));
  const std::vector<Declarations> all = declarations_of(tree);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].file, "fast.cnl");
  EXPECT_EQ(all[1].file, "robot.cnl");
}

}  // namespace
}  // namespace mlab::cnl
