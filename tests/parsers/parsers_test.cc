// Every parser is linear: whatever is repeated, four times as much takes about four times as long. One input
// for each token that may stand in a language, in one line and in many.

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl_historic/parser.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/robot/program/network_file.h"

namespace mlab {
namespace {

using Parse = std::function<void(const text::SourcePtr&, text::Diagnostics&)>;

// Memory that was freed is kept: what the kernel takes to give it anew is no work of a parser, and on some
// machines costs more than parsing does.
const bool kKeepsMemory = mallopt(M_MMAP_MAX, 0) == 1 && mallopt(M_TRIM_THRESHOLD, -1) == 1;

// Of this thread, so that whoever else runs on the machine does not count.
double cpu_seconds_of(const Parse& parse, const std::string& text) {
  const auto source = std::make_shared<const text::Source>("repeated", text);
  const auto now = [] {
    std::timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
  };
  const double began = now();
  text::Diagnostics sink;
  parse(source, sink);
  return now() - began;
}

std::string repeated(const std::string& piece, std::size_t bytes) {
  std::string out;
  while (out.size() < bytes) out += piece;
  return out;
}

constexpr std::size_t kSmall = 25'000;
constexpr std::size_t kLarge = 100'000;
constexpr double kFastEnough = 0.08;  // [s]: no need to look closer; a quadratic one takes ten times that
constexpr double kLinear = 9.0;       // a quadratic one takes sixteen times as long

/// Whether four times as much takes about four times as long. Where a text leaves a cache everything takes
/// more, but only there: what is not linear does so at every size. It is looked at in up to four sizes.
/// @param seconds  for a text of so many bytes, or things
bool is_linear(std::size_t small, std::size_t large, const std::function<double(std::size_t)>& seconds) {
  const auto grows = [&](std::size_t times) {
    double least = 1e9;
    double most = 1e9;
    for (int i = 0; i < 3; ++i) {  // the best of three, for a processor that is shared
      least = std::min(least, seconds(small * times));
      most = std::min(most, seconds(large * times));
    }
    return most >= kLinear * least;
  };
  return !grows(1) || !grows(4) || !grows(8) || !grows(16);
}

void expect_linear(const char* language, const Parse& parse, const std::vector<std::string>& openings,
                   const std::vector<std::string>& tokens) {
  for (const std::string& opening : openings) {
    for (const std::string& token : tokens) {
      for (const char* behind : {"", "\n"}) {
        const std::string piece = token + behind;
        if (cpu_seconds_of(parse, opening + repeated(piece, kLarge)) < kFastEnough) continue;
        EXPECT_TRUE(is_linear(
            kSmall, kLarge,
            [&](std::size_t bytes) { return cpu_seconds_of(parse, opening + repeated(piece, bytes)); }))
            << language << ": `" << opening << "` and then `" << piece << "`";
      }
    }
  }
}

// What all of them are made of.
std::vector<std::string> with_common(std::vector<std::string> own) {
  for (const char* one :
       {"-",  "--", "+",  "*",   "/",  "//",       "/*",   "*/", "#",   "!",     "?",   "%",  "&",
        "|",  "^",  "~",  "@",   "$",  "\\",       "`",    "'",  "\"",  "\"a\"", "(",   ")",  "[",
        "]",  "{",  "}",  "<",   ">",  "()",       "[]",   "{}", "<>",  "(a",    "{a",  "[a", ",",
        ";",  ":",  ".",  "..",  "=",  "==",       "->",   "_",  "a",   "a.",    "a b", "1",  "-1",
        "1.", ".5", "1e", "1e5", "\t", "\xc3\xa9", "\xff", "a;", "a{}", "a()",   "a=1", "a,"})
    own.emplace_back(one);
  return own;
}

TEST(Parsers, OfConfigurationsAreLinear) {
  const Parse parse = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    cdl::parse(source, sink);
  };
  expect_linear("CDL", parse, {"", "robot R { movement = ", "assemblage A() { sequence { "},
                with_common({"use \"a\";",
                             "architecture A;",
                             "assemblage",
                             "assemblage A();",
                             "binding b();",
                             "class C {}",
                             "robot R {}",
                             "operator O {}",
                             "society S: R;",
                             "layout {}",
                             "let x = 1;",
                             "cooperate {",
                             "compete by",
                             "sequence {",
                             "select by",
                             "when a goto A;",
                             "start A: B();",
                             "and",
                             "or",
                             "not",
                             "as",
                             "active",
                             "delay(",
                             "/// help",
                             "///< help",
                             "note 1 2 \"a\";",
                             "team of 2 R"}));
  const Parse formula = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    cdl::parse_formula(source, sink);
  };
  expect_linear("G", formula, {"", "{"},
                with_common({"{<p1 m1>}", "<p1 m1>", "[+1", "(#1 p1", "'*1", "'/1", "p1"}));
}

