#pragma once

#include <atomic>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "mlab/console/inbox.h"
#include "mlab/designer/designer.h"
#include "mlab/designer/session/answers.h"
#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/comparisons.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/desk_texts.h"
#include "mlab/designer/session/document_orders.h"
#include "mlab/designer/session/fields.h"
#include "mlab/designer/session/mark_keeper.h"
#include "mlab/designer/session/name_orders.h"
#include "mlab/designer/session/publisher.h"
#include "mlab/designer/session/questions.h"
#include "mlab/designer/session/safekeeping.h"
#include "mlab/designer/session/start_page.h"
#include "mlab/designer/session/test_orders.h"
#include "mlab/designer/session/trials.h"
#include "mlab/designer/trial/compiler.h"
#include "mlab/project/project_texts.h"

namespace mlab::designer {

/// The designer's thread, and what stands on it. A member knows only those that stand above it; where one has
/// to call down, the core hands it a function.
class DesignerCore {
 public:
  DesignerCore(DesignerSettings settings, Designer::Send send);
  ~DesignerCore();
  DesignerCore(const DesignerCore&) = delete;
  DesignerCore& operator=(const DesignerCore&) = delete;

  // ---- from any thread, as Designer

  void receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message);
  void closed(console::ConnectionId connection);
  std::vector<std::string> end();

 private:
  friend struct Order;  // which of these takes a message

  void work();
  void take(console::ConnectionId from, const ToDesigner& message);
  void greet(const Sender& sender, const Greeting& greeting, Answer& out);
  /// Tells everybody what follows from what has been done, and answers.
  void tell();
  void look_at_disk();
  /// Gives the compiler all texts that have changed.
  void start_compilations();
  robot::ProgramSources programs() const;
  DocumentOrders::Keepers keepers();

  const DesignerSettings settings_;
  std::atomic<bool> ends_ = false;
  std::stop_source jobs_end_;  // stops a C++ compiler that this thread waits for
  double last_look_ = 0.0;     // at the files
  const std::shared_ptr<console::Inbox> inbox_ =
      std::make_shared<console::Inbox>();  // also of who answers later

  Desk desk_;
  Clients clients_;
  Answers answers_;
  StartPage start_page_;
  DeskTexts open_texts_;
  project::ProjectTexts texts_;
  NameOrders name_orders_;
  Questions questions_;
  Comparisons comparisons_;
  Trials trials_;
  Fields fields_;
  MarkKeeper marks_;
  TestOrders test_orders_;
  Safekeeping keeping_;
  DocumentOrders document_orders_;
  Publisher publisher_;
  Compiler compiler_;  // posts to the inbox
  std::thread thread_;
};

}  // namespace mlab::designer
