#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/robot/host/limits.h"
#include "mlab/study/definition.h"
#include "mlab/study/plan.h"
#include "mlab/study/scene.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// The versions of the mission of a batch, ready to be run.
struct Scenes {
  std::vector<std::unique_ptr<study::Scene>> all;  ///< empty where there were errors
  std::uint64_t texts = 0;                         ///< a hash of all that was read
};

/// Reads and builds all that a batch runs.
/// @param plan  of the definition; both outlive the scenes
Scenes scenes_of(const study::Definition& definition, const study::Plan& plan,
                 const cell::Permission& permission, const robot_host::Limits& limits,
                 text::Diagnostics& sink);

/// Where the mission's clock is to begin at no time.
std::optional<text::Diagnostic> wrong_start_time(const study::Definition& definition);

/// All that is wrong with the definition of a batch, and with the mission under its settings.
void check_study(const text::SourcePtr& source, bool without_cell, text::Diagnostics& sink);

}  // namespace mlab::cli
