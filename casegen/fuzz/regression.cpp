#include "casegen/fuzz/regression.h"

#include "casegen/catalogue.h"
#include "casegen/csv.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/scene_input.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace gnomon::fuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array fields{"kernel", "failure", "input", "got", "want", "allowed", "found"};

/// The input's cells, as columns(c) names them.
std::vector<std::string> cells_of(const Case& c, const Input& input) {
    std::vector<std::string> cells;
    if (c.reference.takes_mask) cells = {format_mask(input.mask, '/'), to_string(input.mask.outside)};
    for (std::size_t i = 0; i < input.words.size(); ++i)
        cells.push_back(format_word(c.reference.words[i], input.words[i]));
    return cells;
}

/// Whether its inputs are whole scenes: they have no columns.
bool takes_scene(const Case& c) {
    const Chain* chain = find_chain(c);
    return chain && chain->draw;
}

std::string text_of(const Json& object, const char* field, const std::string& name) {
    if (!object.contains(field)) throw Error("{}: has no \"{}\"", name, field);
    const Json& value = object.at(field);
    if (!value.is_string()) throw Error("{}: \"{}\" is not a text", name, field);
    return value.get<std::string>();
}

Input input_of(const Case& c, const Json& object, const std::string& name) {
    const bool is_scene = takes_scene(c);
    if (!object.contains("input") || !object.at("input").is_object())
        throw Error("{}: has no \"input\" with {} in it", name,
                    is_scene ? "a scene" : fmt::format("{}", fmt::join(columns(c), ", ")));
    const Json& cells = object.at("input");
    if (is_scene) return words_of(scene_of(cells, name + ", input"));
    Csv csv{name, columns(c), {{}}};
    for (const std::string& column : csv.header)
        csv.rows.front().push_back(one_line(text_of(cells, column.c_str(), name + ", input")));
    for (const auto& [key, value] : cells.items())
        if (std::ranges::find(csv.header, key) == csv.header.end())
            throw Error("{}: \"{}\" is no input of {}; they are {}", name, one_line(key), c.name,
                        fmt::join(csv.header, ", "));
    return read_inputs(c, csv).front();
}

const Case& subject(const std::string& name) {
    if (const Case* found = find_subject(name)) return *found;
    throw Error("there is neither a kernel nor a chain \"{}\"", name);
}

/// Letters and digits; anything else a dash.
std::string slug(std::string text) {
    for (char& letter : text)
        if (!(letter >= 'a' && letter <= 'z') && !(letter >= 'A' && letter <= 'Z') &&
            !(letter >= '0' && letter <= '9'))
            letter = '-';
    return text;
}

} // namespace

std::string format_regression(const Regression& regression) {
    const Case& c = subject(regression.kernel);
    Json input = Json::object();
    if (takes_scene(c)) {
        input = json_of(scene_of(regression.input));
    } else {
        const std::vector<std::string> names = columns(c), cells = cells_of(c, regression.input);
        for (std::size_t i = 0; i < names.size(); ++i) input[names[i]] = cells[i];
    }
    const Json object{
        {"kernel", regression.kernel}, {"failure", regression.failure}, {"input", input},
        {"got", regression.got},       {"want", regression.want},       {"allowed", regression.allowed},
        {"found", regression.found}};
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Regression parse_regression(std::string_view text, const std::string& name) {
    Json object;
    try {
        object = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error("{}: not JSON (byte {}); restore the file, or remove it", name, error.byte);
    } catch (const Json::out_of_range&) {
        throw Error("{}: not JSON (a number that is too large); restore the file, or remove it", name);
    }
    if (!object.is_object()) throw Error("{}: not a JSON object", name);
    for (const auto& [key, value] : object.items())
        if (std::ranges::find(fields, key) == fields.end())
            throw Error("{}: unknown field \"{}\"; there are {}", name, one_line(key),
                        fmt::join(fields, ", "));
    Regression regression;
    regression.kernel = text_of(object, "kernel", name);
    const Case* found = find_subject(regression.kernel);
    if (!found)
        throw Error("{}: there is no kernel \"{}\"; rename it in the file, or delete the file", name,
                    one_line(regression.kernel));
    regression.failure = text_of(object, "failure", name);
    regression.input = input_of(*found, object, name);
    regression.got = text_of(object, "got", name);
    regression.want = text_of(object, "want", name);
    regression.allowed = text_of(object, "allowed", name);
    regression.found = text_of(object, "found", name);
    return regression;
}

std::string file_name(const Regression& regression) {
    std::string kernel = regression.kernel;
    std::ranges::replace(kernel, '/', '.');
    const Case& c = subject(regression.kernel);
    std::string all;
    if (takes_scene(c))
        for (const std::uint32_t word : regression.input.words) all += fmt::format("{:x},", word);
    else
        for (const std::string& cell : cells_of(c, regression.input)) all += cell + ',';
    return fmt::format("{}.{}.{:08x}.json", kernel, slug(regression.failure), hash(all) & 0xffffffffu);
}

std::map<std::string, std::vector<Regression>> load_regressions(const std::filesystem::path& folder) {
    std::map<std::string, std::vector<Regression>> regressions;
    if (folder.empty() || !std::filesystem::exists(folder)) return regressions;
    if (!std::filesystem::is_directory(folder))
        throw Error("{}: not a folder of regressions", folder.string());
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
    std::ranges::sort(paths);
    for (const std::filesystem::path& path : paths) {
        if (path.filename() == "README.md") continue;
        if (path.extension() != ".json")
            throw Error("{}: regressions are called *.json; rename or remove it", path.string());
        Regression regression = parse_regression(read_file(path), path.string());
        regressions[regression.kernel].push_back(std::move(regression));
    }
    return regressions;
}

void make_regressions_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) throw Error("cannot make the folder {}: {}", folder.string(), failed.message());
}

} // namespace gnomon::fuzz
