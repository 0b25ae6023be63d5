#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mlab/assist/service.h"

namespace mlab::lsp {

/// A path that two names of one file have in common; what is not there stays as it is.
std::string normal(const std::string& path);

/// The files of an editor's folders that are in one of the languages. Each is read once, and again when it
/// has changed on disk. Links that lead out of the folders are not followed.
class Workspace {
 public:
  static constexpr std::size_t kMostFiles = 2000;
  static constexpr int kMostDepth = 8;

  void add_folder(std::string folder) { folders_.push_back(std::move(folder)); }
  /// @param known  normal paths of those that are left out
  std::vector<assist::Text> texts(const std::set<std::string>& known, const text::Files& files);
  /// Whether there was more than kMostFiles or kMostDepth when the texts were asked for last.
  bool is_cut() const { return is_cut_; }

 private:
  struct File {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    assist::Text text;
  };
  void look_at(const std::filesystem::directory_entry& entry, const text::Files& files);

  std::vector<std::string> folders_;
  std::map<std::string, File> files_;  // by normal path
  bool is_cut_ = false;
};

/// Why a file can't be written, as assist::Surroundings::fixed; one that is not there can.
std::string why_fixed(const std::string& path);

}  // namespace mlab::lsp
