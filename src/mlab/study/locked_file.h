#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace mlab::study {

/// An open file that processes lock, so that each knows of the others. What is locked is free again when the
/// process ends, however it ends.
class LockedFile {
 public:
  /// Makes the file where there is none.
  /// @param what  is done with it, for the error: `opened`
  /// @errors  what the system says, behind the file's name; `is no ordinary file` of a folder, a pipe, a
  ///          device
  static std::expected<LockedFile, std::string> open(const std::string& path, const char* what);
  /// @return  nothing where there is none, or it is no file but a folder, a pipe, ...
  static std::optional<LockedFile> open_existing(const std::string& path);
  ~LockedFile();
  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&&) = delete;
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  /// @return  false: another process has it. A file system without locks lets everybody have it
  bool lock() const;
  void unlock() const;
  /// From an offset to its end; nothing where it can't be read.
  std::optional<std::string> read(std::size_t from = 0) const;
  /// What follows begins there.
  bool cut(std::size_t size) const;
  bool append(std::string_view bytes) const;
  /// What was appended is on the disk, where other machines see it.
  void sync() const;
  std::optional<std::size_t> size() const;
  /// False where somebody has removed it since it was opened.
  bool is_there() const;

 private:
  explicit LockedFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// `can't be opened: Permission denied`, after a call that failed.
std::string system_error(const char* what);

}  // namespace mlab::study
