#pragma once

#include <string>

#include "mlab/page/numbers.h"
#include "mlab/study/row.h"

// Numbers as people read them, on terminals and pages.
namespace mlab::study {

using page::brief;
using page::median_and_range;
using page::p_words;
using page::percent;
using page::percents;
using page::signed_number;

/// Of a column: `duration [s]`
std::string heading(const NumberInfo& info);

}  // namespace mlab::study
