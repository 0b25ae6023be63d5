#pragma once

#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/cell/permission.h"
#include "mlab/robot/executable/executable.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::cli {

/// Empty where it is not set.
std::string environment_variable(const char* name);
/// True where the file exists and may be written, or could be made.
bool is_writable(const std::string& path);
/// Writes the whole file, or leaves what was there: the text goes to a new file beside it, which then takes
/// its name.
bool write_file(const std::string& path, const std::string& text);

/// Where robot programs come from that a file in `folder` names. The headers for procedures that it brings
/// are those of the installation, or of the source tree that mlab was built from.
///
robot::ProgramSources program_sources(const std::string& folder, const cell::Permission& permission);
/// What robot executables are made with, of the installation or of what mlab was built from.
robot_build::Toolchain toolchain();
/// Where overlays are looked for after the mission's own folder.
std::vector<std::string> overlay_folders();
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
/// Where the console keeps what it remembers from one start to the next, by the rules of XDG; it may be
/// missing. Empty where there is no such place.
std::string state_folder();

}  // namespace mlab::cli
