#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/robot/program/robot_program.h"

// What the programs of a command line read and keep, and where.
namespace mlab::cli {

/// Empty where it is not set.
std::string environment_variable(const char* name);
/// Of the installation, or of the build folder: both have the program in bin/.
std::string prefix();
/// Where this is no program of ours, as in Python: to be called before anything else is.
void set_prefix(const std::string& folder);
/// Where overlays are looked for after the mission's own folder.
std::vector<std::string> overlay_folders();
/// The headers for procedures that a mission brings: of the installation, or of the source tree that this was
/// built from. Empty: there are none.
std::string include_root();
/// Where robot programs come from that a file in `folder` names.
robot::ProgramSources program_sources(const std::string& folder, const cell::Permission& permission);
/// Where is kept what is remembered from one start to the next, by the rules of XDG; it may be missing. Empty
/// where there is no such place.
std::string state_folder();

/// A file by what names it: an option, or what it is to a command.
struct NamedFile {
  const char* name;
  std::string file;  ///< empty: there is none
};
/// Why these can't be written, as a sentence about the first of which that is so: it is read as well, another
/// one goes to the same place, by whatever name, or no file can be written there. Empty: they can.
std::string problem_with_outputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);
/// Where links lead, also to what is not there yet.
std::filesystem::path target_of(const std::string& path);
/// Why the file can't be written, or made where it is not there: `there is no folder `out``. Empty: it can.
std::string why_not_writable(const std::string& path);
/// Writes the whole file, or leaves what was there: the text goes to a new file beside it, which then takes
/// its name. What is no file, as a pipe, is written as it is; whoever reads it is waited for.
/// @param gives_up  once it is true, who reads a pipe is waited for a second longer, no more
bool write_file(
    const std::string& path, const std::string& text,
    const std::function<bool()>& gives_up = [] { return false; });
/// `: No space left on device`, right after it could not; empty where the system gave no reason.
std::string why_not_written();

}  // namespace mlab::cli
