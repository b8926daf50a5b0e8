#include "watkins/data_folder.h"

namespace watkins {

std::filesystem::path data_folder() { return VSG_DATA_DIR; }

}  // namespace watkins
