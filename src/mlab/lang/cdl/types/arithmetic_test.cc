#include "mlab/lang/cdl/types/arithmetic.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/print/changes.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/print/reprint.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

struct ParsedText {
  Tree tree;
  std::string errors;

  const Expression& value() const { return *std::get<Assemblage>(tree.items.front()).lets.front().value; }
};

ParsedText read_value(const std::string& expression) {
  text::Diagnostics sink;
  ParsedText out;
  const auto source = std::make_shared<const text::Source>(
      "a.cdl", "assemblage A(a: number) {\n  let x = " + expression + ";\n  x\n}\n");
  out.tree = parse(source, sink);
  out.errors = text::render(sink);
  return out;
}

// The expression with parentheses around all that is computed.
std::string grouped(const Expression& expression) {
  if (const auto* logic = std::get_if<Logic>(&expression.what)) {
    std::string out = logic->connective == Connective::kNot ? "(not " : "(";
    for (const ExpressionPtr& operand : logic->operands) {
      if (operand != logic->operands.front()) out += logic->connective == Connective::kAnd ? " and " : " or ";
      out += grouped(*operand);
    }
    return out + ")";
  }
  const auto* arithmetic = std::get_if<Arithmetic>(&expression.what);
  if (arithmetic == nullptr) return print(expression);
  if (arithmetic->operations.front() == Operation::kNegate)
    return "(-" + grouped(*arithmetic->operands.front()) + ")";
  std::string out = "(" + grouped(*arithmetic->operands.front());
  for (std::size_t i = 0; i < arithmetic->operations.size(); ++i)
    out += std::string(sign_of(arithmetic->operations[i])) + grouped(*arithmetic->operands[i + 1]);
  return out + ")";
}

std::string grouped(const std::string& text) {
  const ParsedText read = read_value(text);
  return read.errors.empty() ? grouped(read.value()) : read.errors;
}

TEST(Arithmetic, BindsAsInC) {
  EXPECT_EQ(grouped("a + b * c - d / e"), "(a+(b*c)-(d/e))");
  EXPECT_EQ(grouped("-a * b"), "((-a)*b)");
  EXPECT_EQ(grouped("a - -b"), "(a-(-b))");
  EXPECT_EQ(grouped("(a + b) * c"), "((a+b)*c)");
  EXPECT_EQ(grouped("a + b < c * 2 and not d >= e or f"), "((((a+b)<(c*2)) and (not (d>=e))) or f)");
  EXPECT_EQ(grouped("a == b"), "(a==b)");
  EXPECT_EQ(grouped("a != b + 1"), "(a!=(b+1))");
}

TEST(Arithmetic, TakesASignBehindAValueForAnOperation) {
  EXPECT_EQ(grouped("a -1"), "(a-1)");
  EXPECT_EQ(grouped("a-1"), "(a-1)");
  EXPECT_EQ(grouped("2 m+3 m"), "(2 m+3 m)");
  EXPECT_EQ(grouped("a -1 * b"), "(a-(1*b))");
  EXPECT_EQ(grouped("a\n-1"), "(a-1)");
  EXPECT_EQ(grouped("(a)-1 +2 m"), "(a-1+2 m)");
  EXPECT_EQ(grouped("a--1"), "(a--1)");
  EXPECT_EQ(grouped("not -1 < a"), "(not (-1<a))");
  EXPECT_EQ(grouped("a * -1"), "(a*-1)");
  EXPECT_EQ(grouped("-1"), "-1");
  EXPECT_EQ(grouped("- 1"), "(-1)");
}

TEST(Arithmetic, TellsUnitsFromDivision) {
  EXPECT_EQ(grouped("6 m/s"), "6 m/s");
  EXPECT_EQ(grouped("6 m / s"), "6 m/s");
  EXPECT_EQ(grouped("6 m / a"), "(6 m/a)");
  EXPECT_EQ(grouped("6 m / 2"), "(6 m/2)");
  EXPECT_EQ(grouped("6 m/s / 2 s"), "(6 m/s/2 s)");
  EXPECT_EQ(grouped("(6 m) / s"), "(6 m/s)");
}

TEST(Arithmetic, DividesByWhatIsCalledAsAUnitIs) {
  EXPECT_EQ(grouped("6 m / min(a, b)"), "(6 m/min(a, b))");
  EXPECT_EQ(grouped("6 m/min(a, b) / 2"), "(6 m/min(a, b)/2)");
  EXPECT_EQ(grouped("6 m/min / a"), "(6 m/min/a)");
  const std::string text = "assemblage A() {\n  let x = 6 m / min(a, b);\n  x\n}\n";
  EXPECT_EQ(laid_out(text), text);
  const ParsedText read = read_value("6 m / min(a, b)");
  EXPECT_NE(print(read.tree).find("let x = 6 m / min(a, b);"), std::string::npos) << print(read.tree);
}

