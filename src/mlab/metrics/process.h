#pragma once

#include "mlab/metrics/exposition.h"

namespace mlab::metrics {

/// `process_cpu_seconds_total`, `process_resident_memory_bytes`, `process_virtual_memory_bytes`,
/// `process_open_fds`, `process_start_time_seconds`, as far as the system tells.
void tell_process(Exposition& out);

}  // namespace mlab::metrics
