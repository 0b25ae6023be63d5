#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mlab/study/shared_results.h"

namespace mlab::cli {

/// A variable of the environment; nothing where it is not set.
using Variables = std::function<std::optional<std::string>(const char* name)>;
Variables environment();

/// Which of several processes this one is that were started to do one thing together, by Open MPI's or
/// another `mpirun`, Slurm's `srun`, or as tasks of a Slurm array. Alone where nothing says so.
study::Share share_from(const Variables& variables);
/// `1/3`, `none`. @return  nothing: it is no such thing
std::optional<study::Share> share_in(const std::string& text);

}  // namespace mlab::cli
