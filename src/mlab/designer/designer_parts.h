#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "mlab/console/inbox.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/comparing.h"
#include "mlab/designer/compiler.h"
#include "mlab/designer/designer.h"
#include "mlab/designer/desk.h"
#include "mlab/designer/latest_jobs.h"
#include "mlab/designer/mark_store.h"
#include "mlab/designer/marks.h"
#include "mlab/designer/movement_field.h"
#include "mlab/designer/project_renaming.h"
#include "mlab/designer/project_texts.h"
#include "mlab/designer/trial.h"
#include "mlab/language/search.h"

namespace mlab::designer {

class TestRuns;

/// How a designer stands inside. Everything but `inbox_` belongs to its thread.
class Designer::Parts {
 public:
  Parts(DesignerSettings settings, Send send);
  ~Parts();
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message);
  void closed(console::ConnectionId connection);
  std::vector<std::string> end();

 private:
  /// A browser: what it looks at, and what it has been sent last.
  struct Client {
    bool has_greeted = false;
    std::uint64_t beat = 0;  ///< number of its last one
    std::set<std::string, std::less<>> documents;
    std::vector<Page> pages;
    std::map<std::string, std::string> sent;  ///< of each document, page, palette, by a name for it
    std::map<std::string, Comparing, std::less<>> comparing;  ///< by document
  };

  /// What was tried last.
  struct LastTrial {
    std::string document;
    std::shared_ptr<const Model> model;  ///< of the completed text
    TrialConfiguration configuration;
    std::string file;     ///< as the mission names the text
    std::string mission;  ///< path of its text
    TrialWish wish;
  };

  void work();
  void handle(console::ConnectionId from, const ToDesigner& message);
  /// What is asked for; the answer's `ok` is set already.
  void answer(console::ConnectionId from, Client& client, const ToDesigner& message, Answer& out);
  void fail(Answer& out, const text::Diagnostic& why) const;
  /// The document of a request; null where it is not open, which the answer says then.
  OpenConfiguration* opened(const std::string& path, Answer& out);
  /// The document of a request that changes it; null where it can't, which the answer says then.
  OpenConfiguration* editable(const std::string& path, Answer& out);

  void edit_text(const EditText& request, Answer& out);
  void edit(const Edit& request, Answer& out);
  void undo(const std::string& path, bool again, Answer& out);
  void copy(const Copy& request, Answer& out);
  void ask_language(const AskLanguage& request, Answer& out);
  void find_definition(const OpenConfiguration& one, std::uint32_t cursor, Answer& out);
  void describe(const Describe& request, Answer& out);
  void fits(const Fits& request, Answer& out);

  // ---- designer_names.cc

  /// The text and the place in it of what is asked about.
  struct Asked {
    language::Text text;
    std::uint32_t cursor = 0;
  };
  /// Nothing where it has no name, which the answer says then.
  std::optional<Asked> asked_name(const NameAt& at, Answer& out);
  /// As people know the file.
  std::string path_of(const text::SourcePtr& source) const;
  /// Of the source, at the end of a list that is ordered by files.
  names::File& file_message(const text::SourcePtr& source,
                            google::protobuf::RepeatedPtrField<names::File>& files);
  void find_uses(const FindUses& request, Answer& out);
  void refuse_name(const language::Refusal& refusal, Answer& out);
  /// Nothing where it is refused; else the answer has it as well.
  std::optional<language::Renaming> plan(const NameAt& at, const std::string& name, Answer& out);
  void rename_everywhere(const RenameEverywhere& request, Answer& out);
  void undo_rename(Answer& out);
  void search(const Search& request, Answer& out);

  // ---- designer_files.cc

  void greet(console::ConnectionId from, Client& client, const Greeting& greeting, Answer& out);
  /// What there is to open, as the start page shows it.
  Lists lists();
  void tell_lists();
  void open(console::ConnectionId from, Client& client, const Open& request, Answer& out);
  void close(Client& client, const Close& request);
  void discard(Client& client, const Discard& request, Answer& out);
  void save(const Save& request, Answer& out);
  void reload(const Reload& request, Answer& out);
  void list_files(const ListFiles& request, Answer& out);

  // ---- designer_trial.cc

  /// What the document means at a place of the project: of one of the library a copy, which hides it.
  std::shared_ptr<const Model> model_to_try(const OpenConfiguration& one);
  void try_out(console::ConnectionId from, std::uint32_t number, const Try& request, Answer& out);
  void tried_out(console::ConnectionId from, std::uint32_t number, const LastTrial& trial,
                 const console::TrialResult& result);
  console::Trial trial_of(const OpenConfiguration& one, const TrialConfiguration& completed,
                          const std::string& overlay, std::string& file);
  text::Result<TrialField> field_of(const Try& request, const console::Trial& trial);
  /// @param out  problems are added
  void add_problems(const text::Diagnostics& problems, const TrialConfiguration& completed,
                    const OpenConfiguration& one, Answer& out) const;

  // ---- designer_live.cc

