#pragma once

#include "mlab/run/crew.h"
#include "mlab/text/diagnostic.h"

namespace mlab::run {

/// Warns of orders that can't end as they stand, for the programs of the robots: `never-reports`, of an order
/// to robots whose programs say nothing of it, which would fail after long; `only-started`, of a mission
/// whose robots act by themselves, and which is over before they do.
void check_orders(const Crew& crew, text::Diagnostics& sink);

}  // namespace mlab::run
