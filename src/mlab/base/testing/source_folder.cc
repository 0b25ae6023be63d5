#include "mlab/base/testing/source_folder.h"

namespace mlab::base {

std::string source_folder() {
  return MLAB_SOURCE_FOLDER;
}

}  // namespace mlab::base
