#pragma once

#include <csignal>
#include <string_view>

namespace mlab::cli {

/// From here on nothing ends, throws or dies of a signal because standard output takes no more: what is
/// written then is dropped, and `output_status` knows. To be called first.
void guard_output();

/// Writes to standard output without keeping anything back. False where nobody takes it, now or before.
bool write_output_now(std::string_view bytes);

/// The status of the process: kFailed in place of kDone where something that was printed did not arrive. Says
/// so, unless the reader has just left.
int output_status(int status);

/// A signal handler sets it: whoever reads standard output and takes nothing is waited for a second longer,
/// no more.
extern volatile std::sig_atomic_t output_hurries;

}  // namespace mlab::cli
