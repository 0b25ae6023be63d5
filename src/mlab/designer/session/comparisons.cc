#include "mlab/designer/session/comparisons.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/git/git.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostRevisions = 50;

}  // namespace

template <class Finding>
void Comparisons::ask_git(const Asker& asker, const std::string& name,
                          std::function<text::Result<Finding>()> ask,
                          std::function<void(const Finding& found, Answer& out)> done) {
  const std::string job = fmt::format("{} {}", asker.connection.value, name);
  const auto [waits, is_first] = asked_of_git_.try_emplace(job, asker.request);
  if (!is_first) {
    const Asker before = {asker.connection, std::exchange(waits->second, asker.request)};
    Answer answer = answer_for(before);
    refuse(answer, "it was asked for again since");
    answers_.add(before, std::move(answer));
  }
  git_jobs_.start(job, [this, inbox = inbox_, asker, job, ask = std::move(ask),
                        done = std::move(done)](const LatestJobs::IsStale& is_stale) {
    const text::Result<Finding> found = ask();
    if (is_stale()) return;
    inbox->post([this, asker, job, found, done] {
      const auto waiting = asked_of_git_.find(job);
      if (waiting == asked_of_git_.end() || waiting->second != asker.request) return;
      asked_of_git_.erase(waiting);
      if (clients_.find(asker.connection) == nullptr) return;
      Answer out = answer_for(asker);
      if (found)
        done(*found, out);
      else
        fail(out, found.error());
      answers_.add(asker, std::move(out));
    });
  });
}

std::optional<std::string> Comparisons::file_for_git(const OpenConfiguration& document, Answer& out) const {
  const bool has_none = Desk::is_new(document.path) || document.path.starts_with("library:");
  std::string path = has_none ? "" : desk_.disk_path(document.path);
  if (!path.empty()) return path;
  refuse(out, "git knows only what has a file");
  return std::nullopt;
}

Answered Comparisons::compare_with(const Sender& sender, const CompareWith& request, Answer& out) {
  OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return Answered::kNow;
  switch (request.with_case()) {
    case CompareWith::kFile: {
      const text::Result<std::string> text = desk_.text_of(request.file());
      if (text)
        show(sender.asker.connection, *document, request.file(), *text, false);
      else
        fail(out, text.error());
      return Answered::kNow;
    }
    case CompareWith::kRevision:
      return compare_with_revision(sender, *document, request.revision(), out);
    case CompareWith::kSaved:
    case CompareWith::WITH_NOT_SET:
      break;
  }
  if (document->saved)
    show(sender.asker.connection, *document, "the saved file", *document->saved, true);
  else
    refuse(out, "it has not been saved yet");
  return Answered::kNow;
}

Answered Comparisons::compare_with_revision(const Sender& sender, const OpenConfiguration& document,
                                            const std::string& revision, Answer& out) {
  const std::optional<std::string> file = file_for_git(document, out);
  if (!file) return Answered::kNow;
  ask_git<text::SourcePtr>(
      sender.asker, "revision " + document.path,
      [tracked = git::TrackedFile(*file), revision]() -> text::Result<text::SourcePtr> {
        const text::Result<git::FileThen> then = tracked.find(revision);
        if (!then) return std::unexpected(then.error());
        return tracked.at(*then);
      },
      [this, from = sender.asker.connection, path = document.path, revision](const text::SourcePtr& source,
                                                                             Answer&) {
        const OpenConfiguration* still = desk_.find(path);
        if (still == nullptr) return;
        const bool is_hash = revision.size() == 40;
        show(from, *still, fmt::format("revision {}", is_hash ? revision.substr(0, 8) : revision),
             std::string(source->text()), false);
      });
  return Answered::kLater;
}

std::shared_ptr<const Model> Comparisons::model_beside(const OpenConfiguration& document, std::string text) {
  return std::make_shared<const Model>(
      std::make_shared<const text::Source>(document.drawn->source()->name(), std::move(text)),
      desk_.environment());
}

void Comparisons::show(console::ConnectionId client, const OpenConfiguration& document,
                       const std::string& title, std::string base, bool is_saved) {
  const Client* known = clients_.find(client);
  if (known == nullptr) return;
  shown_.insert_or_assign({client, document.path},
                          Comparison{++number_, known->opening_of(document.path),
                                     Comparing(title, model_beside(document, std::move(base)), is_saved)});
}

void Comparisons::stop(const Sender& sender, const StopComparing& request) {
  shown_.erase({sender.asker.connection, request.document()});
}

Answered Comparisons::list_revisions(const Sender& sender, const ListRevisions& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  const std::optional<std::string> file = document == nullptr ? std::nullopt : file_for_git(*document, out);
  if (!file) return Answered::kNow;
  using Revisions = std::vector<git::Revision>;
  ask_git<Revisions>(
      sender.asker, "list " + document->path,
      [file = *file] { return git::TrackedFile(file).revisions(kMostRevisions); },
      [](const Revisions& found, Answer& answer) {
        for (const git::Revision& revision : found) {
          RevisionList::Revision& listed = *answer.mutable_revisions()->add_revisions();
          listed.set_id(revision.id);
          listed.set_date(revision.date);
          listed.set_author(revision.author);
          listed.set_subject(revision.subject);
        }
      });
  return Answered::kLater;
}

void Comparisons::follow() {
  std::erase_if(shown_, [&](const auto& shown) {
    const auto& [client, document] = shown.first;
    const Client* known = clients_.find(client);
    return known == nullptr || known->opening_of(document) != shown.second.opening;
  });
  for (auto& [key, shown] : shown_) {
    const OpenConfiguration* document = desk_.find(key.second);
    if (document == nullptr) continue;
    Comparing& comparing = shown.comparing;
    if (comparing.is_with_saved() && document->saved && *document->saved != comparing.base().text())
      comparing.set_base(model_beside(*document, *document->saved));
    comparing.set_now(document->drawn);
  }
}

const Comparisons::Comparison* Comparisons::find(console::ConnectionId client,
                                                 const std::string& document) const {
  const auto found = shown_.find({client, document});
  return found == shown_.end() ? nullptr : &found->second;
}

}  // namespace mlab::designer