  void find_live(const FindLive& request, Answer& out);
  void set_mark(const SetMark& request, Answer& out);
  void remove_mark(const RemoveMark& request, Answer& out);
  void drop_marks(const std::string& document);
  /// Takes the marks of what is tried to where their pages run in it, and tells everybody before the answer
  /// comes.
  void move_marks();
  void keep_marks(const std::string& document, const Marks& marks);
  void keep_marks_again();
  /// Those of an earlier server.
  void restore_marks(const OpenConfiguration& one);
  void write_back(const WriteBack& request, Answer& out);
  text::Result<TrialConfiguration> tried_now(const OpenConfiguration& one);
  void read_field(console::ConnectionId from, std::uint32_t number, const ReadField& request, Answer& out);
  /// Of one of the robots that would run, were the document tried as it stands.
  struct Planned {
    TrialConfiguration completed;
    std::shared_ptr<const Model> model;  ///< of its text
    std::string robot;                   ///< declaration
    std::string place;                   ///< path in its program
  };
  /// The first place where the page would run.
  /// @param robot  that has to run it; 0: any
  text::Result<Planned> plan(const OpenConfiguration& one, const std::string& page, std::uint32_t robot = 0);
  text::Result<Planned> field_node(const OpenConfiguration& one, const ReadField& request);
  text::Result<FieldProgram> program_of_field(const Planned& what) const;
  text::Result<std::string> field_alone(const OpenConfiguration& one, const Planned& what,
                                        const FieldProgram& part, const FieldGrid& grid);
  /// @param arrows  nothing: there is no run that could give them
  void answer_field(console::ConnectionId from, std::uint32_t number, const ReadField& request,
                    const Planned& what, const FieldProgram& part, const FieldGrid& grid,
                    const std::optional<std::string>& arrows, bool is_as_is);

  // ---- designer_compare.cc

  void compare_with(console::ConnectionId from, Client& client, std::uint32_t number,
                    const CompareWith& request, Answer& out);
  /// @param base  named as the document's own text, so that it finds the same files
  void compare_with_text(Client& client, const OpenConfiguration& one, const std::string& title,
                         std::string base, bool is_saved);
  void stop_comparing(Client& client, const std::string& document);
  void list_revisions(console::ConnectionId from, std::uint32_t number, const ListRevisions& request,
                      Answer& out);
  /// Answers later with what `ask` finds on another thread. What is asked under the same name while that
  /// takes its time takes its place; who asked before is told so.
  /// @param name  of what is asked for, with the document; each client has its own
  template <class Found>
  void ask_git(console::ConnectionId from, std::uint32_t number, const std::string& name,
               std::function<text::Result<Found>()> ask,
               std::function<void(const Found& found, Answer& out)> done);
  /// Where the document's file is, for git; nothing where it has none, which the answer says then.
  std::optional<std::string> file_for_git(const OpenConfiguration& one, Answer& out) const;
  void publish_differences(console::ConnectionId to, Client& client);

  // ---- designer_tests.cc

  /// Where something has changed, tests are looked for anew, though not with every letter that is typed.
  void look_at_tests(bool is_at_once = false);
  void watch_tests(console::ConnectionId from, const WatchTests& request, Answer& out);
  void run_tests(const RunTests& request);
  void show_test_cycle(console::ConnectionId from, std::uint32_t number, const ShowTestCycle& request,
                       Answer& out);
  void add_test(const AddTest& request, Answer& out);
  void publish_tests(console::ConnectionId to, Client& client);

  // ---- designer_publish.cc

  /// Sends everybody what has changed of what he looks at.
  void publish();
  void publish_to(console::ConnectionId to, Client& client);
  Document document_message(const OpenConfiguration& one) const;
  MarkList marks_message(const std::string& path) const;
  void add_found_problems(const OpenConfiguration& one, Document& out) const;
  /// Sends it unless the same has been sent.
  void send_once(console::ConnectionId to, Client& client, const std::string& what,
                 const FromDesigner& message);
  void send(console::ConnectionId to, const FromDesigner& message);
  /// Says to all, a few times a second, that this thread goes on.
  void send_beats();
  void send_beat(console::ConnectionId to, const Client& client);

  // ---- designer.cc again: what time brings

  /// What follows from typing: done once for many letters that came together.
  void settle();
  void send_answers();
  void look_at_disk();
  /// What is known of the document's file.
  static FromDesigner disk_message(const documents::Document& one, bool is_taken_over = false);
  /// Sends it to all who have it open.
  void tell_disk(const documents::Document& one, bool is_taken_over = false);
  /// Gives the compiler all texts that have changed.
  void start_compilations();
  double now() const;
  void keep_drafts();
  void tell_not_kept();
  FromDesigner keeping_message() const;

  DesignerSettings settings_;
  Send send_;
  Desk desk_;
  ProjectTexts texts_;
  ProjectRenaming renaming_;
  language::ProjectIndex index_;
  std::map<console::ConnectionId, Client> clients_;
  std::string first_;  ///< path of the document that the command line named
  std::string first_error_;
  double last_look_ = 0.0;
  double last_beats_ = 0.0;
  LastTrial last_trial_;
  std::map<std::string, Marks> marks_;  ///< by document; also of those that nobody looks at now
  MarkStore mark_store_;
  std::map<std::string, std::string> unkept_marks_;  ///< by document: why
  double marks_tried_ = 0.0;
  std::string not_kept_;                      ///< as it was told last
  std::set<std::string, std::less<>> typed_;  ///< documents of which nothing but the text is new yet
  std::vector<std::pair<console::ConnectionId, FromDesigner>> answers_;  ///< of requests that came together
  bool is_deferred_ = false;  ///< the request in hand is answered later
  std::shared_ptr<console::Inbox> inbox_ = std::make_shared<console::Inbox>();  ///< also of who answers later
  Compiler compiler_;                                                           // posts to the inbox
  std::map<std::string, std::uint32_t> asked_of_git_;  ///< by the job's name: the request that waits for it
  LatestJobs git_jobs_;                                // as well
  std::unique_ptr<TestRuns> tests_;                    // as well
  std::string tests_stamp_;                            // of what was open when tests were looked for
  double last_test_look_ = 0.0;
  std::atomic<bool> ends_ = false;
  std::stop_source jobs_end_;  // stops a C++ compiler that this thread waits for
  std::thread thread_;
};

}  // namespace mlab::designer
