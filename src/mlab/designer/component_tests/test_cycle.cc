#include "mlab/designer/component_tests/test_cycle.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

#include "mlab/console/published/overview.h"
#include "mlab/console/published/robot_detail.h"
#include "mlab/designer/trial/live_paths.h"
#include "mlab/lang/cdl/lower/tests.h"

namespace mlab::designer {
namespace {

bool stands_in(std::string_view port, std::string_view place) {
  return place.empty() || port == place ||
         (port.size() > place.size() && port.starts_with(place) && port[place.size()] == '.');
}

std::vector<std::string> places_of_page(LoadedFile& file, const component_test::Test& test,
                                        const LookedPage& page) {
  const cdl::Configuration& configuration = file.model->configuration();
  const auto tests = cdl::tests_of(file.model->tree());
  const std::string& name = test.lowered.test->name.text;
  const auto written = std::ranges::find(tests, name, [](const cdl::Test* one) { return one->name.text; });
  if (written == tests.end()) return {};
  const auto robot = file.robots.try_emplace(name, cdl::robot_of(**written, configuration)).first;
  return live_paths(*file.model, robot->second, page.source, page.path);
}

void encode_transitions(const flow::Program& program, const component_test::Moment& moment,
                        std::uint64_t cycle, console::RobotDetail& out) {
  for (const flow::Program::Transit& transit : program.transits(moment.frame.data(), moment.before)) {
    console::RobotDetail::Transition& told = *out.add_transitions();
    const std::vector<std::string>& names = program.state_names(transit.sequence);
    told.set_sequence(console::clean(program.sequence_name(transit.sequence)));
    told.set_from(console::clean(names[transit.from]));
    told.set_index(transit.way);
    told.set_to(console::clean(names[transit.to]));
    told.set_cycle(cycle);
  }
}

}  // namespace

TestCycle test_cycle(LoadedFile& file, const component_test::Test& test, std::uint64_t cycle,
                     const LookedPage& page, const std::function<bool()>& is_stopped) {
  TestCycle out;
  const component_test::Outcome whole = component_test::run(test, {.is_stopped = is_stopped});
  const bool is_last = cycle >= whole.cycles;
  const component_test::Outcome at =
      is_last ? whole
              : component_test::run(
                    test, {.last_cycle = std::max<std::uint64_t>(cycle, 1), .is_stopped = is_stopped});
  out.set_cycle(static_cast<std::uint32_t>(at.cycles));
  out.set_cycles(static_cast<std::uint32_t>(whole.cycles));
  const component_test::Moment& moment = at.last;
  const flow::Program& program = *test.program.program;
  if (moment.frame.size() != program.frame_size()) return out;
  const std::vector<std::string> places = places_of_page(file, test, page);
  std::vector<std::uint32_t> ports;
  for (std::uint32_t i = 0; i < program.ports().size(); ++i) {
    const flow::Port& port = program.ports()[i];
    if (std::ranges::none_of(places, [&](const std::string& place) { return stands_in(port.path, place); }))
      continue;
    ports.push_back(i);
    console::encode_port(program, port, *out.add_ports());
  }
  for (const std::string& place : places) out.add_places(console::clean(place));
  console::RobotDetail& values = *out.mutable_values();
  for (const std::string& state : program.active_states(moment.frame.data()))
    values.add_states(console::clean(state));
  const std::vector<std::uint32_t> ran = program.ran(moment.frame.data(), moment.before);
  std::vector<std::uint32_t> told_as(ports.size());
  std::iota(told_as.begin(), told_as.end(), 0);
  console::encode_port_values(program, moment.frame.data(), ran, ports, told_as, values);
  encode_transitions(program, moment, at.cycles, values);
  return out;
}

}  // namespace mlab::designer