TEST(Arithmetic, TakesASignBehindANameForAnOperationWhateverTheNameIs) {
  for (const std::string name : {"by", "in", "case", "when", "active", "and", "or"}) {
    EXPECT_EQ(grouped(name + " -1"), "(" + name + "-1)");
    EXPECT_EQ(grouped("a * (" + name + "-1)"), "(a*(" + name + "-1))");
    EXPECT_EQ(grouped("a + " + name + " -1"), "(a+" + name + "-1)");
    const std::string text = "assemblage A() {\n  let x = " + name + " - 1;\n  x\n}\n";
    EXPECT_EQ(laid_out("assemblage A() {\n  let x = " + name + "-1;\n  x\n}\n"), text);
  }
  EXPECT_EQ(grouped("a < 1 and -1 < a or -2 < b"), "(((a<1) and (-1<a)) or (-2<b))");
  text::Diagnostics sink;
  parse(std::make_shared<const text::Source>(
            "a.cdl",
            "assemblage A(a: number = 1 in -1 .. 2, b: number = 1 m in -1 .. 2) {\n"
            "  select by -1 { case -1: a; otherwise: b; }\n}\n"
            "assemblage B() { sequence { start One: A(); when -1 < 2 goto One; } }\n"),
        sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
}

TEST(Arithmetic, RefusesAChainOfComparisonsAndWhatIsNotWhole) {
  EXPECT_NE(read_value("1 < a < 3").errors.find("a comparison is of two"), std::string::npos);
  EXPECT_NE(read_value("a +").errors.find("expected a value"), std::string::npos);
  EXPECT_NE(read_value("a * / b").errors.find("expected a value"), std::string::npos);
  EXPECT_NE(read_value("-").errors.find("expected a value"), std::string::npos);
}

TEST(Arithmetic, IsPrintedWithTheParenthesesThatItNeeds) {
  for (const char* text :
       {"a + b * c", "(a + b) * c", "a - (b - c)", "-(a + b)", "-a * b", "a / (b * c)", "-(2)", "a - -2",
        "not a < b", "not (a and b < c)", "(6 m) / s", "6 m/s", "min(a, b + 1) * 2", "(a + b) as sum",
        "a + b as part", "(a < b) == c", "2 * (a + b) < c or d"}) {
    const ParsedText read = read_value(text);
    EXPECT_EQ(read.errors, "") << text;
    EXPECT_NE(print(read.tree).find("let x = " + std::string(text) + ";"), std::string::npos)
        << text << "\n"
        << print(read.tree);
  }
}

// Whatever it is made of: of numbers, names, calls, operations.
ExpressionPtr any_formula(int depth) {
  const auto make = [](auto what) {
    auto out = std::make_shared<Expression>();
    out->what = std::move(what);
    return out;
  };
  const int kind = *rc::gen::inRange(0, depth <= 0 ? 3 : 8);
  if (kind == 0) return make(Name{{*rc::gen::element<std::string>("a", "b", "s", "m"), {}}});
  if (kind == 1) return make(Number{*rc::gen::element(2.0, -2.0, 0.5, 1e-9), {}, {}});
  if (kind == 2) return make(Number{3.0, {*rc::gen::element<std::string>("m", "m/s", "s"), {}}, {}});
  if (kind == 3) return make(Call{{"min", {}}, {{{}, any_formula(depth - 1)}, {{}, any_formula(depth - 1)}}});
  if (kind == 4) return make(Logic{Connective::kNot, {any_formula(depth - 1)}});
  if (kind == 5) return make(Arithmetic{{Operation::kNegate}, {any_formula(depth - 1)}});
  if (kind == 6) {
    const auto comparison = static_cast<Operation>(*rc::gen::inRange(static_cast<int>(Operation::kLess), 11));
    return make(Arithmetic{{comparison}, {any_formula(depth - 1), any_formula(depth - 1)}});
  }
  const bool is_sum = *rc::gen::arbitrary<bool>();
  Arithmetic chain{{}, {any_formula(depth - 1)}};
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
    const bool is_first = *rc::gen::arbitrary<bool>();
    chain.operations.push_back(is_sum ? (is_first ? Operation::kAdd : Operation::kSubtract)
                                      : (is_first ? Operation::kMultiply : Operation::kDivide));
    chain.operands.push_back(any_formula(depth - 1));
  }
  return make(std::move(chain));
}

