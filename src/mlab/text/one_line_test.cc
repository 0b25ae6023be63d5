#include "mlab/text/one_line.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace mlab::text {
namespace {

SourcePtr mission() {
  return std::make_shared<const Source>("/project/anna/demo.mdl", "x\n  2. MOVETO ATK-AP9\n");
}

TEST(OneLine, SaysFileLineColumnWhatIsThereAndWhatIsExpected) {
  Diagnostics sink;
  sink.warning("odd", {mission(), {0, 1}}, "this is odd");
  Diagnostic& d =
      sink.error("unknown-control-measure", {mission(), {14, 21}}, "unknown control measure `ATK-AP9`");
  d.label = "not in overlay `democ.odl`";
  d.hints = {"did you mean `ATK-AP1`?"};
  EXPECT_EQ(first_error(sink),
            "demo.mdl:2:13: unknown control measure `ATK-AP9`: not in overlay `democ.odl`; did you mean "
            "`ATK-AP1`?");
  sink.error("another", {}, "and this");
  EXPECT_TRUE(first_error(sink).ends_with("`ATK-AP1`? (and 1 more error)")) << first_error(sink);
  sink.error("another", {}, "and that");
  EXPECT_TRUE(first_error(sink).ends_with("(and 2 more errors)")) << first_error(sink);
}

TEST(OneLine, IsOneLineOfWhateverAFileHolds) {
  const auto source = std::make_shared<const Source>("a\x1b[2J.mdl", "use\n");
  Diagnostic d;
  d.message = "cannot read `\x1b[31m\n`";
  d.place = {source, {0, 3}};
  d.label = "\x9b";
  for (const char one : one_line(d)) EXPECT_TRUE(one >= ' ' && one < 0x7f) << one_line(d);
}

TEST(OneLine, OfNoErrorIsEmpty) {
  Diagnostics sink;
  sink.warning("odd", {}, "this is odd");
  EXPECT_EQ(first_error(sink), "");
}

}  // namespace
}  // namespace mlab::text
