#pragma once

#include <string>

#include "mlab/cli/batch_study.h"
#include "mlab/study/batch.h"
#include "mlab/study/failure_recordings.h"
#include "mlab/study/summary.h"

namespace mlab::cli {

/// Says what is wrong with how `mlab batch` was called. @return  the exit status
int wrong_batch_usage(const std::string& message);

/// Whether what is to be written can be, and is nothing that is read; else it is told.
/// @param study_file  empty: the batch is defined by options
/// @param results     empty: runs are kept nowhere
bool outputs_are_usable(const study::Definition& definition, const std::string& study_file,
                        const std::string& results);

/// Records failures where the definition wants them; what went wrong is told.
/// @param kept  as study::record_failures
study::FailureRecordings deliver_recordings(const study::Batch& batch, study::Summary& summary,
                                            const study::Definition& definition, const study::Plan& plan,
                                            const Scenes& scenes, study::Keeper* kept);
/// Writes table and page, and says where all is.
/// @return  false: something could not be written, which is told
bool deliver_all(const study::Batch& batch, const study::Summary& summary,
                 const study::FailureRecordings& recordings, const study::Definition& definition,
                 const study::Plan& plan, const std::string& title);

}  // namespace mlab::cli
