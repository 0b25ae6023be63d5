#pragma once

#include <expected>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "mlab/cell/means.h"

namespace mlab::cell {

/// Texts, as they were.
using Texts = std::set<std::string, std::less<>>;

/// What decides about code that files bring.
struct Grounds {
  enum class Purpose {
    kRun,    ///< robots are to move
    kCheck,  ///< what is wrong with a text is to be said: `mlab check`, `mlab lsp`
  };
  enum class People {
    kHere,       ///< whoever takes part may start programs on this machine anyway
    kElsewhere,  ///< `--listen`: people on other machines take part
  };
  Purpose purpose;
  People people;
  bool allows_native;  ///< `--allow-native`
  bool without_cell;   ///< `--no-cell`
  bool is_trusted;     ///< the folder, by who opened it in an editor
  /// Of kElsewhere: code that lay on disk when the command line named it.
  std::shared_ptr<const Texts> known;
};

/// Whether code that files bring may be compiled and run, and within what walls. Who compiles or starts
/// something takes one, and there is one place that makes it: the command, out of its options (a test of the
/// source tree looks that nobody else does). So no caller can forget to ask: what gives the walls is the
/// question.
class Permission {
 public:
  /// Nobody has decided: it refuses everything. For those who read texts and neither compile nor run
  /// anything.
  Permission() : wall_(std::unexpected("nobody has allowed it")) {}
  static Permission decide(const Grounds& grounds, const Means& means) { return {grounds, means}; }

  /// Robots are to move; else texts are only checked, and nothing of them is ever run.
  bool is_to_run() const { return grounds_.purpose == Grounds::Purpose::kRun; }
  /// People whose code may not be compiled write files into the project; code that may be must not include
  /// them.
  bool others_write_files() const {
    return grounds_.people == Grounds::People::kElsewhere && !grounds_.allows_native;
  }
  /// Whether this text may be given to the compiler, and the walls that it works in.
  /// @errors  a sentence for a person that says why not, and what would help
  std::expected<Wall, std::string> to_compile(std::string_view code) const;
  /// The same of running what was made of the text.
  std::expected<Wall, std::string> to_run(std::string_view code) const;
  /// The same of an executable that lies on disk: nobody here has seen its code.
  std::expected<Wall, std::string> to_start(std::string_view executable) const;
  /// The walls round a process that runs nothing but missionlab's own code: as good as there are.
  Wall wall_of_ours() const { return wall_.value_or(Wall::kNone); }
  /// Whether code that is written from now on may be compiled: what pages tell those who write it.
  bool takes_new_code() const { return to_compile("code that nobody has written yet").has_value(); }

 private:
  Permission(const Grounds& grounds, const Means& means);
  std::expected<Wall, std::string> judge(std::string_view code, std::string_view what) const;

  Grounds grounds_{Grounds::Purpose::kCheck, Grounds::People::kElsewhere, false, false, false, nullptr};
  std::expected<Wall, std::string> wall_;
};

}  // namespace mlab::cell