RC_GTEST_PROP(ArithmeticLaws, WhatIsPrintedIsReadAsWhatItWas, ()) {
  const ExpressionPtr formula = any_formula(4);
  const std::string text = print(*formula);
  RC_LOG() << text << "\n";
  const ParsedText again = read_value(text);
  RC_ASSERT(again.errors.empty());
  RC_ASSERT(grouped(again.value()) == grouped(*formula));
  RC_ASSERT(print(again.value()) == text);
}

RC_GTEST_PROP(ArithmeticLaws, AnyWordsAreReadAndLaidOutTheSameTheSecondTime, ()) {
  std::string text;
  for (int i = *rc::gen::inRange(0, 24); i > 0; --i) {
    text += *rc::gen::element<std::string>("a", "2", " -1", "-", "+", "*", "/", "(", ")", " m", " < ",
                                           "==", "min(", ",", " not ", " and ", "[", "]", " ", "\n", "3 m/s",
                                           " as x ", ".5");
  }
  const auto source =
      std::make_shared<const text::Source>("a.cdl", "assemblage A() {\n  let x = " + text + ";\n}\n");
  text::Diagnostics sink;
  parse(source, sink);
  read_as_written(source);
  if (sink.has_errors()) return;
  const std::string once = laid_out(source->text());
  RC_ASSERT(laid_out(once) == once);
  const auto laid = std::make_shared<const text::Source>("a.cdl", once);
  RC_ASSERT(print(parse(laid, sink)) == print(parse(source, sink)));
}

TEST(Arithmetic, IsLaidOutWithBlanksAroundItsSigns) {
  text::Diagnostics sink;
  const auto source =
      std::make_shared<const text::Source>("a.cdl",
                                           "assemblage A(a: number=2*3, s: duration = 1 s) {\n"
                                           "  let x=-a*(a+-2)/4 m/s -1;\n"
                                           "  let y = not(-a<=3)and a==4;\n"
                                           "  let z = 6 m / a - min(-a,-3 m / s)+[-a, -1][ ];\n"
                                           "  x\n}\n\nlayout A {\n  x 40 -40;\n}\n");
  EXPECT_EQ(laid_out(source->text()),
            "assemblage A(a: number = 2 * 3, s: duration = 1 s) {\n"
            "  let x = -a * (a + -2) / 4 m/s - 1;\n"
            "  let y = not (-a <= 3) and a == 4;\n"
            "  let z = 6 m / a - min(-a, -3 m/s) + [-a, -1] [];\n"
            "  x\n}\n\nlayout A {\n  x 40 -40;\n}\n");
}

TEST(Arithmetic, IsChangedInItsText) {
  const ParsedText read = read_value("a -1 * b  /* why */");
  const auto& sum = std::get<Arithmetic>(read.value().what);
  Changes changes(read.tree);
  Expression two;
  two.what = Number{2.0, {}};
  changes.replace(*sum.operands[0], std::make_shared<const Expression>(std::move(two)));
  const std::string now = changes.done().text;
  EXPECT_NE(now.find("let x = 2 -1 * b  /* why */;"), std::string::npos) << now;
}

// The text after the first operand became another one.
std::string with_another_operand(const std::string& text, std::size_t at) {
  const ParsedText read = read_value(text);
  EXPECT_EQ(read.errors, "");
  Changes changes(read.tree);
  Expression other;
  other.what = Name{{"other", {}}};
  const auto& sum = std::get<Arithmetic>(read.value().what);
  changes.replace(*sum.operands[at], std::make_shared<const Expression>(std::move(other)));
  return changes.done().text;
}

TEST(Arithmetic, KeepsNumbersBehindSeveralGluedSigns) {
  const std::string now = with_another_operand("a -1 m * (b -2)", 0);
  EXPECT_NE(now.find("let x = other -1 m * (b -2);"), std::string::npos) << now;
}

TEST(Arithmetic, KeepsBlanksBehindGluedSigns) {
  const std::string now = with_another_operand("a-1-f (b ,c)+d", 3);
  EXPECT_NE(now.find("a-1-f (b ,c)+ other;"), std::string::npos) << now;
}

TEST(Arithmetic, BreaksLongLinesWithGluedSignsTheSameTheSecondTime) {
  std::string sum = "a";
  for (int i = 0; i < 60; ++i) sum += " -1" + std::string(static_cast<std::size_t>(i % 7), '0');
  const std::string once = laid_out("assemblage A() {\n  let x = " + sum + ";\n  x\n}\n");
  EXPECT_EQ(laid_out(once), once);
}

