#pragma once

#include <memory>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/mission/mission.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::run {

/// What the robots of a mission are made of: the program and the body of each of its types. Making it may
/// take long, since a mission can bring procedures that have to be compiled; so it may be made on any thread.
struct Crew {
  std::shared_ptr<const mission::Mission> mission;  ///< never null
  std::vector<robot::RobotProgram> programs;        ///< by index of Mission::types
  std::vector<binding::BodySpec> bodies;            ///< likewise
};

/// All that was read for it, each once: the mission, its overlays and what these name, the configurations and
/// networks of its programs.
std::vector<text::SourcePtr> texts_of(const Crew& crew);

/// @param before  a program that it has already is not built again; null: none
/// @return null where there were errors, all in `sink`
std::shared_ptr<const Crew> make_crew(std::shared_ptr<const mission::Mission> mission,
                                      const robot::ProgramSources& sources, text::Diagnostics& sink,
                                      const Crew* before = nullptr);

/// The same, with warnings of orders that can't end as they stand (see order_check.h): all that can be said
/// of a mission before it runs.
std::shared_ptr<const Crew> check_crew(std::shared_ptr<const mission::Mission> mission,
                                       const robot::ProgramSources& sources, text::Diagnostics& sink);

}  // namespace mlab::run
