#pragma once

#include "core/project/json_text.h"
#include "core/project/project_file.h"

#include <map>

namespace prizma {

struct UnknownKeys {
    Json top = Json::object();
    std::map<std::string, Json> sections; ///< "camera", "render", ...
    std::map<Id, Json> items; ///< Of objects, lights, materials and groups; ids are unique over all of them.
    /// How an object whose model could not be loaded names its materials: without the model nobody knows its
    /// slots.
    std::map<Id, Json> materialsOfLost;
};

} // namespace prizma
