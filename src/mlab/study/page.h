#pragma once

#include <string>

#include "mlab/study/summary.h"

namespace mlab::study {

/// What a page is told besides the batch itself.
struct PageWords {
  std::string title;  ///< of the mission
  std::string file;   ///< that the page will be in: links begin there
  std::string program_version;
};

/// One HTML page with all that a batch says: it needs nothing else, loads nothing, and has no scripts.
std::string page_of(const Batch& batch, const Summary& summary, const Definition& definition,
                    const Plan& plan, const PageWords& words);

}  // namespace mlab::study
