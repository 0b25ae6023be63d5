#pragma once

namespace mlab::cli {

/// The texts of bench/diffusion.cnl, bench/schemas.cnl and bench/steered.cnl, compiled in.
extern const char* const kDiffusionNetwork;
extern const char* const kSchemasNetwork;
extern const char* const kSteeredNetwork;

}  // namespace mlab::cli
