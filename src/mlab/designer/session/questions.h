#pragma once

#include <cstdint>

#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// What people ask about a document, which changes nothing.
class Questions {
 public:
  explicit Questions(Desk& desk) : desk_(desk) {}

  void ask_language(const AskLanguage& request, Answer& out);
  void describe(const Describe& request, Answer& out);
  void fits(const Fits& request, Answer& out);

 private:
  void find_definition(const OpenConfiguration& document, std::uint32_t cursor, Answer& out);

  Desk& desk_;
};

}  // namespace mlab::designer
