#include "mlab/cell/permission.h"

#include <fmt/core.h>

namespace mlab::cell {

Permission::Permission(const Grounds& grounds, const Means& means)
    : grounds_(grounds), wall_(choose_wall(means, grounds.without_cell)) {}

std::expected<Wall, std::string> Permission::judge(std::string_view code, std::string_view what) const {
  if (!wall_) return wall_;
  if (!grounds_.is_trusted)
    return std::unexpected(fmt::format("code is not {} in a folder that is not trusted", what));
  const bool is_known = grounds_.known && grounds_.known->contains(code);
  if (grounds_.people == Grounds::People::kElsewhere && !grounds_.allows_native && !is_known) {
    return std::unexpected(fmt::format(
        "where other machines take part, code that was not on disk when mlab started is {} only with "
        "--allow-native",
        what));
  }
  return wall_;
}

std::expected<Wall, std::string> Permission::to_compile(std::string_view code) const {
  return judge(code, "compiled");
}

std::expected<Wall, std::string> Permission::to_run(std::string_view code) const {
  if (wall_ && grounds_.purpose == Grounds::Purpose::kCheck)
    return std::unexpected("what is only checked is not run");
  return judge(code, "run");
}

std::expected<Wall, std::string> Permission::to_start(std::string_view executable) const {
  if (!wall_) return wall_;
  if (grounds_.purpose == Grounds::Purpose::kCheck) return std::unexpected("what is only checked is not run");
  if (!grounds_.is_trusted)
    return std::unexpected(fmt::format("`{}` is not run in a folder that is not trusted", executable));
  if (!grounds_.allows_native)
    return std::unexpected(
        fmt::format("the executable `{}` is not run without being allowed to", executable));
  return wall_;
}

}  // namespace mlab::cell
