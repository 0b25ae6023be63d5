#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mlab::documents {

/// Where a server keeps the drafts of one project. Two that run at once have different places, so that
/// neither writes over what people type in the other: the first has the project's own, each further one a
/// place beside it. A place is held until this or its process ends, however that happens.
class DraftPlace {
 public:
  /// @param state_folder  of the user; empty: nothing is kept, and there is nothing to be divided
  /// @param project       where the project is on the machine
  /// @param kinds         folders below the state folder that have drafts of the project each; "" is itself
  DraftPlace(const std::string& state_folder, std::string_view project,
             const std::vector<std::string>& kinds);
  ~DraftPlace();
  DraftPlace(const DraftPlace&) = delete;
  DraftPlace& operator=(const DraftPlace&) = delete;

  /// Whether other servers have the project open, so that this place is beside the project's own.
  bool is_beside() const { return number_ > 1; }
  /// What is to be taken for the state folder where drafts are kept.
  const std::string& state_folder() const { return folder_; }
  /// Of texts whose drafts lie in a place beside, and can't be taken to the project's own since that has
  /// others of them. They come back where a further server is started while one runs.
  const std::vector<std::string>& left_beside() const { return left_beside_; }

  /// Servers of one project; what more of them there are keep nothing.
  static constexpr int kMost = 99;

 private:
  std::string place(int number) const;
  int lock(int number) const;
  /// Takes home what servers left beside that have ended.
  void gather(std::string_view project, const std::vector<std::string>& kinds);
  void gather_from(int number, std::string_view project, const std::string& kind);

  std::string own_;      ///< the user's state folder
  std::string project_;  ///< name of the project's folder in it
  std::string folder_;
  int number_ = 1;
  int lock_ = -1;
  std::vector<std::string> left_beside_;
};

}  // namespace mlab::documents
