#pragma once

#include <string>

#include "mlab/robot.pb.h"

namespace mlab::recording {

/// In which way an action is another one than was recorded: `wants (1.00, 0.00) m/s, recorded are (0.50,
/// 0.00) m/s`. Empty: they are the same, bit for bit.
std::string difference(const wire::Action& is, const wire::Action& was);

}  // namespace mlab::recording
