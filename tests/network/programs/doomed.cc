// A test that is killed in its midst: makes hosts, starts processes on them, and says which namespaces there
// are.

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "network/test_network.h"

int main() {
  using namespace mlab::network;
  TestNetwork network({.hosts = {{"alpha"}, {"bravo"}}});
  std::vector<Process> processes;
  for (const auto& host : network.hosts()) {
    processes.push_back(host->start({MLAB_NETWORK_TALK, "spawn"}));
    processes.back().prints("ready", std::chrono::seconds(10));
    fmt::print("{}\n", host->network_namespace());
  }
  fmt::print("all is there\n");
  std::fflush(stdout);
  for (;;) ::pause();
}
