#include "casegen/fuzz/message.h"

#include "casegen/csv.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/scene_input.h"
#include "runtime/error.h"
#include "runtime/one_line.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace gnomon::fuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* damaged = "not what gnomon fuzz writes";

/// The library would convert what is negative, broken or too large without a word.
template <typename Whole>
Whole whole(const Json& value) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<Whole>::max())
        throw Error("{}: no whole number where one must be", damaged);
    return static_cast<Whole>(value.get<std::uint64_t>());
}

Json json_of(const Input& input) {
    Json object{{"words", input.words}};
    if (!input.mask.texels.empty())
        object["mask"] = {format_mask(input.mask, '/'), to_string(input.mask.outside)};
    return object;
}

Input input_of(const Json& object) {
    Input input;
    for (const Json& word : object.at("words")) input.words.push_back(whole<std::uint32_t>(word));
    if (object.contains("mask")) {
        input.mask = parse_mask(object.at("mask").at(0).get<std::string>(), '/', "mask");
        input.mask.outside = parse_outside(object.at("mask").at(1).get<std::string>(), "outside");
    }
    return input;
}

Json json_of(const Found& found) {
    const Regression& r = found.regression;
    return {{"kernel", r.kernel}, {"failure", r.failure},    {"input", json_of(r.input)},
            {"got", r.got},       {"want", r.want},          {"allowed", r.allowed},
            {"found", r.found},   {"on_file", found.on_file}};
}

Found found_of(const Json& object) {
    const auto text = [&](const char* field) { return object.at(field).get<std::string>(); };
    Found found{{text("kernel"), text("failure"), input_of(object.at("input")), text("got"), text("want"),
                 text("allowed"), text("found")},
                object.at("on_file").get<bool>()};
    const Case* c = find_subject(found.regression.kernel);
    if (!c) throw Error("there is neither a kernel nor a chain \"{}\"", one_line(found.regression.kernel));
    if (!found.regression.input.words.empty()) require_input_of(*c, found.regression.input); // none: unknown
    return found;
}

Request request_of(const Json& object) {
    Request request{whole<std::size_t>(object.at("kernel")),
                    whole<std::uint64_t>(object.at("round")),
                    whole<std::size_t>(object.at("evaluations")),
                    object.at("shrink").get<bool>(),
                    {},
                    object.at("known").get<std::set<std::string>>(),
                    {},
                    object.at("tell_inputs").get<bool>()};
    if (object.contains("batches")) request.batches = whole<std::size_t>(object.at("batches"));
    if (object.contains("part")) {
        const Json& part = object.at("part");
        request.part = Part{whole<std::size_t>(part.at(0)), whole<std::size_t>(part.at(1)),
                            whole<std::size_t>(part.at(2))};
    }
    return request;
}

Reply reply_of(const Json& object) {
    Reply reply;
    reply.timeout = object.value("timeout", "");
    reply.compile_error = object.value("compile_error", "");
    if (object.contains("inputs"))
        for (const Json& input : object.at("inputs")) reply.inputs.push_back(input_of(input));
    if (object.contains("result")) {
        const Json& from = object.at("result");
        UnitResult result;
        result.evaluations = whole<std::size_t>(from.at("evaluations"));
        for (const Json& found : from.at("found")) result.found.push_back(found_of(found));
        if (from.contains("worst")) {
            result.worst_error = from.at("worst_error").get<double>();
            result.worst = input_of(from.at("worst"));
        }
        reply.result = std::move(result);
    }
    return reply;
}

/// A text of unknown origin as `read` sees it; what is damaged in it is an Error.
template <typename Read>
auto read_json(const std::string& text, const char* what, Read&& read) {
    try {
        return read(Json::parse(text));
    } catch (const Json::exception&) { // of its message's many lines none helps
        throw Error("{}: {} ({} bytes of something else, or damaged)", what, damaged, text.size());
    }
}

/// What compilers and command lines say need not be Unicode.
std::string dump(const Json& object) { return object.dump(-1, ' ', false, Json::error_handler_t::replace); }

} // namespace

void require_input_of(const Case& c, const Input& input) {
    if (const Chain* chain = find_chain(c); chain && chain->draw) {
        scene_of(input);
        return;
    }
    if (input.words.size() != word_count(c) || c.reference.takes_mask == input.mask.texels.empty())
        throw Error("an input of {} words{} is none of {}", input.words.size(),
                    input.mask.texels.empty() ? "" : " and a mask", c.name);
}

std::string format_request(const Request& request) {
    Json object{{"kernel", request.kernel}, {"round", request.round}, {"evaluations", request.evaluations},
                {"shrink", request.shrink}, {"known", request.known}, {"tell_inputs", request.tell_inputs}};
    if (request.batches) object["batches"] = *request.batches;
    if (request.part) object["part"] = {request.part->batch, request.part->begin, request.part->end};
    return dump(object);
}

Request parse_request(const std::string& text) { return read_json(text, "request", request_of); }

std::string format_reply(const Reply& reply) {
    Json object = Json::object();
    if (!reply.timeout.empty()) object["timeout"] = reply.timeout;
    if (!reply.compile_error.empty()) object["compile_error"] = reply.compile_error;
    if (!reply.inputs.empty()) {
        object["inputs"] = Json::array();
        for (const Input& input : reply.inputs) object["inputs"].push_back(json_of(input));
    }
    if (reply.result) {
        Json found = Json::array();
        for (const Found& each : reply.result->found) found.push_back(json_of(each));
        object["result"] = {{"evaluations", reply.result->evaluations}, {"found", found}};
        if (reply.result->worst_error > 0) {
            object["result"]["worst_error"] = reply.result->worst_error;
            object["result"]["worst"] = json_of(reply.result->worst);
        }
    }
    return dump(object);
}

Reply parse_reply(const std::string& text) { return read_json(text, "reply", reply_of); }

} // namespace gnomon::fuzz
