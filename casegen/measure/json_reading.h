// Members of JSON files that people may have written, each with a message that says where it is wrong.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace gnomon::measure {

/// `name` stands for the text in messages. Throws Error.
nlohmann::ordered_json parse_json(const std::string& text, const std::string& name);

// Members of `json`, which `at` stands for in messages. All throw Error, naming both: `json` is no object,
// has no such member, or one of another kind.
const nlohmann::ordered_json& member(const nlohmann::ordered_json& json, const char* name,
                                     const std::string& at);
std::string text_member(const nlohmann::ordered_json& json, const char* name, const std::string& at);
std::uint64_t count_member(const nlohmann::ordered_json& json, const char* name, const std::string& at);
const nlohmann::ordered_json& list_member(const nlohmann::ordered_json& json, const char* name,
                                          const std::string& at);
/// From 0; infinity for null, which stands for what is not finite.
double number_member(const nlohmann::ordered_json& json, const char* name, const std::string& at);

/// null for what is not finite: JSON has no infinity.
nlohmann::ordered_json number_or_null(double value);

} // namespace gnomon::measure
