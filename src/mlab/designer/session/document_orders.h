#pragma once

#include <functional>
#include <string>

#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// What people ask of documents: opening, changing, undoing, saving, closing. What follows from a text's
/// change nobody here has to bring about.
class DocumentOrders {
 public:
  /// Who keeps something of a document by its name.
  struct Keepers {
    std::function<void(const OpenConfiguration& document)> opened;
    std::function<void(const std::string& from, const std::string& to)> renamed;
    std::function<void(const std::string& document)> gone;  ///< nothing of it stays
  };
  DocumentOrders(Desk& desk, Clients& clients, Keepers keepers)
      : desk_(desk), clients_(clients), keepers_(std::move(keepers)) {}

  void open(const Sender& sender, const Open& request, Answer& out);
  void close(const Sender& sender, const Close& request);
  void discard(const Sender& sender, const Discard& request, Answer& out);
  void save(const Save& request, Answer& out);
  void reload(const Reload& request, Answer& out);
  void list_files(const ListFiles& request, Answer& out);

  void edit_text(const EditText& request, Answer& out);
  void edit(const Edit& request, Answer& out);
  void undo(const Undo& request, Answer& out);
  void redo(const Redo& request, Answer& out);
  void copy(const Copy& request, Answer& out);

 private:
  void leave(Client& client, const std::string& document);

  Desk& desk_;
  Clients& clients_;
  const Keepers keepers_;
};

}  // namespace mlab::designer
