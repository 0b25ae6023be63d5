#pragma once

#include <string>

#include "mlab/study/summary.h"

namespace mlab::study {

/// A row for each run, by version, combination and seed, as comma-separated values (RFC 4180: lines end with
/// CR LF, quotes around what needs them). docs/batch.md describes the columns.
std::string csv_of(const Batch& batch, const Summary& summary, const Definition& definition,
                   const Plan& plan);

/// The same rows as JSON, and what they say together.
std::string json_of(const Batch& batch, const Summary& summary, const Definition& definition,
                    const Plan& plan, const std::string& program_version);

}  // namespace mlab::study
