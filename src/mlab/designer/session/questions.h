#pragma once

#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/name_orders.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// What people ask about a document, which changes nothing.
class Questions {
 public:
  Questions(Desk& desk, NameOrders& names) : desk_(desk), names_(names) {}

  void ask_language(const AskLanguage& request, Answer& out);
  void describe(const Describe& request, Answer& out);
  void fits(const Fits& request, Answer& out);

 private:
  Desk& desk_;
  NameOrders& names_;
};

}  // namespace mlab::designer
