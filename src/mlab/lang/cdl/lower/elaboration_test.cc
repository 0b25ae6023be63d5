#include "mlab/lang/cdl/lower/elaboration.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/lang/cdl/lower/owner_model.h"
#include "mlab/lang/cdl/syntax/parser.h"

namespace mlab::cdl {
namespace {

/// A configuration of one file, and what is known of it. No library: names ask for none.
class Elaborated : public ::testing::Test {
 protected:
  void read(const std::string& text) {
    text::Diagnostics sink;
    source_ = std::make_shared<const text::Source>("a.cdl", text);
    configuration_ = load(source_, {}, sink);
    EXPECT_FALSE(sink.has_errors()) << text::render(sink);
    elaboration_ = std::make_unique<Elaboration>(configuration_, library_);
  }
  const Assemblage& assemblage(const std::string& name) const {
    return *configuration_.assemblages.find(name)->second;
  }
  const Robot& robot(const std::string& name) const { return *configuration_.robots.find(name)->second; }
  /// What all inner names of an assemblage are where it runs, in the order of the walk through its drawing.
  std::vector<std::string> paths(const OwnerModel& model) const {
    std::vector<std::string> out;
    for (const ModelPage& page : model.pages) {
      for (const ModelNode& node : page.nodes) out.push_back(node.path);
    }
    return out;
  }
  const Member& member(const std::string& of, std::size_t index) const {
    return std::get<Cooperate>(assemblage(of).body->what).members[index];
  }

  text::SourcePtr source_;
  Configuration configuration_;
  flow::Library library_;
  std::unique_ptr<Elaboration> elaboration_;
};

using Names = std::vector<std::string>;

TEST_F(Elaborated, NodesAreCalledAsWhatTheyAreAndNumberedWhereThatIsTaken) {
  read(R"(assemblage A() {
    let drift = Noise();
    cooperate { Noise(); 2: Noise(); drift; Noise() as drift; Noise() as Noise_2; }
  })");
  EXPECT_EQ(paths(model_of(assemblage("A"), *elaboration_)),
            (Names{"", "Noise", "Noise_2", "drift", "drift_2", "Noise_2_2"}));
}

TEST_F(Elaborated, ALetIsNamedWhereItIsReadFirst) {
  read("assemblage A() { let Noise = Stand(); let unread = Noise(); cooperate { Noise(); Noise; } }");
  const OwnerModel model = model_of(assemblage("A"), *elaboration_);
  EXPECT_EQ(paths(model), (Names{"", "Noise", "Noise_2", "unread"}));
  EXPECT_EQ(elaboration_->names(assemblage("A")).top(), (NamesBelow{"Noise", "Noise_2"}));
}

TEST_F(Elaborated, StatesAndTriggersStandBelowTheirSequence) {
  read(R"(assemblage A() { sequence {
    start Go: Noise();
      when not Detect(near) and Near() and Far() goto Stop;
    Stop: cooperate { Noise(); };
      when not Detect(near) goto Go;
  } })");
  const OwnerModel model = model_of(assemblage("A"), *elaboration_);
  ASSERT_EQ(model.pages.size(), 3U);
  EXPECT_EQ(model.pages[1].path, "A.Go");
  EXPECT_EQ(model.pages[2].path, "A.Stop");
  EXPECT_EQ(paths(model), (Names{"Go", "Stop", "Stop.Noise"}));
  std::vector<std::string> hidden;
  for (const auto& [expression, path] : model.hidden) hidden.push_back(path);
  std::ranges::sort(hidden);
  EXPECT_EQ(hidden,
            (Names{"Go.And", "Go.And.Far", "Go.And.Near", "Go.And.Not", "Go.And.Not.Detect", "Stop.Detect"}));
  const Expression& chain = *model.pages[1].state->transitions[0].trigger;
  EXPECT_EQ(elaboration_->names(assemblage("A")).of(*std::get<Logic>(chain.what).operands[1]).behind,
            "Go.And.And");
}

