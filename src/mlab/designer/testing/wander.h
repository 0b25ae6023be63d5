#pragma once

#include "mlab/designer/testing/drawn_text.h"

namespace mlab::designer::testing {

/// Figure 4 of GIT-COGSCI-95/02, edit by edit on an empty page: it drifts about, around whatever is in the
/// way.
inline void draw_wander(DrawnText& text) {
  text.declare("assemblage", "Wander");
  text.parameter("Wander", "curious", "gain", "0.8");
  text.parameter("Wander", "cautious", "gain", "0.5");
  text.place("Wander", "Noise", 40, 40);
  text.place("Wander", "AvoidStaticObstacles", 40, 160);
  text.place("Wander", "Probe", 40, 320);
  text.place("Wander", "sense_obstacles", -280, 200);
  text.place("Wander", "cooperate", 400, 160);
  text.set("Wander", "Noise", "persistence", "10 s");
  text.set("Wander", "sense_obstacles", "range", "2 m");
  text.connect("Wander", "sense_obstacles", "AvoidStaticObstacles", "readings");
  text.connect("Wander", "AvoidStaticObstacles.sense_obstacles", "Probe", "readings");
  text.set("Wander", "AvoidStaticObstacles", "sphere", "1 m");
  text.set("Wander", "AvoidStaticObstacles", "safety_margin", "0.5 m");
  for (const char* skill : {"Noise", "AvoidStaticObstacles", "Probe"})
    text.connect("Wander", skill, "cooperate", "members");
  text.set("Wander", "cooperate", "weight", "curious", 0);
  text.set("Wander", "cooperate", "weight", "cautious", 1);
  text.set("Wander", "cooperate", "weight", "curious", 2);
  text.connect("Wander", "cooperate", "$result", "");
}

}  // namespace mlab::designer::testing
