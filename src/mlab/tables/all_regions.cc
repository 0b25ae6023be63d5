#include <array>

#include "mlab/tables/measure_tables.h"
#include "mlab/tables/regions.h"

namespace mlab::tables {

std::span<const Region> all_regions() {
  static constexpr std::array kAll = {
      Region{"measure_enum", measure_enum},
      Region{"measure_rows", measure_rows},
      Region{"measure_documentation", measure_documentation},
      Region{"measure_grammar", measure_grammar},
      Region{"odl_named_words", odl_named_words},
      Region{"odl_feature_words", odl_feature_words},
      Region{"odl_feature_string", odl_feature_string},
      Region{"odl_dictionary", odl_dictionary},
  };
  return kAll;
}

}  // namespace mlab::tables