TEST_F(Elaborated, AnActivePartStandsBesideTheValue) {
  read(
      "assemblage A() { cooperate { Probe() active Turn(); Noise(); } } assemblage Turn() -> Vector { "
      "Stand() }");
  const NodeNames::Paths& paths = elaboration_->names(assemblage("A")).of(*member("A", 0).value);
  EXPECT_EQ(paths.path, "Probe");
  EXPECT_EQ(paths.inside, "Probe.value");
  const Expression& active = *member("A", 0).value->active;
  EXPECT_EQ(elaboration_->names(assemblage("A")).of(active).path, "Probe.active");
  EXPECT_EQ(elaboration_->names(assemblage("A")).of(active).behind, "Probe.is_idle");
}

constexpr const char* kInner = R"(
  assemblage Inner(v: Vector, w: Vector = Noise()) { cooperate { Noise(); v; w; } }
  assemblage Through(v: Vector) { Inner(v = v) }
  assemblage Outer() { cooperate { Inner(v = Noise(), w = v); Through(v = Noise()); Inner(v = Stand(), w = v); Stand(); } }
)";

TEST_F(Elaborated, WhatACallerGivesStandsBelowTheCallAndComesFirst) {
  read(kInner);
  const NodeNames& outer = elaboration_->names(assemblage("Outer"));
  const Expression& call = *member("Outer", 0).value;
  EXPECT_EQ(outer.below(call), NamesBelow{"Noise"});
  EXPECT_TRUE(outer.below(*member("Outer", 3).value).empty()) << "no assemblage";
  const std::vector<bool> all{true, true};
  const NodeNames& here = elaboration_->names(assemblage("Inner"), all, outer.below(call));
  EXPECT_EQ(here.of(*member("Inner", 0).value).path, "Noise_2");
  const NodeNames& there =
      elaboration_->names(assemblage("Inner"), all, outer.below(*member("Outer", 2).value));
  EXPECT_EQ(&there, &elaboration_->names(assemblage("Inner"))) << "nothing is called as what was given";
  EXPECT_EQ(there.of(*member("Inner", 0).value).path, "Noise");
}

TEST_F(Elaborated, WhatHandsOnItsPlaceHandsOnWhatIsTakenThere) {
  read(kInner);
  const NodeNames& outer = elaboration_->names(assemblage("Outer"));
  const NodeNames& through =
      elaboration_->names(assemblage("Through"), {true}, outer.below(*member("Outer", 1).value));
  EXPECT_EQ(through.below(*assemblage("Through").body), NamesBelow{"Noise"});
}

TEST_F(Elaborated, ADefaultThatNobodyGivesIsANodeOfItsOwn) {
  read(kInner);
  const NodeNames& inner = elaboration_->names(assemblage("Inner"), {true, false}, {});
  EXPECT_EQ(inner.of(*assemblage("Inner").parameters[1].initial).path, "w");
  EXPECT_EQ(elaboration_->names(assemblage("Inner")).of(*assemblage("Inner").parameters[1].initial).path, "");
  const NodeNames& taken = elaboration_->names(assemblage("Inner"), {true, false}, {"w"});
  EXPECT_EQ(taken.of(*assemblage("Inner").parameters[1].initial).path, "w_2");
}

constexpr const char* kRobots = R"(
  binding sense(range: length) -> Obstacles;
  binding movement(v: Vector);
  class Base {
    sensor one: Look(range = 2 m) binds sense;
    sensor two: Look(far = Far()) binds sense;
    actuator base: Drive(limit = Limit()) binds movement;
  }
  operator Together { sense = Look(); }
  robot Alone is Base { use two for sense; let base = Noise(); movement = cooperate { base; Go(sense()); }; }
  robot Driving is Base { movement = Go(sense()); }
  robot Member is Base { movement = Go(sense()); }
  society We: team of 2 Member by Together;
)";

TEST_F(Elaborated, ARobotsDevicesAreItsClasssAndItsSocietys) {
  read(kRobots);
  EXPECT_EQ(device_for(elaboration_->devices(robot("Alone")), "sense").use->device->name.text, "two");
  const FoundDevice driving = device_for(elaboration_->devices(robot("Driving")), "sense");
  EXPECT_EQ(driving.use->device->name.text, "one");
  EXPECT_EQ(driving.fitting, (Names{"one", "two"}));
  EXPECT_EQ(device_for(elaboration_->devices(robot("Member")), "sense").use->device->name.text, "sense");
  EXPECT_EQ(actuator_for(elaboration_->devices(robot("Member")), "base").use->device->name.text, "base");
  EXPECT_EQ(actuator_for(elaboration_->devices(robot("Member")), "sense").use, nullptr);
}

