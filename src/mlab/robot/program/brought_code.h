#pragma once

#include <deque>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mlab/flow/library.h"
#include "mlab/lang/cnl/signatures.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/robot.pb.h"
#include "mlab/robot/host/hosted_program.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

/// Procedures that missions and configurations bring along. What they are is read from their text; their code
/// is compiled, and runs in processes of its own, in a cell. None of it is ever loaded into this process.

namespace mlab::robot {

using ProcedureFiles = std::span<const std::shared_ptr<const cnl::Tree>>;

/// The component library, and behind it the procedures of files as their text describes them. A program that
/// is built with them is whole but for their code: it can be checked, drawn and written, and must not be
/// stepped.
struct DescribedLibrary {
  flow::Library library;
  std::deque<cnl::Signatures> signatures;  ///< the library points into them
};
std::unique_ptr<DescribedLibrary> describe_library(ProcedureFiles files);

/// Gives the C++ of the files to the compiler, for its errors and warnings. Nothing is run.
void check_code(ProcedureFiles files, const ProgramSources& sources, text::Diagnostics& sink);

/// `describe_library`, and `check_code` where the sources want it.
std::unique_ptr<DescribedLibrary> checked_library_with(ProcedureFiles files, const ProgramSources& sources,
                                                       text::Diagnostics& sink);

/// The program of a network that processes of its own compute, ready to run: the code of the files'
/// procedures is compiled, and a process was asked what only it knows, how large their state is.
///
/// @param network  has been built with `library`, without errors
/// @param files    whose procedures take part in it; none: it is of the component library's alone
/// @param place    where the mission names the program
/// @return  nothing where there were errors: what the compiler says, `no-cell`, `code-not-allowed`,
/// `cannot-load`
std::optional<BuiltProgram> host_network(const flow::Network& network, ProcedureFiles files,
                                         std::unique_ptr<DescribedLibrary> library, const text::Place& place,
                                         const ProgramSources& sources, text::Diagnostics& sink);

/// The program of an executable that reveals how it is made. Nothing that it says is trusted.
///
/// @param hosted  how it is started
/// @errors  what it did, as a sentence about it
std::expected<BuiltProgram, std::string> host_revealed(const wire::Revealed& revealed,
                                                       robot_host::HostedProgram hosted);

/// A network as a program of this process where all of its behaviors are the component library's, and the
/// sources want no processes; else hosted.
///
/// @param program  of the network, built with `library`
std::optional<BuiltProgram> make_runnable(std::shared_ptr<const flow::Program> program,
                                          const flow::Network& network, ProcedureFiles files,
                                          std::unique_ptr<DescribedLibrary> library, const text::Place& place,
                                          const ProgramSources& sources, text::Diagnostics& sink);

/// The program that hosts robots with brought code: beside this one, or where it is installed; empty: it is
/// not there.
std::string runner_path();

}  // namespace mlab::robot