TEST(Units, AreMultipliedAndSaidInSiUnits) {
  const auto unit = [](const char* name) { return unit_named(name).value_or(Unit{99}); };
  EXPECT_EQ(si_unit(unit("km/h")), "m/s");
  EXPECT_EQ(si_unit(unit("deg/s")), "rad/s");
  EXPECT_EQ(si_unit(unit("m").times(unit("m"))), "m*m");
  EXPECT_EQ(si_unit(unit("m/s").times(unit("s"), -1)), "m/s/s");
  EXPECT_EQ(si_unit(unit("").times(unit("s"), -1)), "1/s");
  for (const char* name : {"m*m", "m/s/s", "1/s", "m*rad/s", ""}) EXPECT_EQ(si_unit(unit(name)), name);
  EXPECT_EQ(si_unit(unit("m/s*rad")), "m*rad/s") << "only what stands next is divided by";
  EXPECT_FALSE(unit_named("m/"));
  EXPECT_FALSE(unit_named("*m"));
  EXPECT_FALSE(unit_named("1"));
}

// ---- types

PortType number(const char* unit) {
  return {&flow::type_info<double>(), unit};
}
PortType vector(const char* unit) {
  return {&flow::type_info<geom::Vector>(), unit};
}
const PortType kPoint{&flow::type_info<geom::Point>(), "m"};

std::string result(Operation operation, const PortType& a, const PortType& b) {
  const Computation how = computation(operation, std::vector{a, b});
  return how.refusal.empty() ? how.type.name() + " " + how.type.unit : how.refusal;
}

TEST(Computation, CarriesUnits) {
  EXPECT_EQ(result(Operation::kMultiply, number("m/s"), number("s")), "double m");
  EXPECT_EQ(result(Operation::kDivide, number("m"), number("s")), "double m/s");
  EXPECT_EQ(result(Operation::kDivide, number("m"), number("cm")), "double ");
  EXPECT_EQ(result(Operation::kAdd, number("cm"), number("km")), "double m");
  EXPECT_EQ(result(Operation::kLess, number("deg"), number("rad")), "bool ");
  EXPECT_EQ(result(Operation::kMultiply, number("1/s"), vector("m")), "Vector m/s");
  EXPECT_EQ(result(Operation::kAdd, vector("m"), vector("")), "Vector m");
}

TEST(Computation, RefusesWhatDoesNotAgree) {
  EXPECT_EQ(result(Operation::kAdd, number("m"), number("s")),
            "a value in m and a value in s can't be added");
  EXPECT_EQ(result(Operation::kSubtract, number("m"), number("")),
            "a value in m and a plain number can't be subtracted");
  EXPECT_EQ(result(Operation::kGreater, number(""), number("s")),
            "a plain number and a value in s can't be compared");
  EXPECT_EQ(result(Operation::kAdd, kPoint, vector("m")), "a Point and a Vector can't be added");
  EXPECT_EQ(result(Operation::kSubtract, kPoint, kPoint), "a Point and a Point can't be subtracted");
  EXPECT_EQ(result(Operation::kMultiply, vector("m"), vector("m")),
            "a Vector and a Vector can't be multiplied");
  EXPECT_EQ(result(Operation::kDivide, number("m"), vector("m")), "a number and a Vector can't be divided");
  EXPECT_EQ(result(Operation::kLess, vector("m"), number("m")), "a Vector and a number can't be compared");
}

TEST(Computation, FoldsWhatIsNoNumberAsTheLibraryDoes) {
  const auto fold = [](const char* behavior, std::vector<double> numbers) {
    return folded(behavior, numbers).value_or(7.0);
  };
  const double none = fold("DivideNumbers", {1.0, 0.0});
  EXPECT_TRUE(std::isnan(none));
  for (const char* name : {"Minimum", "Maximum"}) {
    EXPECT_TRUE(std::isnan(fold(name, {none, 1.0}))) << name;
    EXPECT_TRUE(std::isnan(fold(name, {1.0, none}))) << name;
  }
  EXPECT_TRUE(std::isnan(fold("Clamp", {none, 0.0, 1.0})));
  EXPECT_TRUE(std::isnan(fold("Clamp", {0.5, none, 1.0})));
  EXPECT_TRUE(std::isnan(fold("Clamp", {0.5, 0.0, none})));
  EXPECT_EQ(fold("Clamp", {3.0, 0.0, 1.0}), 1.0);
}

TEST(Computation, IsOfTwoPlacesInOneFrame) {
  const Function& distance = *function_named("distance");
  EXPECT_EQ(computation(distance, std::vector{kPoint, kPoint}).behavior, "DistanceOfPoints");
  EXPECT_EQ(computation(distance, std::vector{vector("m"), vector("m")}).type.unit, "m");
  EXPECT_EQ(computation(distance, std::vector{kPoint, vector("m")}).refusal,
            "`distance` is of two Points or of two Vectors; these are a Point and a Vector");
}

}  // namespace
}  // namespace mlab::cdl
