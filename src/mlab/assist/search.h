#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/assist/service.h"

namespace mlab::assist {

/// How well a query fits a text, whatever the case; larger is better, 0: not at all. As it is, at the
/// beginning of a word, in one run, or only its letters in their order: each of these counts far more than
/// the next.
int match(std::string_view query, std::string_view text);

/// Something that can be gone to.
struct Entry {
  text::SourcePtr source;
  text::Span span;  ///< its name
  std::string name;
  std::string kind;    ///< as Symbol::kind; `call`: a component that is used; `file`
  std::string detail;  ///< its type
  std::string within;  ///< the declaration that it stands in
  std::string help;
};

/// Everything in a project's texts that has a name, found by some letters of it. What was read once stays
/// until its text changes.
class ProjectIndex {
 public:
  /// The texts as they stand now.
  void update(const std::vector<Text>& texts, const Surroundings& around);

  struct Hit {
    const Entry* entry = nullptr;  ///< valid until the next update
    int score = 0;
  };
  /// The best first, at most `most`; of equal ones those of the texts that were given first. What has the
  /// query only in its help comes last. An empty query finds nothing.
  std::vector<Hit> find(std::string_view query, std::size_t most) const;
  /// Those of the texts as they were given.
  std::vector<const Entry*> all() const;

 private:
  struct IndexedText {
    text::SourcePtr source;
    Language language = Language::kConfiguration;
    std::vector<Entry> entries;
  };
  std::map<std::string, IndexedText> known_;  // by the source's name
  std::vector<std::string> order_;
};

}  // namespace mlab::assist
