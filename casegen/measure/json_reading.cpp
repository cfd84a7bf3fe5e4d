#include "casegen/measure/json_reading.h"

#include "runtime/error.h"

#include <cmath>
#include <limits>

namespace gnomon::measure {

using Json = nlohmann::ordered_json;

Json parse_json(const std::string& text, const std::string& name) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error("{}: is not JSON (byte {})", name, error.byte);
    } catch (const Json::out_of_range&) {
        throw Error("{}: holds a number that is too large to be one", name);
    }
}

const Json& member(const Json& json, const char* name, const std::string& at) {
    if (!json.is_object()) throw Error("{}: is not an object with \"{}\"", at, name);
    const auto found = json.find(name);
    if (found == json.end()) throw Error("{}: has no \"{}\"", at, name);
    return *found;
}

std::string text_member(const Json& json, const char* name, const std::string& at) {
    const Json& value = member(json, name, at);
    if (!value.is_string()) throw Error("{}: \"{}\" is not a text", at, name);
    return value.get<std::string>();
}

std::uint64_t count_member(const Json& json, const char* name, const std::string& at) {
    const Json& value = member(json, name, at);
    if (!value.is_number_unsigned()) throw Error("{}: \"{}\" is not a count", at, name);
    return value.get<std::uint64_t>();
}

const Json& list_member(const Json& json, const char* name, const std::string& at) {
    const Json& value = member(json, name, at);
    if (!value.is_array()) throw Error("{}: \"{}\" is not a list", at, name);
    return value;
}

double number_member(const Json& json, const char* name, const std::string& at) {
    const Json& value = member(json, name, at);
    if (value.is_null()) return std::numeric_limits<double>::infinity();
    if (!value.is_number() || !(value.get<double>() >= 0))
        throw Error("{}: \"{}\" is neither a number from 0 nor null", at, name);
    return value.get<double>();
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

} // namespace gnomon::measure
