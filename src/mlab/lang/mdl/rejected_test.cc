#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"

namespace mlab::mdl {
namespace {

// What authors plausibly write and the language does not have. `^` stands before the place that is reported.
struct Rejected {
  std::string text;
  std::string kind;
};

std::string marked(const std::string& text, std::size_t& at) {
  at = text.find('^');
  return text.substr(0, at) + text.substr(at + 1);
}

// One error, of this kind, at the mark.
void expect_one_error(const text::Diagnostics& sink, const Rejected& rejected, std::size_t at) {
  ASSERT_EQ(sink.error_count(), 1U) << rejected.text << "\n" << text::render(sink);
  for (const text::Diagnostic& item : sink.items()) {
    if (item.severity != text::Severity::kError) continue;
    EXPECT_EQ(item.kind, rejected.kind) << text::render(item);
    EXPECT_EQ(item.place.span.begin, at) << rejected.text << "\n" << text::render(item);
  }
}

void expect_rejected(const std::string& before, const std::vector<Rejected>& table,
                     const std::string& after) {
  for (const Rejected& rejected : table) {
    std::size_t at = 0;
    const std::string text = marked(before + rejected.text + after, at);
    text::Diagnostics sink;
    EXPECT_EQ(check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink), nullptr);
    expect_one_error(sink, rejected, at);
  }
}

TEST(MdlRejected, StepsGetOneErrorAtTheRightPlace) {
  expect_rejected("SP a 1 1\nUNIT <u> ROBOT\nCOMMAND LIST:\n",
                  {{"0. UNIT u START a ^5", "one-offset"},
                   {"0. UNIT u START a ^+5 10", "time-as-number"},
                   {"0. UNIT u START a 0 ^20.", "label-as-number"},
                   {"0. UNIT u MOVETO a ON-COMPLETION MSG m ^FREEZE", "freeze"},
                   {"0. UNIT u MOVETO a PHASE-LINE a ^WAIT", "wait-without-acknowledge"},
                   {"0. UNIT u MOVETO a PHASE-LINE a ^12-25-95", "date-without-time"},
                   {"0. UNIT u OCCUPY a ^TECHNIQUE TRAVELING", "clause-not-allowed"},
                   {"0. UNIT u OCCUPY a ^SPEED 3", "clause-not-allowed"},
                   {"0. UNIT u TELEOPERATE a ^TECHNIQUE TRAVELING", "clause-not-allowed"},
                   {"0. UNIT u START a ^UNTIL TIMEOUT 3", "clause-not-allowed"},
                   {"0. SET ^ROBOT-LENGTH 2", "not-in-steps"},
                   {"0. SET ^SEED 2", "not-in-steps"},
                   {"0. UNIT u MOVETO ^LINE", "unknown-control-measure"},
                   {"0. UNIT u MOVETO ^3d", "unquoted-name"},
                   {"0. UNIT u MOVETO ^97", "one-coordinate"},
                   {"0. UNIT ^<u> MOVETO a", "unit-in-brackets"},
                   {"^0.UNIT u MOVETO a", "label-without-blank"},
                   {"0. ^PAUSE", "unknown-statement"},
                   {"0. ^NEW-ROBOT r robot", "not-in-steps"}},
                  "\n1. UNIT u STOP\n");
}

TEST(MdlRejected, PreamblesGetOneErrorAtTheRightPlace) {
  expect_rejected("",
                  {{"^ORIGIN 5 5", "not-in-missions"},
                   {"^SITE \"here\"", "not-in-missions"},
                   {"^PP a 1 1 5", "not-in-missions"},
                   {"^PP a 1 1 5 6", "not-in-missions"},
                   {"^GAP a 1 1 5 6 7 8", "not-in-missions"},
                   {"LOAD-MAP ^x.mapinfo", "unquoted-name"},
                   {"NEW-ROBOT r ^./r", "unquoted-name"},
                   {"MISSION NAME Foo ^Bar", "unknown-statement"},
                   {"UNIT ^scouts ROBOT", "unit-without-brackets"},
                   {"UNIT <x> (ROBOT) ^ROBOT", "mixed-group"},
                   {"UNIT <x> ROBOT ^(<y> ROBOT)", "mixed-group"},
                   {"UNIT <x> (ROBOT ^(ROBOT))", "mixed-group"},
                   {"NEW-ROBOT r x blue \"\" ^fifth", "too-many-words"},
                   {"NEW-ROBOT r x ^()", "empty-parameter-list"},
                   {"NEW-ROBOT r x (a = 1^,)", "trailing-comma"},
                   {"OVERLAY ^97", "unexpected-token"},
                   {"MISSION NAME^\nSET SHOW-TRAILS", "unexpected-token"}},
                  "\nSP a 1 1\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START a\n");
}

TEST(MdlRejected, HeadersGetOneErrorAtTheRightPlace) {
  expect_rejected("SP a 1 1\nUNIT <u> ROBOT\n",
                  {{"^COMMAND LIST :\n", "command-list-spelling"},
                   {"^COMMAND LIST\n", "command-list-spelling"},
                   {"^COMMAND-LIST\n", "command-list-spelling"},
                   {"^0. UNIT u STOP\n", "missing-command-list"}},
                  "0. UNIT u START a\n");
}

TEST(MdlRejected, TypedCommandsGetOneErrorAtTheRightPlace) {
  text::Diagnostics none;
  const auto mission =
      check_mission(std::make_shared<const text::Source>(
                        "test.mdl", "SP a 1 1\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START a\n"),
                    "", none);
  ASSERT_NE(mission, nullptr);
  for (const Rejected& rejected : std::vector<Rejected>{{"^NEW-ROBOT r \"x\"", "not-typed"},
                                                        {"^OVERLAY x.odl", "not-typed"},
                                                        {"^3. UNIT u STOP", "not-typed"},
                                                        {"UNIT u STOP AND ^3. UNIT u STOP", "not-typed"},
                                                        {"UNIT ^v STOP", "unknown-unit"},
                                                        {"UNIT u STOP ^UNIT u STOP", "unexpected-token"}}) {
    std::size_t at = 0;
    const std::string line = marked(rejected.text, at);
    text::Diagnostics sink;
    EXPECT_FALSE(parse_immediate(line, *mission, sink));
    expect_one_error(sink, rejected, at);
  }
}

}  // namespace
}  // namespace mlab::mdl
