// What may be connected is one notion: the checker, the designer and the completion say the same of every
// pair of a parameter and an input that there can be.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/assist/component.h"
#include "mlab/designer/drawing/components.h"
#include "mlab/lang/cdl/types/port_type.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab {
namespace {

// Each type with each unit that something of the library gives or takes, and where it is taken.
struct Table {
  std::map<std::pair<std::string, std::string>, cdl::PortType> types;
  std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>> takers;

  Table() {
    for (const flow::Behavior* behavior : robot::component_library().behaviors()) {
      add(behavior->output, behavior->output_unit);
      for (const flow::Input& input : behavior->inputs) {
        add(input.type, input.unit);
        if (input.type == nullptr || input.is_list) continue;
        takers.try_emplace({std::string(input.type->name), std::string(input.unit)},
                           std::string(behavior->name), std::string(input.name));
      }
    }
  }

 private:
  void add(const flow::TypeInfo* type, std::string_view unit) {
    if (type == nullptr) return;
    types[{std::string(type->name), std::string(unit)}] = {type, std::string(unit)};
    if (type->kind != flow::TypeKind::kReal) return;
    for (const char* other : {"m", "rad", "deg", "s", "m/s"})
      types[{std::string(type->name), other}] = {type, other};
  }
};

cdl::Misfit said_by_the_checker(const cdl::PortType& have, const std::string& component,
                                const std::string& input) {
  const std::string unit = have.unit.empty() ? "" : fmt::format(" [{}]", have.unit);
  const std::string text = fmt::format("assemblage Pair(value: {}{}) {{\n  {}({} = value)\n}}\n", have.name(),
                                       unit, component, input);
  text::Diagnostics sink;
  robot::check_configuration(std::make_shared<const text::Source>("pair.cdl", text), {}, sink);
  for (const text::Diagnostic& one : sink.items()) {
    EXPECT_NE(one.kind, "syntax") << text << text::render(sink);
    if (one.kind == "wrong-type" && one.place.span.begin > text.find(" = value")) return cdl::Misfit::kType;
    if (one.kind == "wrong-unit" && one.place.span.begin > text.find(" = value")) return cdl::Misfit::kUnit;
  }
  return cdl::Misfit::kNone;
}

TEST(Fits, IsTheSameForTheCheckerTheDesignerAndTheCompletion) {
  const Table table;
  EXPECT_GT(table.types.size(), 20U);
  EXPECT_GT(table.takers.size(), 20U);
  std::map<cdl::Misfit, int> seen;
  for (const auto& [wanted, taker] : table.takers) {
    for (const auto& [name, have] : table.types) {
      const cdl::PortType& want = table.types.at(wanted);
      const cdl::Misfit misfit = cdl::misfit(have, want);
      ++seen[misfit];
      const std::string pair = fmt::format("{} [{}] where {}.{} takes {} [{}]", have.name(), have.unit,
                                           taker.first, taker.second, want.name(), want.unit);
      EXPECT_EQ(said_by_the_checker(have, taker.first, taker.second), misfit) << pair;
      EXPECT_EQ(designer::why_not(have, want).empty(), misfit == cdl::Misfit::kNone) << pair;
      EXPECT_EQ(assist::fits(assist::value_type(have.name(), have.unit),
                             assist::value_type(want.name(), want.unit)),
                misfit == cdl::Misfit::kNone)
          << pair;
    }
  }
  EXPECT_GT(seen[cdl::Misfit::kNone], 30);
  EXPECT_GT(seen[cdl::Misfit::kType], 200);
  EXPECT_GT(seen[cdl::Misfit::kUnit], 20);
}

}  // namespace
}  // namespace mlab
