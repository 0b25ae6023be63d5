#pragma once

#include <netinet/in.h>

#include <string>
#include <vector>

// What the harness's own tests run on hosts: each a small program that says what it found on standard output.
namespace mlab::network::talk {

using Words = std::vector<std::string>;

/// PORT: sends back all that comes. Goes on until it is killed.
int echo(const Words& words);
/// HOST PORT COUNT [PATIENCE_MS]: one packet after the other, waits for each to come back; says how many did,
/// and the mean of their round trips [us].
int ask(const Words& words);
/// HOST PORT COUNT PER_SECOND: sends numbers.
int flood(const Words& words);
/// PORT QUIET_MS: takes numbers until its input is closed and then none has come for so long; says how many,
/// how many came after a higher one, how many twice, and a hash of which.
int count(const Words& words);
/// GROUP PORT: joins the group (`-`: no group); says the first packet that comes.
int hear(const Words& words);
/// HOST PORT TEXT: once, to a host, a group or to all.
int say(const Words& words);

/// PORT: takes one connection to its end; says how many bytes it had and their hash.
int take(const Words& words);
/// HOST PORT BYTES: sends so many; says their hash.
int give(const Words& words);

/// FOLDER: writes a file until there is no more room; says how many bytes, and why no more.
int fill(const Words& words);
/// Starts a child that starts a session of its own, and one that does not; goes on until it is killed.
int spawn(const Words& words);
/// FILES...: makes files, and leaves a child behind.
int litter(const Words& words);
/// SECONDS: waits so long by the wall clock, and says how long it took by the monotonic one [ms].
int wait(const Words& words);
/// Says both clocks [ms].
int clocks(const Words& words);
/// BYTES: prints so many to each of its outputs.
int chatter(const Words& words);

/// By name, or as numbers. Ends the program where there is none.
sockaddr_in address(const std::string& host, const std::string& port);
/// Bound to a port of all addresses (0: to none) and with much room for what comes.
int udp_socket(const std::string& port);
[[noreturn]] void give_up(const std::string& what);
/// Prints a line, at once.
void tell(const std::string& text);

}  // namespace mlab::network::talk