TEST(Parsers, OfProceduresAreLinear) {
  const Parse parse = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    cnl::parse(source, sink);
  };
  expect_linear("CNL", parse, {"", "procedure Vector P with double a; header body ", "node n is "},
                with_common({"procedure",    "procedure void P header body pend",
                             "pend",         "header",
                             "body",         "once",
                             "with",         "alias A",
                             "init {",       "init }",
                             "node n is P;", "network N",
                             "double a;",    "list",
                             "in 1 .. 2",    "/// help",
                             "pure",         "sequence",
                             "state",        "public"}));
}

// Of networks the program that comes out, too.
TEST(Parsers, OfNetworksWithManyStatesAndCasesAreLinear) {
  const Parse build = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    robot::check_network(source, {}, sink);
    EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  };
  constexpr const char* kOthers =
      "nend\nnode t is IsHalted with nend\nnode task is GetActiveTask with nend\nnode rest is Stand with "
      "nend\n"
      "node w is Drive with v = m; base_velocity = 1; max_velocity = 1; nend\n";
  const auto states = [&](int count) {
    std::string text = "sequence m of Vector with\nstart state s0 is rest; when t goto s1;\n";
    for (int i = 1; i < count; ++i) text += fmt::format("state s{} is rest; when t goto s{};\n", i, i + 1);
    return fmt::format("{}final state s{} is rest;\n{}", text, count, kOthers);
  };
  const auto cases = [&](int count) {
    std::string text = "select m of Vector by task with\n";
    for (int i = 0; i < count; ++i) text += fmt::format("case {}: rest;\n", i);
    return text + "otherwise: rest;\n" + kOthers;
  };
  const auto values = [&](int count) {
    std::string text = "select m of Vector by task with\ncase 0";
    for (int i = 1; i < count; ++i) text += fmt::format(", {}", i);
    return text + ": rest;\notherwise: rest;\n" + kOthers;
  };
  const std::vector<std::function<std::string(int)>> texts{states, cases, values};
  for (const auto& text : texts) {
    EXPECT_TRUE(is_linear(10'000, 40'000, [&](std::size_t count) {
      return cpu_seconds_of(build, text(static_cast<int>(count)));
    })) << text(3);
  }
}

TEST(Parsers, OfMissionsAreLinear) {
  const Parse parse = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    mdl::parse(source, sink);
  };
  expect_linear("MDL", parse, {"", "COMMAND LIST:\n0. ", "UNIT <u> "},
                with_common({"UNIT <u> ROBOT", "UNIT u MOVETO a", "NEW-ROBOT a b", "OVERLAY a.odl",
                             "SET SHOW-TRAILS ON", "COMMAND LIST:", "0.", "1. UNIT u STOP", "AND",
                             "MISSION NAME a", "OBSTACLE 1 1 1", "SP a 1 1", "PHASE-LINE a",
                             "FORMATION Wedge", "UNTIL TIMEOUT 1", "SPEED 1", "ROBOT", "QUIT", "PRINT"}));
}

TEST(Parsers, OfOverlaysAreLinear) {
  const Parse parse = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    odl::parse(source, sink);
  };
  expect_linear("ODL", parse, {"", "CONTROL MEASURES:\n"},
                with_common({"CONTROL MEASURES:", "AA a 1 1", "PP a 1 1", "WALL a 0 0 1 1", "OBSTACLE 1 1 1",
                             "OBJECT 1 1 1 FIXED red", "ATTRACTOR 1 1", "MISSION-AREA 1 1", "ORIGIN 1 1",
                             "GAP a 0 0 1 1", "BOUNDARY a 1 1", "1 1", "SCENARIO a", "ROOM a 1 1"}));
  const Parse changes = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    envchange::parse(source, {}, sink);
  };
  expect_linear("environment changes", changes, {""},
                with_common({"1 OBSTACLE 1 1 1", "AT 1", "TIME 1", "REMOVE", "ADD", "1 1 1"}));
}

TEST(Parsers, OfHistoricConfigurationsAreLinear) {
  const Parse parse = [](const text::SourcePtr& source, text::Diagnostics& sink) {
    cdl_historic::parse(source, sink);
  };
  expect_linear("historic CDL", parse, {"", "instAgent<0,0> A from B( "},
                with_common({"bindArch AuRA;", "instAgent", "instAgent<0,0> A from B();",
                             "instBP<1,1> $a from b();", "defAgent", "[ A ]", "%a = {1}", "{1}", "{^}",
                             "<1,1>", "|a|", "$A", "a:b", "if", "goto", "[ A ]<1,1>", "name:b("}));
}

}  // namespace
}  // namespace mlab
