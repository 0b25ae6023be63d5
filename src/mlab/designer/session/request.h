#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "mlab/console/server/connection_id.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/desk.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// Whether a request has been answered when it has been taken.
enum class Answered { kNow, kLater };

/// Who is answered later.
struct Asker {
  console::ConnectionId connection;
  std::uint32_t request = 0;  ///< 0: no answer is wanted
};

/// Who made a request. Only as long as the request is being taken.
struct Sender {
  Asker asker;
  Client& client;
};

/// Seconds of a clock that does not go back.
inline double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One that says that all is well.
Answer answer_for(const Asker& asker);
/// @param why  a sentence for a person
void refuse(Answer& out, std::string why);
/// The same, with the problem.
void fail(Answer& out, const text::Diagnostic& why);

/// Where a place of a document's text is drawn. @param model  of that text
void add_location(const Model& model, const std::string& document, text::Span span, Answer& out);

/// The document of a request; null where it is not open, which the answer says then.
OpenConfiguration* opened(Desk& desk, const std::string& path, Answer& out);
/// The document of a request that changes it; null where it can't, which the answer says then.
OpenConfiguration* editable(Desk& desk, const std::string& path, Answer& out);

}  // namespace mlab::designer
