// What the model of a configuration calls its nodes is what the networks have that are made of it.

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "configurations.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/naming.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab {
namespace {

using cdl::NodeNames;

/// Asks the model what every node of a robot is called, down through all that it calls. Goes through the tree
/// in no particular order: that of the names is the model's business.
class AllNames {
 public:
  AllNames(const cdl::Elaboration& elaboration, const cdl::Robot& robot)
      : elaboration_(elaboration), devices_(elaboration.devices(robot)) {
    Instance own{&elaboration.names(robot), "", &robot.lets, {}, {}};
    for (const cdl::Drive& drive : robot.drives) {
      add(*drive.value, own);
      const std::string& path = own.names->of(drive);
      if (path.empty()) continue;
      const cdl::Device& device = *cdl::actuator_for(devices_, drive.binding.text).use->device;
      const auto binding = configuration().bindings.find(device.binds.text);
      const bool is_named = binding != configuration().bindings.end() && !binding->second->parameters.empty();
      add(device, path, {}, {is_named ? binding->second->parameters.front().name.text : ""});
    }
  }

  std::set<std::string> all;

 private:
  struct Instance {
    const NodeNames* names;
    std::string path;
    const std::vector<cdl::Let>* lets;
    std::set<const cdl::Let*> read;
    std::map<const cdl::Expression*, std::size_t> times;  // that its names were asked for
  };

  const cdl::Configuration& configuration() const { return elaboration_.configuration(); }

  void add(const cdl::Expression& expression, Instance& in) {
    const NodeNames::Paths& paths = in.names->of(expression, in.times[&expression]++);
    if (!paths.behind.empty()) all.insert(cdl::joined_path(in.path, paths.behind));
    if (const auto* name = std::get_if<cdl::Name>(&expression.what)) read(name->name.text, in);
    if (const auto* sequence = std::get_if<cdl::Sequence>(&expression.what)) {
      for (const cdl::State& state : sequence->states) {
        if (state.member) add(*state.member, in);
        for (const cdl::Transition& one : state.transitions) add(cdl::condition_of(*one.trigger), in);
      }
      if (expression.active) add(*expression.active, in);
    } else {
      cdl::for_each_part(expression, [&](const cdl::Expression& part) { add(part, in); });
    }
    if (expression.active) all.insert(cdl::joined_path(in.path, paths.path));
    if (cdl::default_name(expression).empty()) return;
    const std::string path = cdl::joined_path(in.path, paths.inside);
    if (const auto* call = std::get_if<cdl::Call>(&expression.what))
      add(expression, *call, path, in);
    else
      all.insert(path);
  }

  void read(const std::string& name, Instance& in) {
    for (const cdl::Let& let : *in.lets) {
      if (let.name.text == name && in.read.insert(&let).second) add(*let.value, in);
    }
  }

  void add(const cdl::Expression& expression, const cdl::Call& call, const std::string& path, Instance& in) {
    const cdl::NamesBelow& taken = in.names->below(expression);
    if (const auto binding = configuration().bindings.find(call.callee.text);
        binding != configuration().bindings.end()) {
      const std::vector<cdl::Parameter>& parameters = binding->second->parameters;
      const std::vector<bool> given = cdl::given_parameters(call, parameters);
      std::vector<std::string> asked;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        asked.push_back(parameters[i].name.text);
        if (!given[i] && parameters[i].initial) add(*parameters[i].initial, in);
      }
      add(*cdl::device_for(devices_, call.callee.text).use->device, path, taken, asked);
    } else if (const cdl::Assemblage* called = configuration().assemblage_named(call.callee)) {
      add(*called, cdl::given_parameters(call, called->parameters), path, taken);
    } else {
      all.insert(path);
    }
  }

  void add(const cdl::Device& device, const std::string& path, const cdl::NamesBelow& taken,
           const std::vector<std::string>& asked) {
    static const std::vector<cdl::Let> kNoLets;
    Instance in{&elaboration_.names(device, taken), path, &kNoLets, {}, {}};
    for (const cdl::Argument& argument : device.by.arguments) add(*argument.value, in);
    const cdl::Assemblage* called = configuration().assemblage_named(device.by.callee);
    if (called == nullptr) {
      all.insert(path);
      return;
    }
    cdl::Call call = device.by;
    for (const std::string& name : asked) call.arguments.push_back({{name, {}}, nullptr});
    add(*called, cdl::given_parameters(call, called->parameters), path, in.names->top());
  }

  void add(const cdl::Assemblage& assemblage, const std::vector<bool>& given, const std::string& path,
           const cdl::NamesBelow& taken) {
    Instance in{&elaboration_.names(assemblage, given, taken), path, &assemblage.lets, {}, {}};
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (!given[i] && assemblage.parameters[i].initial) add(*assemblage.parameters[i].initial, in);
    }
    if (assemblage.body)
      add(*assemblage.body, in);
    else
      all.insert(path);
  }

  const cdl::Elaboration& elaboration_;
  const std::vector<cdl::DeviceUse>& devices_;
};

std::vector<std::string> without(const std::set<std::string>& all, const std::set<std::string>& others) {
  std::vector<std::string> out;
  std::ranges::set_difference(all, others, std::back_inserter(out));
  return out;
}

// How many robots were compared.
int compare_names(const text::SourcePtr& source, const std::string& name) {
  int out = 0;
  const designer::Model model(source, robot::library_environment());
  for (const cdl::Robot* one : model.configuration().own_robots) {
    text::Diagnostics said;
    const auto robot = robot::configure(source, one->name.text, "", {}, {}, said);
    if (!robot) continue;
    std::set<std::string> lowered;
    for (const flow::Node& node : robot->lowered.network.nodes) lowered.insert(node.name);
    EXPECT_EQ(lowered.size(), robot->lowered.network.nodes.size()) << name << " " << one->name.text;
    const std::set<std::string> told = AllNames(model.components().elaboration(), *one).all;
    EXPECT_EQ(without(told, lowered), std::vector<std::string>()) << "not in the network: " << name;
    EXPECT_EQ(without(lowered, told), std::vector<std::string>()) << "not in the model: " << name;
    ++out;
  }
  return out;
}

TEST(Names, OfTheModelAreThoseOfTheNetworksOfTheProject) {
  int count = 0;
  configurations::for_each_own(
      [&](const text::SourcePtr& source, const std::string& name) { count += compare_names(source, name); });
  EXPECT_GT(count, 10);
}

TEST(Names, OfTheModelAreThoseOfTheNetworksOfTheCorpus) {
  if (!configurations::has_corpus()) GTEST_SKIP() << "no corpus at " << configurations::corpus();
  int count = 0;
  configurations::for_each_imported(
      configurations::corpus(), "corpus",
      [&](const text::SourcePtr& source, const std::string& name) { count += compare_names(source, name); });
  EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace mlab
