#pragma once

#include "mlab/console.pb.h"
#include "mlab/console/inbox.h"
#include "mlab/console/order_table.h"
#include "mlab/console/session/core.h"
#include "mlab/console/session/request.h"

namespace mlab::console {

/// Who may send a message, when it is done, and what does it.
struct Order {
  enum class From {
    kAnybody,
    kOperator,
    kOperatorEver,  ///< of a recording, too, and at whatever moment he looks
    kOperatorNow,   ///< and only while he sees the run as it is now
  };
  using Table = OrderTable<SessionCore, Sender, ToServer, Reply, Answered>;

  From from = From::kAnybody;
  Inbox::Kind when = Inbox::Kind::kAfterCycle;
  Table::Take take = nullptr;  ///< null: it is no request of somebody who has been taken in
  bool answers_later = false;  ///< where it does not answer with an error

  /// The one table of all messages.
  static Order of(ToServer::BodyCase body);
  /// Of this message: what it holds may make a difference.
  static Inbox::Kind kind_of(const ToServer& message);
  /// What it does is in the journal before it is answered.
  static bool is_to_be_kept(const ToServer& message);
  static bool is_for_operator(const ToServer& message);
};

}  // namespace mlab::console
