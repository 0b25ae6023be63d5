#pragma once

#include <utility>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// Answers on their way: each is sent after everybody has been told what the request has brought about.
class Answers {
 public:
  explicit Answers(Clients& clients) : clients_(clients) {}

  /// Nothing happens where no answer is wanted, or who asked has gone.
  void add(const Asker& to, Answer answer) {
    if (to.request == 0) return;
    FromDesigner message;
    *message.mutable_answer() = std::move(answer);
    waiting_.emplace_back(to.connection, std::move(message));
  }
  void send() {
    for (const auto& [to, answer] : std::exchange(waiting_, {})) {
      if (clients_.find(to) != nullptr) clients_.send(to, answer);
    }
  }

 private:
  Clients& clients_;
  std::vector<std::pair<console::ConnectionId, FromDesigner>> waiting_;
};

}  // namespace mlab::designer
