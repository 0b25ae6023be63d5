#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mlab/base/random.h"
#include "server.h"
#include "socket.h"

namespace mlab::durable {

/// How edits are told to a console or a designer, and what they answer.
class Speech {
 public:
  struct HeardAnswer {
    std::uint32_t request = 0;  ///< that this answers; 0: none
    bool is_ok = false;
    std::string error;
    /// Texts of documents, by path, with their revisions.
    std::map<std::string, std::pair<std::string, std::uint64_t>> texts;
  };
  virtual ~Speech() = default;
  /// What the server is started with, and where its socket is.
  virtual std::vector<std::string> arguments() const = 0;
  virtual std::string path() const = 0;
  /// What is said before anything is edited.
  virtual std::vector<std::string> greeting() const = 0;
  virtual HeardAnswer hear(const std::string& message) const = 0;
  /// Paths of what is edited.
  virtual std::vector<std::string> documents() const = 0;
  /// A comment line that holds this word.
  virtual std::string comment(const std::string& word) const = 0;
  virtual std::string insert(std::uint32_t request, const std::string& document, std::uint64_t revision,
                             const std::string& text, const std::string& name) const = 0;
  /// An edit that the server words itself: something that is called so.
  virtual std::string add_thing(std::uint32_t request, const std::string& name) const = 0;
  virtual std::string undo(std::uint32_t request, const std::string& document) const = 0;
  virtual std::string save(std::uint32_t request, const std::string& document) const = 0;
};

std::unique_ptr<Speech> console_speech();
std::unique_ptr<Speech> designer_speech();

/// Somebody who edits until the server is killed under his hands, and knows what was acknowledged. Each edit
/// brings a word that no other has, or takes the last one back.
class Author {
 public:
  Author(const Speech& speech, std::uint64_t seed) : speech_(speech), random_(seed) {}

  /// Looks at what the server has after it was started, edits, and kills it at any moment after an edit was
  /// acknowledged.
  /// @return  what is not as it was acknowledged; empty: all is
  std::string work_and_kill(Server& server);
  /// How many edits were acknowledged up to now.
  std::size_t acknowledged() const { return acknowledged_; }

 private:
  using Words = std::map<std::string, std::set<std::uint32_t>>;  ///< by document

  std::string begin(Socket& socket);
  std::string compare();
  void edit(Socket& socket);
  void edit_text(Socket& socket);
  /// True once everything is answered and shown; false where it is time to kill before.
  bool settle(Socket& socket);
  bool is_time_to_kill() const;
  void hear(const std::string& message);
  Words words_now() const;
  void sent(Words after);

  const Speech& speech_;
  base::Random random_;
  std::uint32_t last_request_ = 0;
  std::uint32_t last_word_ = 0;
  std::map<std::string, std::pair<std::string, std::uint64_t>> texts_;
  std::deque<std::uint32_t> waiting_;  ///< requests that are not answered
  std::vector<Words> after_;           ///< each edit of this server's life; first: what it began with
  std::vector<std::uint32_t> undoable_;
  std::string undoable_document_;
  bool has_to_settle_ = false;  ///< what the server words itself has to be seen before it can be edited
  double end_ = 0.0;            ///< when to kill [s]
  std::size_t behind_ = 0;      ///< or right behind so many answers; 0: at that time
  std::size_t answered_ = 0;    ///< of this server's life
  std::size_t acknowledged_ = 0;
  std::string trouble_;
};

}  // namespace mlab::durable
