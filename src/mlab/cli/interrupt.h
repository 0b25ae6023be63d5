#pragma once

namespace mlab::cli {

/// Whether somebody wants an end: Ctrl-C, `kill`, the end of the terminal.
bool was_interrupted();

/// To be called by a handler of such signals. The first Ctrl-C ends everything in an orderly way; who presses
/// it again wants out at once: then it does not return.
void note_interrupt();

/// From here on Ctrl-C, `kill` and the end of the terminal are noted, and end nothing by themselves.
void note_interrupts();

}  // namespace mlab::cli
