#include "mlab/lang/cdl/lower/lower.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/flattening.h"
#include "mlab/lang/cdl/lower/static_check.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {

LoweredRobot lower(const Configuration& configuration, const Robot& robot, const flow::Library& library,
                   text::Diagnostics& sink, EarlierFindings& said) {
  const std::size_t errors_before = sink.error_count();
  StaticCheck statics(configuration, library, sink);
  statics.errors_of(robot);
  LoweredRobot out = Flattening(configuration, library, sink, said, Purpose::kRun).robot(robot);
  if (sink.error_count() == errors_before) statics.warnings_of(robot);
  return out;
}

std::shared_ptr<const flow::Program> build(const LoweredRobot& robot, const flow::Library& library,
                                           text::Diagnostics& sink, EarlierFindings& said) {
  text::Diagnostics inner;
  auto program = flow::build_program(robot.network, library, inner);
  for (const text::Diagnostic& d : inner.items()) {
    // Sequences were judged as their author wrote them; what is used nowhere is a `let`, and was said there.
    static const std::set<std::string> kSaid = {"no-way-out", "unreachable-state", "unused-node", "no-sink"};
    if (d.severity == text::Severity::kWarning && kSaid.contains(d.kind)) continue;
    const std::string key =
        fmt::format("{} {} {}", d.kind, static_cast<const void*>(d.place.source.get()), d.place.span.begin);
    if (said.keys.insert(key).second) sink.report(d);
  }
  return program;
}

void check_declarations(const Configuration& configuration, const flow::Library& library,
                        text::Diagnostics& sink, EarlierFindings& said) {
  StaticCheck statics(configuration, library, sink);
  const auto check_alone = [&](const auto& declaration) {
    Flattening(configuration, library, sink, said, Purpose::kCheck).declarations().check(declaration);
  };
  for (const Assemblage* assemblage : configuration.own_assemblages) {
    statics.errors_of(*assemblage);
    check_alone(*assemblage);
  }
  for (const RobotClass* robot_class : configuration.own_classes) {
    const std::size_t errors_before = sink.error_count();
    statics.errors_of(*robot_class);
    check_alone(*robot_class);
    if (sink.error_count() > errors_before) said.wrong_classes.insert(robot_class->name.text);
  }
  for (const SocietyOperator* op : configuration.own_operators) check_alone(*op);
  for (const Society* society : configuration.own_societies) statics.errors_of(*society);
}

void warn_of_declarations(const Configuration& configuration, const flow::Library& library,
                          text::Diagnostics& sink) {
  StaticCheck statics(configuration, library, sink);
  for (const Assemblage* assemblage : configuration.own_assemblages) statics.warnings_of(*assemblage);
}

LoweredTest lower(const Configuration& configuration, const Test& test, const flow::Library& library,
                  text::Diagnostics& sink, EarlierFindings& said) {
  const Robot robot = robot_of(test, configuration);
  StaticCheck(configuration, library, sink).errors_of(robot);
  return Flattening(configuration, library, sink, said, Purpose::kRun).test(test, robot);
}

void check_tests(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink,
                 EarlierFindings& said) {
  std::map<std::string_view, const Test*> first;
  for (const Test* test : tests_of(*configuration.trees.front())) {
    const auto [it, is_new] = first.try_emplace(test->name.text, test);
    if (!is_new) {
      sink.error("duplicate-declaration", test->name.place,
                 fmt::format("test \"{}\" is declared twice", text::shown(test->name.text)))
          .notes.push_back({"the first is here", it->second->name.place});
      continue;
    }
    const std::size_t errors_before = sink.error_count();
    const LoweredTest lowered = lower(configuration, *test, library, sink, said);
    if (sink.error_count() == errors_before) build({lowered.network, {}}, library, sink, said);
  }
}

void check(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink) {
  EarlierFindings said;
  const std::size_t all_before = sink.error_count();
  check_declarations(configuration, library, sink, said);
  for (const Robot* robot : configuration.own_robots) {
    if (said.wrong_classes.contains(robot->class_name.text)) continue;
    const std::size_t errors_before = sink.error_count();
    const LoweredRobot lowered = lower(configuration, *robot, library, sink, said);
    if (sink.error_count() == errors_before && !sink.has_errors()) build(lowered, library, sink, said);
  }
  check_tests(configuration, library, sink, said);
  if (sink.error_count() == all_before) warn_of_declarations(configuration, library, sink);
}

}  // namespace mlab::cdl
