#pragma once

namespace mlab::cli {

/// The texts of bench/diffusion.cnl and bench/schemas.cnl, compiled in.
extern const char* const kDiffusionNetwork;
extern const char* const kSchemasNetwork;

}  // namespace mlab::cli
