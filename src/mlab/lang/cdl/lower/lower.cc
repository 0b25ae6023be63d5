#include "mlab/lang/cdl/lower/lower.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/lowering.h"
#include "mlab/lang/cdl/lower/static_check.h"
#include "mlab/lang/cdl/lower/tests.h"

namespace mlab::cdl {

LoweredRobot lower(const Configuration& configuration, const Robot& robot, const flow::Library& library,
                   text::Diagnostics& sink, Said& said) {
  const std::size_t errors_before = sink.error_count();
  StaticCheck statics(configuration, library, sink);
  statics.errors_of(robot);
  LoweredRobot out = Lowering(configuration, library, sink, said).robot(robot);
  if (sink.error_count() == errors_before) statics.warnings_of(robot);
  return out;
}

std::shared_ptr<const flow::Program> build(const LoweredRobot& robot, const flow::Library& library,
                                           text::Diagnostics& sink, Said& said) {
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
                        text::Diagnostics& sink, Said& said) {
  StaticCheck statics(configuration, library, sink);
  for (const Assemblage* assemblage : configuration.own_assemblages) {
    statics.errors_of(*assemblage);
    Lowering(configuration, library, sink, said).check_assemblage(*assemblage);
  }
  for (const RobotClass* robot_class : configuration.own_classes) {
    const std::size_t errors_before = sink.error_count();
    statics.errors_of(*robot_class);
    Lowering(configuration, library, sink, said).check_class(*robot_class);
    if (sink.error_count() > errors_before) said.wrong_classes.insert(robot_class->name.text);
  }
  for (const SocietyOperator* op : configuration.own_operators)
    Lowering(configuration, library, sink, said).check_operator(*op);
  for (const Society* society : configuration.own_societies) statics.errors_of(*society);
}

void warn_of_declarations(const Configuration& configuration, const flow::Library& library,
                          text::Diagnostics& sink) {
  StaticCheck statics(configuration, library, sink);
  for (const Assemblage* assemblage : configuration.own_assemblages) statics.warnings_of(*assemblage);
}

void check(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink) {
  Said said;
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
