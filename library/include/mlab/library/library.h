#pragma once

#include <span>
#include <string_view>

#include "mlab/flow/behavior.h"

/// The descriptors of all procedures of the component library, for flow::Library::add.
std::span<const mlab::flow::Behavior* const> mlab_library_behaviors();

namespace mlab::library {

/// The robot of the library's configurations (`Scout`) that a program's name means, letter case aside: its
/// own, or that of a historic robot program that it stands for. Empty where nobody answers to the name.
std::string_view find_robot(std::string_view name);

/// A configuration of the library: binding points, assemblages, robots. Known to every configuration without
/// `use`.
struct ConfigurationText {
  std::string_view file;  ///< for messages: `library/assemblages/wander.cdl`
  std::string_view text;  ///< in CDL
};

/// All of them, in alphabetical order of their files.
std::span<const ConfigurationText> configuration_texts();

}  // namespace mlab::library
