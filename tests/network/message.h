#pragma once

#include <optional>
#include <string>
#include <vector>

#include "descriptor.h"

namespace mlab::network {

/// What a test and the keeper of one of its hosts tell each other, over a SOCK_SEQPACKET socket: words, none
/// of which holds a zero byte, and open files.
struct Message {
  std::vector<std::string> words;
  std::vector<Descriptor> files;
};

/// At most eight of `files` are handed over; the sender keeps its own.
/// @return  why it could not be sent; empty: it was
std::string send_message(int socket, const std::vector<std::string>& words,
                         const std::vector<int>& files = {});

/// Waits for the next one.
/// @return  nothing: the other side has gone
std::optional<Message> receive_message(int socket);

}  // namespace mlab::network
