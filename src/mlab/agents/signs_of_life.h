#pragma once

#include <chrono>
#include <expected>
#include <memory>
#include <string>
#include <thread>

#include "mlab/dds/participant.h"
#include "mlab/dds/writer.h"

namespace mlab::agents {

/// Has an agent give signs of life for those who have to know soon when it goes: twenty in a second, on the
/// loopback ten. On a thread of its own, so that nothing which keeps the agent busy makes it look dead.
class SignsOfLife {
 public:
  /// They begin with `begin`, and end with this.
  /// @errors  a sentence
  static std::expected<std::unique_ptr<SignsOfLife>, std::string> open(dds::Participant& participant,
                                                                       const dds::Network& network,
                                                                       std::string name);
  SignsOfLife(const SignsOfLife&) = delete;
  SignsOfLife& operator=(const SignsOfLife&) = delete;

  void begin();

 private:
  SignsOfLife(dds::Writer writer, std::string name, std::chrono::milliseconds every);

  dds::Writer writer_;
  std::string name_;
  std::chrono::milliseconds every_;
  std::jthread thread_;
};

}  // namespace mlab::agents
