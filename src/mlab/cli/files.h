#pragma once

#include <string>

#include "mlab/assist/service.h"
#include "mlab/cell/permission.h"
#include "mlab/cli/places.h"
#include "mlab/robot/executable/executable.h"

namespace mlab::cli {

/// What robot executables are made with, of the installation or of what mlab was built from.
robot_build::Toolchain toolchain();
/// The component library's texts: of the installation, or of what it was built from.
std::string library_folder();
/// What stands beside a text that is checked or edited.
assist::Surroundings surroundings(const cell::Permission& permission);
/// The web client of the operator console, and the missions that come with mlab: of the installation, or of
/// what it was built from.
std::string web_folder();
/// Why there is no web client to hand out, in lines for a person; empty where there is one.
std::string why_web_is_missing();
std::string example_folder();

}  // namespace mlab::cli
