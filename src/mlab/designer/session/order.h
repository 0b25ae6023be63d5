#pragma once

#include "mlab/console/order_table.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/session/core.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// Who may send a message, which texts it needs, and what takes it.
struct Order {
  enum class From { kAnybody, kGreeted };
  /// Whether what follows from changed texts is there before the message is taken: letters that are typed one
  /// after the other need not wait for it.
  enum class Needs { kNothing, kModels };
  using Table = console::OrderTable<DesignerCore, Sender, ToDesigner, Answer, Answered>;

  From from = From::kAnybody;
  Needs needs = Needs::kNothing;
  Table::Take take = nullptr;  ///< null: the message says nothing

  /// The one table of all messages.
  static Order of(ToDesigner::BodyCase body);
};

}  // namespace mlab::designer
