// What techniques have wrong on a scene, as a picture, a table, lines of JSON, and a part of a page.
#pragma once

#include "casegen/measure/frames/frames.h"
#include "casegen/measure/tables.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gnomon::measure {

/// Frame time against wrong pixels, and against RMSE; dominated ones hollow. Empty without times.
std::string frames_chart(const SceneResult& result);

Table frames_table(const SceneResult& result);

/// Chart, table, and pictures: what was rendered and, beside it, what of it is wrong. Techniques with the
/// same image share one.
std::string frames_section(const SceneResult& result);

nlohmann::ordered_json frames_json(const SceneResult& result);

} // namespace gnomon::measure
