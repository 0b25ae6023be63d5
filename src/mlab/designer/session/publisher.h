#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/comparisons.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/mark_keeper.h"
#include "mlab/designer/session/safekeeping.h"
#include "mlab/designer/session/start_page.h"
#include "mlab/designer/session/test_orders.h"

namespace mlab::designer {

/// What people are told of what they look at: all of it when they begin to, and from then on what has
/// changed. Nobody has to say that something has: each topic has a version, which follows from what it shows.
class Publisher {
 public:
  struct Parts {
    Desk& desk;
    Clients& clients;
    const StartPage& start_page;
    const MarkKeeper& marks;
    const TestOrders& tests;
    const Comparisons& comparisons;
    const Safekeeping& keeping;
  };
  explicit Publisher(const Parts& parts) : from_(parts) {}

  /// Tells one who has just come.
  void greet(console::ConnectionId to);
  /// Tells everybody what has changed.
  void publish();

 private:
  /// What was told of something last.
  struct LastMessage {
    std::optional<std::string> version;
    std::string bytes;
    std::uint64_t round = 0;  ///< in which it was looked at last
  };
  /// What was told of a document since it was opened.
  struct Opening {
    std::map<std::string, LastMessage> topics;
    std::optional<std::uint64_t> file_news;  ///< OpenConfiguration::file_news
    std::uint32_t taken_over = 0;            ///< documents::Document::taken_over
  };
  struct Browser {
    std::uint64_t lists = 0;                    ///< Desk::lists_number
    std::string not_kept;                       ///< Safekeeping::why_not
    std::map<std::uint64_t, Opening> openings;  ///< by Client::opening_of
  };
  /// A document that somebody looks at.
  struct View {
    console::ConnectionId to;
    const Client& client;
    const OpenConfiguration& document;
    Opening& told;
  };

  void publish_to(console::ConnectionId to, const Client& client);
  void publish_file(const View& view) const;
  void publish_document(const View& view) const;
  void publish_pages(const View& view) const;
  void publish_tests(const View& view) const;
  void publish_differences(const View& view) const;
  /// Sends the message where the topic's version is another one than was told last, and says something else.
  /// @param version  nothing: the message is made, and compared
  void tell(const View& view, const std::string& topic, const std::optional<std::string>& version,
            const std::function<void(FromDesigner& out)>& write) const;
  Document document_message(const OpenConfiguration& document) const;
  void add_found_problems(const OpenConfiguration& document, Document& out) const;

  const Parts from_;
  std::map<console::ConnectionId, Browser> browsers_;
  std::uint64_t round_ = 0;
};

}  // namespace mlab::designer
