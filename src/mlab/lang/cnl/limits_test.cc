#include <functional>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/format.h"
#include "mlab/lang/cnl/generate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/parser.h"

namespace mlab::cnl {
namespace {

constexpr std::size_t kSize = base::kMegabyte;

// Everything that happens to a file that a stranger sends, short of the C++ compiler. False: it has mistakes.
bool read_all(std::string text) {
  const auto source = std::make_shared<const text::Source>("a.cnl", std::move(text));
  looks_like_cnl(source->text());
  text::Diagnostics sink;
  const Tree tree = parse(source, sink);
  check_order(tree, sink);
  check_declarations(tree, sink);
  elaborate(tree, sink);
  text::render(sink);
  if (!sink.has_errors()) generate(tree, {"a.cc", false});
  text::Diagnostics other;
  format(source, other);
  return !sink.has_errors();
}

std::string repeated(const std::string& piece) {
  std::string out;
  out.reserve(kSize + piece.size());
  while (out.size() < kSize) out += piece;
  return out;
}

std::string numbered(const std::function<std::string(const std::string&)>& piece) {
  std::string out;
  for (int i = 0; out.size() < kSize; ++i) out += piece(std::to_string(i));
  return out;
}

double times_longer(const std::string& text) {
  static const std::string kOrdinary = numbered([](const std::string& number) {
    return "/// Half of it.\nprocedure double Half" + number +
           " with\n  double speed = 1;  ///< all of it\nheader\nbody\n  return speed / 2;\npend\n";
  });
  static const base::Yardstick kYardstick([] { EXPECT_TRUE(read_all(kOrdinary)); });
  return kYardstick.times([&] { read_all(text); }, base::kPatience);
}

TEST(Limits, AMegabyteOfAnyOnePieceIsAnsweredSoon) {
  const std::vector<std::string> pieces = {"a",
                                           "-",
                                           "$",
                                           "(",
                                           ")",
                                           "{",
                                           "}",
                                           "[",
                                           "]",
                                           "<",
                                           "|",
                                           "\"",
                                           "'",
                                           "/*",
                                           "//",
                                           "/",
                                           "#",
                                           "\n",
                                           "\r",
                                           " ",
                                           "\t",
                                           "0",
                                           ".",
                                           "..",
                                           "1e",
                                           "\\",
                                           "\xff",
                                           std::string(1, '\0'),
                                           "///\n",
                                           "///< x\n",
                                           "#include \"a\"\n",
                                           "# \n",
                                           "procedure ",
                                           "node ",
                                           "nend ",
                                           "pend\n",
                                           "pend ",
                                           "header\n",
                                           "body\n",
                                           "init\n",
                                           "iend\n",
                                           "with ",
                                           "list ",
                                           "int x;\n",
                                           "node a is B with nend\n",
                                           "node a is B with x = 1;\n",
                                           "x = 1;\n",
                                           "procedure int A with\n",
                                           "procedure int A with\nheader\nbody\npend\n",
                                           "procedure int A with\nheader\n",
                                           "public ",
                                           "remote ",
                                           "remote node a:b is c\n",
                                           "sequence s of V with\n",
                                           "start state A is b;\n",
                                           "when a goto b;\n",
                                           "select s of V by t with case 1: a;\n",
                                           "case ",
                                           "delay d of V with nend\n",
                                           "parameter int a = 1;\n",
                                           "type <a, \"b\">;\n",
                                           "module a;\n",
                                           "modulename = a;\n",
                                           "node n is DATABASE_INT with key = {\"k\"}; initial = 1; nend\n",
                                           "external procedure int A with pend\n",
                                           "alias A (",
                                           "[m] ",
                                           "in 0 .. 1 "};
  for (const std::string& piece : pieces)
    EXPECT_LT(times_longer(repeated(piece)), base::kPatience) << "repeated: " << piece;
}

TEST(Limits, AMegabyteOfCppWithinAProcedureIsAnsweredSoon) {
  const std::vector<std::string> pieces = {"{",
                                           "}",
                                           "(",
                                           "[",
                                           "<",
                                           "a<",
                                           "int x;\n",
                                           "int x = {1};\n",
                                           "\"",
                                           "'",
                                           "R\"(",
                                           "R\"",
                                           "#\\\n",
                                           "/*",
                                           "auto [a] = b;\n",
                                           "static ",
                                           "a::",
                                           "struct {} x;\n",
                                           "int a, b;\n",
                                           "int a,",
                                           "random ",
                                           "x",
                                           ";",
                                           "if (a) {} ",
                                           "[[",
                                           "x.",
                                           "return;\n",
                                           "{}"};
  for (const std::string& piece : pieces) {
    const std::string code = repeated(piece);
    EXPECT_LT(times_longer("procedure int A with\nonce\n" + code + "\nheader\nbody\npend\n"), base::kPatience)
        << "repeated: " << piece;
    EXPECT_LT(times_longer("procedure int A pure with\nheader\n" + code + "\nbody\n" + "x" + "\npend\n"),
              base::kPatience)
        << "repeated: " << piece;
  }
}

TEST(Limits, ManyInputsInOneProcedureAreAnsweredSoon) {
  const std::string inputs = numbered([](const std::string& number) {
    return "  double [m] input_" + number + " = 5 in 0 .. 10;  ///< help\n";
  });
  EXPECT_LT(times_longer("procedure int A with\n" + inputs + "header\nbody\npend\n"), base::kPatience);
}

TEST(Limits, AMegabyteOfRandomBytesIsAnsweredSoon) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 4; ++round) {
    std::string text(kSize, ' ');
    for (char& c : text)
      c = static_cast<char>(random() % (round % 2 == 0 ? 256 : 96) + (round % 2 == 0 ? 0 : 32));
    EXPECT_LT(times_longer(text), base::kPatience);
  }
}

// Words of the language in any order.
RC_GTEST_PROP(Limits, AnyOrderOfWordsGetsAnAnswer, ()) {
  static const std::vector<std::string> kWords = {"procedure ", "external ", "node ",    "is ",
                                                  "with ",      "nend ",     "\npend\n", "\nheader\n",
                                                  "\nbody\n",   "\nonce\n",  "init\n",   "\niend\n",
                                                  "list ",      "int ",      "Vector ",  "a ",
                                                  "B ",         "; ",        "= ",       "5 ",
                                                  "{1} ",       "\"x\" ",    "[m] ",     "( ",
                                                  ") ",         "alias ",    "senses ",  "robots within ",
                                                  "pure ",      "latency ",  "in ",      ".. ",
                                                  "sequence ",  "select ",   "delay ",   "of ",
                                                  "by ",        "start ",    "state ",   "when ",
                                                  "goto ",      "case ",     ": ",       "otherwise ",
                                                  "parameter ", "|d| ",      "<",        "> ",
                                                  ", ",         "type ",     "module ",  "#include \"q\"\n",
                                                  "/// x\n",    "///< y\n",  "/* ",      "*/ ",
                                                  "// z\n",     "remote ",   "public ",  "'c' ",
                                                  "\n",         "{ ",        "} ",       "int x = 1; ",
                                                  "static ",    "struct "};
  std::string text;
  for (const std::string& word :
       *rc::gen::resize(400, rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(kWords))))
    text += word;
  read_all(text);
}

}  // namespace
}  // namespace mlab::cnl
