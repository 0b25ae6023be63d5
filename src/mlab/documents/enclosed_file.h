#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::documents {

/// An open folder somewhere below a root, reached without following a symbolic link, and what is done with
/// the files in it. Since every step holds on to the folder before it, nobody who exchanges folders for links
/// meanwhile can lead a reader or writer out.
class EnclosedFolder {
 public:
  enum class Missing { kRefuse, kMake };
  struct Item {
    std::string name;
    bool is_folder = false;
  };

  /// @param parts  plain names, from the root downwards; no `..`
  EnclosedFolder(const std::string& root, std::span<const std::string> parts,
                 Missing missing = Missing::kRefuse);
  /// The folder that the last part is to stand in.
  static EnclosedFolder of_file(const std::string& root, std::span<const std::string> parts,
                                Missing missing = Missing::kRefuse) {
    return {root, parts.first(parts.size() - 1), missing};
  }
  ~EnclosedFolder();
  EnclosedFolder(EnclosedFolder&& from) noexcept;
  EnclosedFolder(const EnclosedFolder&) = delete;
  EnclosedFolder& operator=(const EnclosedFolder&) = delete;

  /// Whether it could be opened.
  explicit operator bool() const { return fd_ >= 0; }
  /// Regular files and folders in it, at most so many, in no order.
  std::vector<Item> items(std::size_t most) const;
  bool has_file(const std::string& name) const;
  /// @return  why it could not be read; empty: it was
  std::string read(const std::string& name, std::size_t most_bytes, std::string& out) const;
  /// How far what is written has got when `write` returns: kInFileSystem outlives this process, kOnDisk the
  /// machine's power.
  enum class Reach { kInFileSystem, kOnDisk };
  /// Writes a file beside it, and puts it in place: there is the old one or the new one at any moment. Never
  /// writes through a link.
  /// @param mode  of the file; 0: that of the file that stands there, or of any new one
  /// @return  why it could not be written; empty: it was
  std::string write(const std::string& name, std::string_view text, Reach reach = Reach::kOnDisk,
                    unsigned mode = 0) const;
  /// Waits until a file that stands there is on the disk, and its name.
  /// @return  why that is not sure; empty: it is
  std::string sync(const std::string& name) const;

 private:
  int fd_ = -1;
  int error_ = 0;  // of the system, where it could not be opened
};

}  // namespace mlab::documents