TEST_F(Elaborated, AnActuatorIsNamedBehindWhatDrivesIt) {
  read(kRobots);
  const auto actuator = [&](const char* name) {
    return elaboration_->names(robot(name)).of(robot(name).drives.front());
  };
  EXPECT_EQ(actuator("Driving"), "base");
  EXPECT_EQ(actuator("Alone"), "base_2") << "the `let` that the drive reads came first";
  const Device& device = configuration_.classes.find("Base")->second->devices[2];
  const NodeNames& arguments = elaboration_->names(device, {});
  EXPECT_EQ(arguments.of(*device.by.arguments[0].value).path, "Limit");
  EXPECT_EQ(arguments.top(), NamesBelow{"Limit"});
}

TEST_F(Elaborated, AModelSaysWhatDrivesEachInputAndInWhichRole) {
  read(R"(assemblage A(gain: gain = 1) {
    let shared = Noise();
    cooperate { gain: shared; 2: delay(shared, initial = [0 m, 0 m]); }
  })");
  const OwnerModel model = model_of(assemblage("A"), *elaboration_);
  const ModelPage& page = model.pages.front();
  const ModelNode& cooperate = page.nodes.at(static_cast<std::size_t>(page.result));
  ASSERT_EQ(cooperate.inputs.size(), 5U);
  EXPECT_EQ(cooperate.inputs[0].role, InputRole::kMember);
  EXPECT_EQ(cooperate.inputs[0].from, page.find("shared"));
  EXPECT_FALSE(cooperate.inputs[0].is_inline);
  EXPECT_EQ(cooperate.inputs[1].role, InputRole::kWeight);
  EXPECT_TRUE(cooperate.inputs[2].is_inline);
  EXPECT_TRUE(cooperate.inputs[4].is_open);
  const ModelNode& delay = page.nodes.at(static_cast<std::size_t>(page.find("delay")));
  EXPECT_EQ(delay.inputs[0].role, InputRole::kDelayed);
  EXPECT_EQ(delay.inputs[1].role, InputRole::kInitial);
  EXPECT_EQ(count_uses(model, "shared"), 2);
  EXPECT_EQ(names_used(model), (std::set<std::string, std::less<>>{"gain", "shared"}));
}

TEST_F(Elaborated, CirclesOfNamesAndOfCallsEnd) {
  read(R"(assemblage A() { let a = Not(b); let b = Not(a); A(v = a) }
          assemblage B() { let a = a; a })");
  EXPECT_EQ(elaboration_->names(assemblage("A")).top(), (NamesBelow{"a", "b"}));
  EXPECT_EQ(model_of(assemblage("B"), *elaboration_).pages.size(), 1U);
}

TEST_F(Elaborated, WhatManyWaysLeadToIsAskedForItsTypeOnce) {
  std::string text = "assemblage A() {\n";
  constexpr int kMany = 60;
  for (int i = 0; i < kMany; ++i) text += fmt::format("let x{0} = delay(x{1}, initial = x{1});\n", i, i + 1);
  for (int i = 0; i < kMany; ++i)
    text += fmt::format("{} B{}() {{ select by x {{ case 1: B{}(); case 2: B{}(); }}\n",
                        i == 0 ? "x0 }\nassemblage" : "}\nassemblage", i, i + 1, i + 1);
  read(text + "}");
  const OwnerModel lets = model_of(assemblage("A"), *elaboration_);
  EXPECT_EQ(lets.type_of(*assemblage("A").body).type, nullptr);
  EXPECT_EQ(elaboration_->types().result_of(assemblage("B0")).type, nullptr);
}

TEST_F(Elaborated, WhatStandsDeeperThanAnythingMayHasNoName) {
  std::string text = "assemblage A() {\n";
  constexpr int kMany = 20'000;
  for (int i = 0; i < kMany; ++i)
    text += "let x" + std::to_string(i) + " = Not(x" + std::to_string(i + 1) + ");\n";
  read(text + "x0 }");
  const Assemblage& deep = assemblage("A");
  EXPECT_EQ(elaboration_->names(deep).of(deep.lets[1]), "x1");
  EXPECT_EQ(model_of(deep, *elaboration_).pages.front().nodes.size(), static_cast<std::size_t>(kMany));
}

}  // namespace
}  // namespace mlab::cdl
