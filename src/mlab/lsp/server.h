#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "mlab/assist/search.h"
#include "mlab/assist/service.h"
#include "mlab/cell/permission.h"
#include "mlab/lsp/workspace.h"

namespace mlab::lsp {

/// What the server is told by who starts it.
struct Options {
  std::string version;
  assist::Surroundings around;  ///< its `files` are those under the open ones
  /// Where the texts of the component library are as files; empty: nowhere.
  std::string library_folder;
  /// Whether C++ in texts may be compiled where the editor trusts the folder, and where it doesn't.
  std::function<cell::Permission(bool is_trusted)> permission = nullptr;
  /// Asked now and then while a request is answered: whether it was cancelled. Its id as JSON.
  std::function<bool(const std::string& id)> is_cancelled = nullptr;
};

/// A language server, without input and output: one message in, messages out. Never throws on what it is
/// told.
class Server {
 public:
  using Send = std::function<void(const std::string& message)>;
  /// @param send  takes whole messages, in JSON without a frame
  Server(Options options, Send send);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// One message as it came.
  void receive(std::string_view message);
  /// Something that came was no message.
  void refuse(const std::string& why);

  /// A text whose faults are to be found, with all that it is read with, as it stands now.
  struct Check {
    std::string uri;
    assist::Text text;
    assist::Surroundings around;
  };
  /// Some text has changed since its faults were told.
  bool has_work() const;
  /// One of those texts; nothing where there is none.
  std::optional<Check> next_check();
  /// What `assist::problems` found of it, on whatever thread. Nobody is told where the text has changed
  /// meanwhile.
  void tell(const Check& check, text::Diagnostics problems);

  bool is_over() const { return is_over_; }
  /// As the protocol says: 0 where `shutdown` came before `exit`.
  int exit_status() const { return was_shut_down_ ? 0 : 1; }

 private:
  using Json = nlohmann::json;
  struct Document;
  class Locations;
  struct Failure;

  void dispatch(const Json& message);
  Json answer(const std::string& method, const Json& params);
  void notice(const std::string& method, const Json& params);
  Json initialize(const Json& params);

  void open(const Json& params);
  void change(const Json& params);
  void save(const Json& params);
  void close(const Json& params);
  void files_changed();

  Json completion(const Json& params);
  Json hover(const Json& params);
  Json signature_help(const Json& params);
  Json definition(const Json& params);
  Json references(const Json& params);
  Json prepare_rename(const Json& params);
  Json rename(const Json& params);
  Json document_symbols(const Json& params);
  Json workspace_symbols(const Json& params);
  Json folding_ranges(const Json& params);
  Json inlay_hints(const Json& params);
  Json formatting(const Json& params);
  Json code_actions(const Json& params);
  Json semantic_tokens(const Json& params);

  Document& document(const Json& params);
  Check check_of(Document& document, bool checks_code) const;
  std::uint32_t cursor(const Document& document, const Json& params) const;
  std::string uri_for(const text::SourcePtr& source) const;
  std::string file_of(const text::SourcePtr& source) const;
  std::vector<assist::Text> all_texts();
  assist::Surroundings surroundings() const;
  /// The same with all texts of the project; for this thread only.
  assist::Surroundings project();
  bool is_cancelled();
  Json document_edit(const assist::Change& change, const std::string& annotation) const;
  void show(const std::string& message);
  static Json diagnostic_json(const Document& document, const text::Diagnostic& diagnostic,
                              Locations& locations);
  void send(const Json& message);
  void respond_error(const Json& id, int code, const std::string& message);

  Options options_;
  Send send_;
  std::map<std::string, std::unique_ptr<Document>> documents_;  ///< by URI
  Workspace workspace_;
  assist::ProjectIndex index_;
  std::string answering_;  // id of the request that is being answered, as JSON
  bool was_cancelled_ = false;
  bool is_initialized_ = false;
  bool was_shut_down_ = false;
  bool is_over_ = false;
  bool takes_snippets_ = false;
  bool takes_versions_ = false;     // edits that say of which version of a text
  bool takes_annotations_ = false;  // edits that ask to be looked at first
};

/// Reads messages from a file and writes answers until it is over.
/// @param write  at once; false: nobody takes them any more, and it is over
/// @return  the exit status
int serve(Options options, int input, const std::function<bool(std::string_view)>& write);

}  // namespace mlab::lsp
