#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mlab::cell {

/// What a program may do in its cell. Whatever is not named here it may not: no network, no signals to
/// others, no look into other processes, no change of owners, modes or times of files, no new processes or
/// threads.
struct Policy {
  /// Files, and folders with all that is in them, that it may read and load code from. Those that are not
  /// there are left out.
  std::vector<std::string> readable;
  /// Files, and folders with all that is in them, that it may become (`exec`); they are readable, too.
  std::vector<std::string> executable;
  /// Folders that it may change: make, write, rename and remove files and folders in them. They have to
  /// exist.
  std::vector<std::string> writable;

  std::uint64_t memory = std::uint64_t{512}
                         << 20;  ///< address space of each of its processes [bytes]; 0: any
  std::uint64_t file_size = std::uint64_t{1} << 30;  ///< of each file that it writes [bytes]
  unsigned open_files = 64;                          ///< descriptors at a time
  std::optional<unsigned> processor_time;            ///< of each of its processes [s]
  bool may_start_processes = false;                  ///< compilers: g++ starts cc1plus, as and ld
  bool may_start_threads = false;                    ///< linkers: mold
};

/// The files that this very process was loaded from: its libraries, the loader, and the loader's list of
/// where libraries are. What is linked with nothing else needs no more to run.
std::vector<std::string> own_libraries();

/// The loader that this process was started by (`/lib64/ld-linux-x86-64.so.2`); empty: it has none.
std::string own_loader();

/// For one executable that is linked with libraries of ours: it, its loader and its libraries, and nothing
/// else.
Policy policy_for(const std::string& executable);

}  // namespace mlab::cell
