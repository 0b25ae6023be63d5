#pragma once

#include "mlab/console.pb.h"
#include "mlab/preflight/preflight.h"

namespace mlab::console {

/// What was looked at; nothing of signatures.
void encode_checklist(const preflight::Checklist& checklist, Preflight& out);
void encode_signature(const preflight::Signature& signature, Preflight& out);

}  // namespace mlab::console
