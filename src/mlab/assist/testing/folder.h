#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/assist/testing/ask_everything.h"

namespace mlab::assist::testing {

/// A folder of texts in memory.
class Folder {
 public:
  void put(const std::string& name, const std::string& text) {
    sources_[name] = std::make_shared<const text::Source>(name, text);
  }
  Text text(const std::string& name) const {
    const text::SourcePtr source = sources_.at(name);
    return {source, *language_of(*source)};
  }
  std::vector<Text> all() const {
    std::vector<Text> out;
    for (const auto& [name, source] : sources_) out.push_back(text(name));
    return out;
  }
  Surroundings around() const {
    Surroundings out = nowhere();
    const auto nothing = out.files.read;
    out.files.is_file = [this](const std::string& path) { return sources_.contains(path); };
    out.files.read = [this, nothing](const std::string& path) -> text::Result<text::SourcePtr> {
      const auto found = sources_.find(path);
      return found == sources_.end() ? nothing(path) : text::Result<text::SourcePtr>(found->second);
    };
    out.project = [this] { return all(); };
    out.list = [this](const std::string&) {
      std::vector<std::string> names;
      for (const auto& [name, source] : sources_) names.push_back(name);
      return names;
    };
    return out;
  }
  /// The first place of `what` in a text, in the middle of it.
  std::uint32_t at(const std::string& name, const std::string& what) const {
    return static_cast<std::uint32_t>(sources_.at(name)->text().find(what) + what.size() / 2);
  }

 private:
  std::map<std::string, text::SourcePtr> sources_;
};

}  // namespace mlab::assist::testing
