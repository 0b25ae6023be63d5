#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/console/draft_keeper.h"
#include "mlab/console/drafts.h"
#include "mlab/console/project_folder.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/compiler.h"
#include "mlab/designer/drawing.h"
#include "mlab/designer/model.h"
#include "mlab/designer/offered.h"
#include "mlab/designer/open_text.h"
#include "mlab/language/service.h"
#include "mlab/text/files.h"

namespace mlab::designer {

/// The file of a project that holds assemblages for all its configurations.
inline constexpr const char* kProjectLibrary = "library.cdl";

/// A configuration that is open, whoever looks at it.
struct OpenConfiguration {
  std::string path;  ///< its id: as ProjectFolder names it, `library:...`, or `new:1`
  OpenText text;
  std::optional<std::string> saved;  ///< as it stands on disk; nothing: it has no file
  std::optional<std::string> asked;  ///< what stands on disk and was asked about already
  bool is_writable = true;
  std::shared_ptr<Model> model;  ///< of the text as it stands
  std::shared_ptr<Model> drawn;  ///< of the last text without slips of grammar
  std::uint64_t drawn_revision = 0;
  bool is_started = false;                   ///< the model's text has been given to the compiler
  std::shared_ptr<const Compiled> compiled;  ///< of the model's text; null: not yet
  std::shared_ptr<const CheckedCode> code;   ///< of the C++ that was used last; null: none yet
  std::uint64_t compiled_number = 0;         ///< grows with everything that the compiler finds
  std::map<std::string, std::string> used;   ///< stamps of the files on disk that the model has read
  std::uint64_t beside_seen = 0;             ///< Desk::offered_number when it was read
  std::uint64_t model_number = 0;            ///< grows with every new model
  double compile_ms = -1.0;
  console::DraftState draft;

  explicit OpenConfiguration(std::string content) : text(std::move(content)) {}
  bool is_dirty() const { return saved ? *saved != text.text() : !text.text().empty(); }
  bool is_outdated() const { return model != drawn || !model->is_readable(); }
};

/// The open configurations of one project, and the files behind them. Has no thread. Functions that return a
/// Result change nothing where they fail; the message is a sentence for a person.
class Desk {
 public:
  struct Settings {
    std::string project_folder;
    std::string example_folder;
    std::string state_folder;
  };
  explicit Desk(const Settings& settings);

  console::ProjectFolder& project() { return project_; }
  const console::Drafts& drafts() const { return drafts_; }

  /// Null where it is not open.
  OpenConfiguration* find(std::string_view path);
  /// Opens it, or gives it where it is open already. Empty: a new one.
  text::Result<OpenConfiguration*> open(const std::string& path, double now);
  /// A file given on the command line, wherever it stands.
  text::Result<OpenConfiguration*> open_on_disk(const std::string& disk_path, double now);
  /// Nobody looks at it any more; what is not saved stays as a draft, or, where that can't be written, open.
  void close(std::string_view path);
  /// The same, and nothing of it stays.
  void discard(const std::string& path);
  static bool is_new(std::string_view path);
  std::vector<OpenConfiguration*> all();

  /// The text has changed: everything anew that follows from it, also in those that use it.
  void changed(OpenConfiguration& one);
  /// One that has not been given to the compiler since it changed; null where all are.
  OpenConfiguration* next_to_compile();
  Compiler::Task task(const OpenConfiguration& one) const;
  /// What the compiler found; nothing happens where the text is another one by now. False then.
  bool take(const std::string& document, std::shared_ptr<const Compiled> compiled);
  bool take(const std::string& document, std::shared_ptr<const CheckedCode> code);

  /// @return  its path afterwards
  text::Result<std::string> save(OpenConfiguration& one, const Save& request);
  text::Result<bool> reload(OpenConfiguration& one, bool merge, double now);
  /// Looks at the files on disk. What was changed there is taken over where nothing is unsaved here.
  struct Change {
    OpenConfiguration* document = nullptr;
    bool is_gone = false;
    bool is_dirty_here = false;
  };
  std::vector<Change> look_at_disk(double now);
  /// As OpenDocuments has them.
  void keep_drafts(double now, console::DraftKeeper::When when = console::DraftKeeper::When::kNowAndThen);
  void sync_drafts(double now);
  std::string not_kept() const;
  std::vector<std::string> losses() const;

  DrawingContext context(const OpenConfiguration& one) const;
  /// The id of the document that a source is the text of; empty where it can't be opened.
  std::string document_of(std::string_view source_name) const;
  const cdl::Environment& environment();
  /// Files of the project that it could use: those beside it, and the project's library.
  std::vector<Offered> offered(const OpenConfiguration& one) const;
  /// Grows when one of them changes.
  std::uint64_t offered_number() const { return beside_number_; }
  /// What stands beside a text, for questions about it. Valid as long as this desk.
  language::Surroundings surroundings();
  /// Configurations below a folder (`""`, `examples:`).
  std::vector<std::string> configurations(std::string_view folder) const;
  std::vector<std::string> overlays() const;
  /// The texts of all open configurations, by the names of their sources.
  std::map<std::string, std::string> open_texts() const;

 private:
  /// In UTF-8, and with LF where every line of the file ends in CR LF.
  text::Result<std::string> read(const std::string& path) const;
  bool is_writable(std::string_view path) const;
  /// @param lines_of  the file whose line ends it gets
  text::Result<bool> write(const std::string& path, const std::string& text,
                           const std::string& lines_of) const;
  std::string source_name(const std::string& path) const;
  OpenConfiguration* add(std::unique_ptr<OpenConfiguration> one);
  void model(OpenConfiguration& one);
  text::Result<OpenConfiguration*> import(const std::string& path, const std::string& content, double now);
  void restore_draft(OpenConfiguration& one, double now);
  void keep_draft(OpenConfiguration& one, double now, console::DraftKeeper::When when);
  text::Result<bool> save_to_library(OpenConfiguration& one, const std::string& declaration);
  text::Files files();
  /// The same for other threads: the open texts as they stand now.
  std::shared_ptr<const text::Files> snapshot() const;
  void look_beside();
  std::shared_ptr<const Model> model_beside(const std::string& name);
  std::vector<std::string> names_in(const std::string& folder) const;
  std::map<std::string, std::string> stamps(const OpenConfiguration& one) const;
  std::vector<std::string> found(std::string_view folder, std::string_view ending, int depth) const;

  console::ProjectFolder project_;
  console::Drafts drafts_;
  console::DraftKeeper keeper_;
  text::Files files_;
  cdl::Environment environment_;
  std::map<std::string, std::unique_ptr<OpenConfiguration>, std::less<>> open_;
  int last_new_ = 0;
  /// A file of the project that stands beside an open configuration.
  struct Beside {
    std::string stamp;
    std::shared_ptr<const Model> model;
  };
  std::map<std::string, Beside> beside_;  // by id
  std::uint64_t beside_number_ = 0;
};

}  // namespace mlab::designer
