#pragma once

#include <functional>
#include <optional>

#include "mlab/history/recorder.h"
#include "mlab/run/mission_run.h"
#include "mlab/run/report.h"
#include "mlab/study/definition.h"
#include "mlab/study/row.h"

namespace mlab::study {

/// Carries a run out from its start to its end, as fast as it goes and without a person: as
/// `mlab run --headless --proceed` does where standard input has ended.
/// @param wants_end  asked in each cycle: the run is given up
/// @param recorder   writes it down; null: nobody does
/// @return  nothing where it was given up
std::optional<run::RunEnd> carry_out(run::MissionRun& run, const Definition& definition,
                                     const std::function<bool()>& wants_end,
                                     history::Recorder* recorder = nullptr);

/// What is kept of a run that has ended, but for who it was.
Row row_of(const run::MissionRun& run, run::RunEnd end, const Definition& definition);

/// Of a run that could not be made.
Row row_of_none(const std::string& why);

}  // namespace mlab::study
