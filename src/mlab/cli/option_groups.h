#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "mlab/cli/commands.h"

// Options that several commands have.
namespace mlab::cli {

// What CLI11 lets through otherwise: -1 and 1e30 as seeds, `nan` as seconds.
inline std::string refuse_unless_whole(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size()
             ? ""
             : fmt::format("{}: expected a whole number from 0 to {}", text,
                           std::numeric_limits<std::uint64_t>::max());
}
inline std::string refuse_unless_positive(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value) && value > 0.0
             ? ""
             : fmt::format("{}: expected a number above 0", text);
}

// A variable of a script that is not set, say.
inline std::string refuse_if_empty(const std::string& text) {
  return text.empty() ? "expected something, and it is empty" : "";
}

inline void add_no_cell(CLI::App* c, bool& no_cell) {
  c->add_flag("--no-cell", no_cell,
              "let code that files bring do all that you may do: for machines that can't make cells");
}

// What the processes of robots with code of their own may use.
inline void add_cell_limits(CLI::App* c, robot_host::Limits& limits) {
  c->add_option_function<std::uint32_t>(
       "--cell-memory",
       [&limits](const std::uint32_t& megabytes) { limits.memory = std::uint64_t{megabytes} << 20; },
       "megabytes that a process with robots of such code may use")
      ->default_str(std::to_string(limits.memory >> 20))
      ->check(CLI::Range(64U, 1U << 24))
      ->type_name("MB");
  c->add_option("--cell-time", limits.cycle, "processor time that such a robot may take for a cycle")
      ->capture_default_str()
      ->check(refuse_unless_positive)
      ->check(CLI::Range(0.01, 86'400.0))
      ->type_name("SECONDS");
  c->add_option("--cell-wait", limits.cycle_wall,
                "time on the clock after which one that sleeps, or an executable, is not waited for any more")
      ->capture_default_str()
      ->check(refuse_unless_positive)
      ->check(CLI::Range(0.01, 86'400.0))
      ->type_name("SECONDS");
}

// What is said of code that files bring.
template <class Options>
void add_cell(CLI::App* c, Options& o) {
  add_no_cell(c, o.no_cell);
  add_cell_limits(c, o.limits);
}

inline void add_network(CLI::App* c, NetworkOptions& o) {
  c->add_option(
       "--network", o.interface_name,
       "the network interface, or its address, that the fleet's other machines are reached by; without, "
       "nothing leaves this machine")
      ->type_name("INTERFACE|ADDRESS");
  c->add_option("--peer", o.peers,
                "address of another machine, where the network carries no multicast; again "
                "for each")
      ->type_name("ADDRESS");
  c->add_option_function<std::string>(
       "--secure",
       [&o](const std::string& folder) {
         o.is_secure = true;
         o.identity = folder;
       },
       "take part in a secured fleet: who can't prove that he belongs to it is neither heard nor told "
       "anything (mlab keys makes the folder; default: this machine's own)")
      ->expected(0, 1)
      ->type_name("FOLDER");
}

// Commands whose options stand beside them.
void add_place(CLI::App& app, PlaceOptions& o);
void add_world(CLI::App& app, WorldOptions& o);

}  // namespace mlab::cli
