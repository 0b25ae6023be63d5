// A document compared with another version of it.

#include <utility>

#include <fmt/core.h>

#include "mlab/designer/session/parts.h"
#include "mlab/git/git.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostRevisions = 50;

std::string differences_key(const std::string& document) {
  return "differences " + document + ' ';
}

}  // namespace

template <class Found>
void Designer::Parts::ask_git(console::ConnectionId from, std::uint32_t number, const std::string& name,
                              std::function<text::Result<Found>()> ask,
                              std::function<void(const Found& found, Answer& out)> done) {
  is_deferred_ = true;
  const std::string job = fmt::format("{} {}", from.value, name);
  const auto [waits, is_first] = asked_of_git_.try_emplace(job, number);
  if (!is_first) {
    FromDesigner message;
    message.mutable_answer()->set_request(std::exchange(waits->second, number));
    message.mutable_answer()->set_ok(false);
    message.mutable_answer()->set_error("it was asked for again since");
    answers_.emplace_back(from, std::move(message));
  }
  git_jobs_.start(job, [this, inbox = inbox_, from, number, job, ask = std::move(ask),
                        done = std::move(done)](const LatestJobs::IsStale& is_stale) {
    const text::Result<Found> found = ask();
    if (is_stale()) return;
    inbox->post([this, from, number, job, found, done] {
      const auto waiting = asked_of_git_.find(job);
      if (waiting == asked_of_git_.end() || waiting->second != number) return;
      asked_of_git_.erase(waiting);
      if (!clients_.contains(from)) return;
      FromDesigner message;
      Answer& out = *message.mutable_answer();
      out.set_request(number);
      out.set_ok(true);
      if (found)
        done(*found, out);
      else
        fail(out, found.error());
      answers_.emplace_back(from, std::move(message));
    });
  });
}

std::optional<std::string> Designer::Parts::file_for_git(const OpenConfiguration& one, Answer& out) const {
  std::string path =
      Desk::is_new(one.path) || one.path.starts_with("library:") ? "" : desk_.disk_path(one.path);
  if (!path.empty()) return path;
  out.set_ok(false);
  out.set_error("git knows only what has a file");
  return std::nullopt;
}

void Designer::Parts::compare_with(console::ConnectionId from, Client& client, std::uint32_t number,
                                   const CompareWith& request, Answer& out) {
  OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  switch (request.with_case()) {
    case CompareWith::kFile: {
      const text::Result<std::string> text = desk_.text_of(request.file());
      if (text)
        compare_with_text(client, *one, request.file(), *text, false);
      else
        fail(out, text.error());
      return;
    }
    case CompareWith::kRevision: {
      const std::optional<std::string> file = file_for_git(*one, out);
      if (!file) return;
      ask_git<text::SourcePtr>(
          from, number, "revision " + one->path,
          [tracked = git::TrackedFile(*file),
           revision = request.revision()]() -> text::Result<text::SourcePtr> {
            const text::Result<git::FileThen> then = tracked.find(revision);
            if (!then) return std::unexpected(then.error());
            return tracked.at(*then);
          },
          [this, from, path = one->path, revision = request.revision()](const text::SourcePtr& source,
                                                                        Answer&) {
            const OpenConfiguration* still = desk_.find(path);
            const auto asker = clients_.find(from);
            if (still == nullptr || asker == clients_.end()) return;
            const bool is_hash = revision.size() == 40;
            compare_with_text(asker->second, *still,
                              fmt::format("revision {}", is_hash ? revision.substr(0, 8) : revision),
                              std::string(source->text()), false);
          });
      return;
    }
    case CompareWith::kSaved:
    case CompareWith::WITH_NOT_SET:
      break;
  }
  if (one->saved) {
    compare_with_text(client, *one, "the saved file", *one->saved, true);
    return;
  }
  out.set_ok(false);
  out.set_error("it has not been saved yet");
}

void Designer::Parts::compare_with_text(Client& client, const OpenConfiguration& one,
                                        const std::string& title, std::string base, bool is_saved) {
  auto model = std::make_shared<const Model>(
      std::make_shared<const text::Source>(one.drawn->source()->name(), std::move(base)),
      desk_.environment());
  stop_comparing(client, one.path);
  client.comparing.emplace(one.path, Comparing(title, std::move(model), is_saved));
}

void Designer::Parts::stop_comparing(Client& client, const std::string& document) {
  client.comparing.erase(document);
  std::erase_if(client.sent, [&](const auto& one) {
    return one.first.find(differences_key(document)) != std::string::npos;
  });
}

void Designer::Parts::list_revisions(console::ConnectionId from, std::uint32_t number,
                                     const ListRevisions& request, Answer& out) {
  const OpenConfiguration* one = opened(request.document(), out);
  const std::optional<std::string> file = one == nullptr ? std::nullopt : file_for_git(*one, out);
  if (!file) return;
  using Found = std::vector<git::Revision>;
  ask_git<Found>(
      from, number, "list " + one->path,
      [file = *file] { return git::TrackedFile(file).revisions(kMostRevisions); },
      [](const Found& found, Answer& answer) {
        for (const git::Revision& revision : found) {
          RevisionList::Revision& listed = *answer.mutable_revisions()->add_revisions();
          listed.set_id(revision.id);
          listed.set_date(revision.date);
          listed.set_author(revision.author);
          listed.set_subject(revision.subject);
        }
      });
}

void Designer::Parts::publish_differences(console::ConnectionId to, Client& client) {
  for (auto& [path, comparing] : client.comparing) {
    const OpenConfiguration* one = desk_.find(path);
    if (one == nullptr) continue;
    if (comparing.is_with_saved() && one->saved && *one->saved != comparing.base().text())
      comparing.set_base(std::make_shared<const Model>(
          std::make_shared<const text::Source>(one->drawn->source()->name(), *one->saved),
          desk_.environment()));
    comparing.set_now(one->drawn);
    const std::string version = fmt::format("{} {}", comparing.number(), one->is_outdated());
    const auto is_new = [&](const std::string& what) {
      return std::exchange(client.sent["seen " + what], version) != version;
    };
    const std::string list = differences_key(path);
    FromDesigner message;
    if (is_new(list)) {
      *message.mutable_differences() = comparing.list();
      message.mutable_differences()->set_document(path);
      if (one->is_outdated())
        message.mutable_differences()->set_trouble(
            "the text can't be read right now: this is of the last that could");
      send_once(to, client, list, message);
    }
    for (const Page& page : client.pages) {
      if (page.document() != path || page.path().find('/') != std::string::npos) continue;
      const std::string what = list + page.path();
      if (!is_new(what)) continue;
      message.Clear();
      *message.mutable_page_difference() = comparing.page(page.path(), desk_.context(*one));
      send_once(to, client, what, message);
    }
  }
}

}  // namespace mlab::designer
