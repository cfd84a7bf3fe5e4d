#include "casegen/mutate/equivalent.h"

#include "runtime/error.h"
#include "runtime/files.h"

#include <nlohmann/json.hpp>

#include <set>

namespace gnomon::mutate {
namespace {

using Json = nlohmann::ordered_json;

std::string text_field(const Json& group, const char* field, const std::string& where) {
    if (!group.contains(field) || !group[field].is_string() || group[field].get<std::string>().empty())
        throw Error("{}: \"{}\" must be there and a text that is not empty", where, field);
    return group[field].get<std::string>();
}

} // namespace

std::vector<Equivalent> parse_equivalents(std::string_view text, const std::string& name) {
    Json all;
    try {
        all = Json::parse(text);
    } catch (const Json::exception& error) {
        throw Error("{}: not JSON: {}", name, error.what());
    }
    if (!all.is_array()) throw Error("{}: not a list of groups", name);
    std::vector<Equivalent> found;
    std::set<std::string> ids;
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Json& group = all[n];
        const std::string where = fmt::format("{}: group {}", name, n + 1);
        if (!group.is_object()) throw Error("{} is not an object", where);
        for (const auto& [field, value] : group.items())
            if (field != "file" && field != "reason" && field != "tolerated" && field != "mutants")
                throw Error("{}: there is no field \"{}\"", where, field);
        if (group.contains("tolerated") && !group["tolerated"].is_boolean())
            throw Error("{}: \"tolerated\" must be true or false", where);
        if (!group.contains("mutants") || !group["mutants"].is_object() || group["mutants"].empty())
            throw Error("{}: \"mutants\" must be an object of ids and texts", where);
        Equivalent each;
        each.file = text_field(group, "file", where);
        each.reason = text_field(group, "reason", where);
        each.tolerated = group.value("tolerated", false);
        for (const auto& [id, mutation] : group["mutants"].items()) {
            if (!mutation.is_string()) throw Error("{}: mutant {} has no text", where, id);
            if (!ids.insert(id).second) throw Error("{}: mutant {} is listed twice", where, id);
            each.id = id;
            each.mutation = mutation.get<std::string>();
            found.push_back(each);
        }
    }
    return found;
}

std::vector<Equivalent> load_equivalents(const std::filesystem::path& file) {
    return parse_equivalents(read_file(file), file.string());
}

} // namespace gnomon::mutate
