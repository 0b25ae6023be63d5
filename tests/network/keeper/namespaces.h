#pragma once

#include <string>

#include "keeper/setup.h"

namespace mlab::network {

/// Leaves the machine: from here on this process, and all that it will fork, has a network without devices,
/// its own mounts, its own System V memory, its own name and, where asked for, its own monotonic clock; its
/// children have process numbers of their own, too. Who may not do that as he is does it in a user namespace,
/// in which he stays who he is.
/// @errors  Failure
void leave_machine(const KeeperSetup& setup);

/// In the first of those children: /proc, /tmp and /dev/shm of the host, and its /etc/hosts.
/// @errors  Failure
void make_file_systems(const KeeperSetup& setup);

/// A disk of so many bytes at a folder, which is made where it is missing. All that it held is hidden.
/// @errors  Failure
void mount_disk(const std::string& folder, const std::string& bytes);

}  // namespace mlab::network
