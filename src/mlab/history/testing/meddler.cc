#include "mlab/history/testing/meddler.h"

#include <string>

namespace mlab::history::testing {

namespace event = mission::event;

void Meddler::meddle() {
  run::MissionRun& run = written_.run();
  switch (below(14)) {
    case 0:
      run.post(event::Pause{});
      break;
    case 1:
      run.post(event::Resume{});
      break;
    case 2:
      run.post(event::Jump{static_cast<std::uint32_t>(below(9))});
      break;
    case 3:
      run.post(event::SingleStep{});
      break;
    case 4:
      written_.type("UNIT scouts-1 MOVETO " + std::to_string(100 + below(300)) + " 200 FORMATION Line");
      break;
    case 5:
      written_.type("ROBOT 2 MOVETO 300 " + std::to_string(below(300)));
      break;
    case 6:
      written_.type("OBSTACLE " + std::to_string(below(400)) + " " + std::to_string(below(400)) + " 3");
      break;
    case 7:
      written_.type("UNIT <extra" + std::to_string(extra_++) + "> ROBOT");
      break;
    case 8:
      run.set_emergency_stop(!run.is_stopped());
      break;
    case 9:
      run.set_parameter({1}, "base_velocity", std::to_string(1 + below(5)));
      break;
    case 10:
      run.set_stands_still_for_operator(below(2) == 0);
      break;
    case 11:
      steer(run);
      break;
    case 12:
      run.edit(written_.edited("FORMATION Wedge", below(2) == 0 ? "FORMATION Column" : "FORMATION Line"));
      break;
    default:
      run.post(event::Execute{});
  }
  // Somebody always says yes.
  if (!run.state().questions.empty()) run.post(event::Answer{run.state().questions.front().id, true});
}

void Meddler::steer(run::MissionRun& run) {
  mission::UnitCommand order;
  order.task = mission::Task::kTeleoperate;
  order.unit = mission::kNoUnit;
  order.robots = {{3}};
  order.goal = {200.0, 100.0};
  run.post(event::Typed{{order}});
  if (below(3) == 0)
    run.let_go_of_stick({3});
  else
    run.set_joystick({3}, {0.25, -0.5, 0.6, below(2) == 0, false});
}

}  // namespace mlab::history::testing
