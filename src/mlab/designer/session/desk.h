#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/offered.h"
#include "mlab/designer/trial/compiler.h"
#include "mlab/documents/project_folder.h"
#include "mlab/documents/store.h"
#include "mlab/text/files.h"

namespace mlab::designer {

/// The file of a project that holds assemblages for all its configurations.
inline constexpr const char* kProjectLibrary = "library.cdl";

/// A configuration that is open, whoever looks at it. Its path, which is its id: as ProjectFolder names it,
/// `library:...`, or `new:1`.
struct OpenConfiguration : documents::Document {
  using Document::Document;

  std::shared_ptr<Model> model;  ///< of the text as it stands
  std::shared_ptr<Model> drawn;  ///< of the last text without slips of grammar
  std::uint64_t drawn_revision = 0;
  text::SourcePtr modelled;                  ///< what of `text` the model is of
  std::uint64_t file_news = 0;               ///< grows with everything that people should know of its file
  bool is_started = false;                   ///< the model's text has been given to the compiler
  std::shared_ptr<const Compiled> compiled;  ///< of the model's text; null: not yet
  std::shared_ptr<const CheckedCode> code;   ///< of the C++ that was used last; null: none yet
  std::uint64_t compiled_number = 0;         ///< grows with everything that the compiler finds
  std::map<std::string, std::string> used;   ///< stamps of the files on disk that the model has read
  std::uint64_t beside_seen = 0;             ///< Desk::offered_number when it was read
  std::uint64_t model_number = 0;            ///< grows with every new model
  double compile_ms = -1.0;

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

  documents::ProjectFolder& project() { return project_; }
  const documents::Drafts& drafts() const { return store_.drafts(); }
  documents::Store& store() { return store_; }

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

  /// Everything anew that follows from texts that have changed, also in those that use them.
  void follow_texts();
  /// One that has not been given to the compiler since it changed; null where all are.
  OpenConfiguration* next_to_compile();
  Compiler::Task task(const OpenConfiguration& one) const;
  /// What the compiler found; nothing happens where the text is another one by now. False then.
  bool take(const std::string& document, std::shared_ptr<const Compiled> compiled);
  bool take(const std::string& document, std::shared_ptr<const CheckedCode> code);

  /// @return  its path afterwards; where it is another one, there is another thing to open
  text::Result<std::string> save(OpenConfiguration& one, const Save& request);
  text::Result<bool> reload(OpenConfiguration& one, bool merge, double now);
  /// Looks at the files on disk, and reads anew what has changed there.
  void look_at_disk(double now);
  /// What would be lost with this process: ``a.cdl`: No space left on device`.
  std::vector<std::string> losses() const;
  std::string not_kept() const;

  /// Where its file is on the machine.
  std::string disk_path(const std::string& path) const { return project_.disk_path(path); }
  /// What stands in a file, open or not.
  text::Result<std::string> text_of(const std::string& path) const { return store_.read(path); }

  DrawingContext context(const OpenConfiguration& one) const;
  /// The id of the document that a source is the text of; empty where it can't be opened.
  std::string document_of(std::string_view source_name) const;
  const cdl::Environment& environment();
  /// Files of the project that it could use: those beside it, and the project's library.
  std::vector<Offered> offered(const OpenConfiguration& one) const;
  /// Grows when one of them changes.
  std::uint64_t offered_number() const { return beside_number_; }
  /// What stands beside a text, for questions about it. Valid as long as this desk.
  assist::Surroundings surroundings();
  /// Grows when there is something else to open: saved under a new name, or thrown away.
  std::uint64_t lists_number() const { return lists_number_; }
  /// Configurations below a folder (`""`, `examples:`).
  std::vector<std::string> configurations(std::string_view folder) const;
  std::vector<std::string> overlays() const;

 private:
  std::string source_name(const std::string& path) const;
  std::shared_ptr<OpenConfiguration> make(const std::string& path, std::string text);
  OpenConfiguration* add(const std::shared_ptr<OpenConfiguration>& one);
  void model(OpenConfiguration& one);
  /// The text has changed.
  void changed(OpenConfiguration& one);
  text::Result<std::string> save_text(OpenConfiguration& one, const Save& request);
  text::Result<OpenConfiguration*> open_new(std::string path, double now);
  text::Result<OpenConfiguration*> open_kept(const std::string& path, double now);
  text::Result<OpenConfiguration*> import(const std::string& path, const std::string& content, double now);
  text::Result<bool> save_to_library(OpenConfiguration& one, const std::string& declaration);
  text::Result<bool> write_library(std::string_view before, std::string_view after);
  void look_beside();
  std::shared_ptr<const Model> model_beside(const std::string& name);
  std::vector<std::string> names_in(const std::string& folder) const;
  std::map<std::string, std::string> stamps(const OpenConfiguration& one) const;

  documents::ProjectFolder project_;
  documents::Store store_;
  text::Files files_;
  cdl::Environment environment_;
  std::map<std::string, std::shared_ptr<OpenConfiguration>, std::less<>> open_;  // as the store has them
  int last_new_ = 0;
  /// A file of the project that stands beside an open configuration.
  struct Beside {
    std::string stamp;
    std::shared_ptr<const Model> model;
  };
  std::map<std::string, Beside> beside_;  // by id
  std::uint64_t beside_number_ = 0;
  std::uint64_t lists_number_ = 0;
};

}  // namespace mlab::designer
