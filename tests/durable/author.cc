#include "author.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace mlab::durable {
namespace {

constexpr double kPatience = 60.0;  // on a machine that does much else [s]
constexpr std::size_t kMostUnderWay = 4;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string word(std::uint32_t number) {
  return fmt::format("K{}E", number);
}

// Numbers of the words in a text: `K12E`.
void find_words(const std::string& text, std::set<std::uint32_t>& out) {
  for (std::size_t at = text.find('K'); at != std::string::npos; at = text.find('K', at + 1)) {
    std::uint32_t number = 0;
    std::size_t end = at + 1;
    for (; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end)
      number = 10 * number + static_cast<std::uint32_t>(text[end] - '0');
    if (end > at + 1 && end < text.size() && text[end] == 'E') out.insert(number);
  }
}

}  // namespace

Author::Words Author::words_now() const {
  Words out;
  for (const auto& [path, text] : texts_) find_words(text.first, out[path]);
  return out;
}

void Author::sent(Words after) {
  waiting_.push_back(last_request_);
  after_.push_back(std::move(after));
}

void Author::hear(const std::string& message) {
  const Speech::HeardAnswer heard = speech_.hear(message);
  if (heard.request != 0 && !waiting_.empty() && heard.request == waiting_.front()) {
    waiting_.pop_front();
    ++answered_;
    if (!heard.is_ok) trouble_ = "an edit was refused: " + heard.error;
  }
  // What comes while edits are under way is older than what is known here.
  for (const auto& [path, text] : heard.texts) {
    const auto known = texts_.find(path);
    if (known == texts_.end() || text.second >= known->second.second) texts_[path] = text;
  }
}

bool Author::is_time_to_kill() const {
  return !trouble_.empty() || seconds() >= end_ || (behind_ > 0 && answered_ >= behind_);
}

bool Author::settle(Socket& socket) {
  while (!waiting_.empty() || words_now() != after_.back()) {
    if (is_time_to_kill()) return false;
    if (const auto message = socket.receive(end_ - seconds())) hear(*message);
  }
  has_to_settle_ = false;
  return true;
}

// Each document has to be as it was acknowledged, or as what was under way would have made it.
std::string Author::compare() {
  const Words now = words_now();
  if (after_.empty()) after_.push_back(now);
  for (const auto& [path, words] : now) {
    const auto is_this = [&](const Words& after) { return after.at(path) == words; };
    if (std::any_of(after_.begin() + static_cast<std::ptrdiff_t>(answered_), after_.end(), is_this)) continue;
    return fmt::format("{} edits of {} were acknowledged, then the words of {} were {}; now they are {}",
                       answered_, after_.size() - 1, path, fmt::join(after_[answered_].at(path), " "),
                       fmt::join(words, " "));
  }
  after_ = {now};
  return "";
}

std::string Author::begin(Socket& socket) {
  texts_.clear();
  for (const std::string& message : speech_.greeting()) socket.send(message);
  const std::vector<std::string> wanted = speech_.documents();
  const auto is_there = [&](const std::string& path) { return texts_.contains(path); };
  const double end = seconds() + kPatience;
  while (!std::ranges::all_of(wanted, is_there)) {
    const auto message = socket.receive(std::max(0.0, end - seconds()));
    if (!message) return "the server did not show its documents";
    hear(*message);
  }
  const std::string lost = compare();
  answered_ = 0;
  waiting_.clear();
  undoable_.clear();
  has_to_settle_ = false;
  return lost;
}

void Author::edit_text(Socket& socket) {
  const std::vector<std::string> all = speech_.documents();
  const std::string& path = all[random_.below(static_cast<std::uint32_t>(all.size()))];
  auto& [text, revision] = texts_[path];
  const std::string line = speech_.comment(word(++last_word_));
  socket.send(speech_.insert(++last_request_, path, revision, line, word(last_word_)));
  text.insert(0, line);
  ++revision;
  Words after = after_.back();
  after[path].insert(last_word_);
  sent(std::move(after));
  undoable_.push_back(last_word_);
  undoable_document_ = path;
}

void Author::edit(Socket& socket) {
  if (has_to_settle_ && !settle(socket)) return;
  const std::uint64_t dice = random_.below(20);
  if (dice < 13) {
    edit_text(socket);
    return;
  }
  if (!settle(socket)) return;
  const std::string first = speech_.documents().front();
  Words after = after_.back();
  if (dice < 16) {
    socket.send(speech_.add_thing(++last_request_, word(++last_word_)));
    after[first].insert(last_word_);
    undoable_ = {last_word_};
    undoable_document_ = first;
  } else if (dice < 19 && !undoable_.empty()) {
    socket.send(speech_.undo(++last_request_, undoable_document_));
    after[undoable_document_].erase(undoable_.back());
    undoable_.clear();
  } else {
    socket.send(speech_.save(++last_request_, first));
  }
  sent(std::move(after));
  has_to_settle_ = true;
}

std::string Author::work_and_kill(Server& server) {
  Socket socket(server.port(), speech_.path() + "?token=" + server.token());
  if (!socket.is_open()) return "the server opened no session:\n" + server.printed();
  if (std::string lost = begin(socket); !lost.empty()) return lost;
  // Either right behind the answer to one of the first edits, or at any moment of the first ones.
  behind_ = random_.below(2) == 0 ? 1 + random_.below(8) : 0;
  end_ = seconds() + (behind_ > 0 ? kPatience : random_.uniform(0.0, 0.05));
  while (!is_time_to_kill()) {
    if (waiting_.size() < kMostUnderWay) edit(socket);
    const double pause = waiting_.size() < kMostUnderWay ? 0.0 : 0.001;
    while (const auto message = socket.receive(pause)) {
      hear(*message);
      if (is_time_to_kill()) break;
    }
  }
  server.kill();
  // What it had sent before was acknowledged as well.
  while (const auto message = socket.receive(1.0)) hear(*message);
  acknowledged_ += answered_;
  return std::exchange(trouble_, {});
}

}  // namespace mlab::durable
