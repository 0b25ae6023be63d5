#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mlab/flow/behavior.h"

/// The descriptors of all procedures of the component library, for flow::Library::add.
std::span<const mlab::flow::Behavior* const> mlab_library_behaviors();

namespace mlab::library {

/// A robot that the languages know by name: a network of the library's procedures.
struct Robot {
  std::string_view name;  ///< `standard`
  std::string_view file;  ///< for messages: `standard.cnl`
  std::string_view text;  ///< in CNL
};

/// The robot of that name, or of the name of a historic robot program that it stands for, letter case aside:
/// the stock robots of the mission language all mean the standard robot. Nothing where nobody answers to the
/// name.
std::optional<Robot> find_robot(std::string_view name);

/// A configuration of the library: binding points, assemblages, robots. Known to every configuration without
/// `use`.
struct ConfigurationText {
  std::string_view file;  ///< for messages: `library/assemblages/wander.cdl`
  std::string_view text;  ///< in CDL
};

/// All of them, in alphabetical order of their files.
std::span<const ConfigurationText> configuration_texts();

}  // namespace mlab::library
