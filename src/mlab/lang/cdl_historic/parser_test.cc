#include "mlab/lang/cdl_historic/parser.h"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace mlab::cdl_historic {
namespace {

struct Parsed {
  Tree tree;
  std::string said;
};

Parsed parsed(std::string text) {
  text::Diagnostics sink;
  Parsed out;
  out.tree = parse(std::make_shared<const text::Source>("old.cdl", std::move(text)), sink);
  for (const text::Diagnostic& item : sink.items()) out.said += item.kind + " ";
  return out;
}

TEST(HistoricParser, ReadsAnInstanceWithItsPlaceItsTextAndItsArguments) {
  const auto [tree, said] = parsed(
      "instAgent <3, -4.5> |the goal| g from MOVE_TO( have_a_goal<1,2>|x| = {true}, goal_rel_loc = $P );");
  ASSERT_EQ(said, "");
  ASSERT_EQ(tree.instances.size(), 1U);
  const Instance& g = tree.instances[0];
  EXPECT_EQ(g.name.text, "g");
  EXPECT_EQ(g.spot.y, -4.5);
  EXPECT_EQ(g.spot.label.text, "the goal");
  ASSERT_EQ(g.what->settings.size(), 2U);
  EXPECT_EQ(g.what->settings[0].value.constant.text, "true");
  EXPECT_EQ(g.what->settings[1].value.expr->name.text, "$P");
}

TEST(HistoricParser, TellsReferencesInstancesAndGroupsApartByWhatFollows) {
  const auto [tree, said] = parsed("[ Stop, a:b:DRIVE<1,1>|base|( v = , ), %x = {1}, [ ]<5,6>|empty| ]");
  ASSERT_EQ(said, "");
  ASSERT_EQ(tree.expressions.size(), 1U);
  const auto& members = tree.expressions[0]->settings;
  ASSERT_EQ(members.size(), 4U);
  EXPECT_EQ(members[0].value.expr->kind, Expr::Kind::kReference);
  EXPECT_EQ(members[1].value.expr->kind, Expr::Kind::kInstance);
  EXPECT_EQ(members[1].value.expr->inline_names.size(), 2U);
  EXPECT_EQ(members[1].value.expr->settings[0].value.kind, Value::Kind::kNone);
  EXPECT_TRUE(members[2].is_pushed);
  EXPECT_EQ(members[3].value.expr->spot.label.text, "empty");
}

TEST(HistoricParser, ReadsAllFormsOfPushedUpValues) {
  const auto [tree, said] =
      parsed("[ %a = {^}, %b = {^T %c}, %d = {@^ T %e}, %f = {^T {& %lat %lon}}, %g = ^, %h = { ^} ]");
  ASSERT_EQ(said, "");
  const auto& members = tree.expressions.at(0)->settings;
  ASSERT_EQ(members.size(), 6U);
  EXPECT_EQ(members[0].value.up.name.text, "");
  EXPECT_EQ(members[1].value.up.name.text, "c");
  EXPECT_EQ(members[2].value.up.type.text, "T");
  EXPECT_EQ(members[3].value.up.second.text, "lon");
  EXPECT_EQ(members[4].value.kind, Value::Kind::kBare);
  EXPECT_EQ(members[5].value.constant.text, " ^");  // not adjacent: an ordinary constant
}

TEST(HistoricParser, ReadsRulesAndListParameters) {
  const auto [tree, said] = parsed(
      "f:FSA( society[Start]<5,5>|Resting| = [ Stop ], rules[Start] = if [ %Delay = {3}, Wait ]<0,0>|t| goto "
      "$S1, "
      "rules[$S1] = if goto Start, rules[x] = if trigger goto Start, list[A] = ( %p = {1}, Stop ) )");
  ASSERT_EQ(said, "");
  const auto& settings = tree.expressions.at(0)->settings;
  ASSERT_EQ(settings.size(), 5U);
  EXPECT_EQ(settings[0].index.text, "Start");
  EXPECT_EQ(settings[1].value.rule->members.size(), 2U);
  EXPECT_EQ(settings[1].value.rule->target.text, "$S1");
  EXPECT_TRUE(settings[2].value.rule->members.empty());
  EXPECT_EQ(settings[3].value.rule->members.at(0).value.expr->name.text, "trigger");
  EXPECT_EQ(settings[4].value.list.size(), 2U);
}

TEST(HistoricParser, ReadsDefinitions) {
  const auto [tree, said] = parsed(
      "defArch mine; bindArch AuRA.urban; defType [AuRA] speed SliderBar 0 5 |m/s| = {0}, {5};\n"
      "defType colour = {\"red\"}, {\"blue\"};\n"
      "defAgent [AuRA] binds near Vector NEAR |text| ( boolean a, const double b = {1}, list [ Vector v, "
      "double w ] );\n"
      "defOp Vector PICK SELECTstyle ( list Vector members ); defibp ObjectList eyes ( double range );\n"
      "defRBP vehicle ( ); defActuator binds movement void LEGS ( Vector v );\n"
      "defRobot binds vehicle SPIDER ( actuator base:LEGS, sensor eye:EYES );\n"
      "defNamedValue HERE ForDataType string = {\"here\"};");
  ASSERT_EQ(said, "");
  EXPECT_EQ(tree.architectures.at(0).text, "AuRA.urban");
  ASSERT_EQ(tree.definitions.size(), 6U);
  const Definition& near = tree.definitions[0];
  EXPECT_EQ(near.architecture.text, "AuRA");
  EXPECT_EQ(near.label.text, "text");
  ASSERT_EQ(near.params.size(), 4U);
  EXPECT_TRUE(near.params[1].is_const);
  EXPECT_EQ(near.params[1].initial.text, "1");
  EXPECT_TRUE(near.params[3].is_list);
  EXPECT_EQ(tree.definitions[1].style.text, "SELECTstyle");
  EXPECT_TRUE(tree.definitions[5].slots.at(0).is_actuator);
  EXPECT_EQ(tree.named_values.at(0).value.text, "\"here\"");
  EXPECT_EQ(tree.types.size(), 2U);
}

TEST(HistoricParser, ReadsWhatTheHistoricGrammarForbidsButMeansSomething) {
  // A semicolon behind a top-level expression, none behind instRobot, a dot in an inline name.
  const auto [tree, said] = parsed("instRobot r from MRV2( r:[ $W ] )\n my.robot:[ r ]<1,1>;");
  EXPECT_EQ(said, "");
  EXPECT_EQ(tree.instances.size(), 1U);
  EXPECT_EQ(tree.expressions.at(0)->inline_names.at(0).text, "my.robot");
}

TEST(HistoricParser, LeavesOutCommentsMarkersAndPragmas) {
  const auto [tree, said] = parsed("# 1 \"old.cdl\" 2\n#pragma once\n/* a\n ; */ // b\n[ Stop ]");
  EXPECT_EQ(said, "");
  EXPECT_EQ(tree.expressions.size(), 1U);
  EXPECT_EQ(parsed("#define X 1\n[ Stop ]").said, "unknown-directive ");
}

TEST(HistoricParser, SaysOneErrorPerStatementAndGoesOnAtTheNext) {
  const auto [tree, said] =
      parsed("instAgent a MOVE_TO( x = );\ninstAgent b from ( );\ninstAgent c from NOOP();");
  EXPECT_EQ(said, "expected-other expected-other ");
  ASSERT_EQ(tree.instances.size(), 1U);
  EXPECT_EQ(tree.instances[0].name.text, "c");
}

TEST(HistoricParser, SaysWhatHasNoEnd) {
  EXPECT_EQ(parsed("/* never").said, "unterminated-comment ");
  EXPECT_EQ(parsed("instAgent a from B( c = {1").said, "unterminated-initializer expected-more ");
  EXPECT_EQ(parsed("[ Stop ]|text\n").said, "unterminated-description ");
  EXPECT_EQ(parsed("[ Stop").said, "expected-more ");
  EXPECT_EQ(parsed("\x01\x02[ Stop ]").said, "stray-character ");
}

TEST(HistoricParser, RefusesBottomlessNesting) {
  std::string brackets(100'000, '[');
  EXPECT_EQ(parsed(brackets).said, "nested-too-deeply ");
  std::string calls;
  for (int i = 0; i < 100'000; ++i) calls += "A(b=";
  EXPECT_EQ(parsed(calls).said, "nested-too-deeply ");
  std::string lists;
  for (int i = 0; i < 100'000; ++i) lists += "%a=(";
  EXPECT_EQ(parsed("[" + lists).said, "nested-too-deeply ");
}

}  // namespace
}  // namespace mlab::cdl_historic
