#include "casegen/watch/message.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace gnomon::watch {
namespace {

using Json = nlohmann::json;

/// JSON has no infinity.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double number_of(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

/// Texts come from files that may hold anything: bytes that are no UTF-8 must not end the session.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

} // namespace

std::string format(const JudgeRequest& request) {
    // Texts as they are, whatever bytes they hold.
    return std::to_string(request.kernel) + ' ' + std::to_string(request.text.size()) + ' ' + request.text +
           request.before;
}

JudgeRequest parse_judge_request(const std::string& text) {
    JudgeRequest request;
    std::size_t used = 0, at = 0;
    request.kernel = std::stoul(text, &used);
    at += used + 1;
    const std::size_t length = std::stoul(text.substr(at, 24), &used);
    at += used + 1;
    request.text = text.substr(at, length);
    request.before = text.substr(at + length);
    return request;
}

std::string format(const Judgement& j) {
    Json json{{"cannot", j.cannot},
              {"same_code", j.same_code},
              {"verdict", j.verdict},
              {"good", j.good},
              {"ran", j.ran},
              {"device_lost", j.device_lost},
              {"results", j.results},
              {"samples", j.samples},
              {"failures", j.failures},
              {"worst_call", j.worst_call},
              {"got", j.got},
              {"want", j.want},
              {"message", j.message},
              {"replay", j.replay},
              {"explanation", j.explanation}};
    if (j.worst) json["worst"] = number(*j.worst);
    if (j.moved)
        json["moved"] = {j.moved->samples, number(j.moved->largest), j.moved->call, j.moved->before,
                         j.moved->after};
    return dumped(json);
}

Judgement parse_judgement(const std::string& text) {
    const Json json = Json::parse(text);
    const auto string = [&](const char* field) { return json.at(field).get<std::string>(); };
    Judgement j;
    j.cannot = string("cannot");
    j.same_code = json.at("same_code").get<bool>();
    j.verdict = string("verdict");
    j.good = json.at("good").get<bool>();
    j.ran = json.at("ran").get<bool>();
    j.device_lost = json.at("device_lost").get<bool>();
    j.results = json.at("results").get<std::uint64_t>();
    j.samples = json.at("samples").get<std::size_t>();
    j.failures = json.at("failures").get<std::size_t>();
    j.worst_call = string("worst_call");
    j.got = string("got");
    j.want = string("want");
    j.message = string("message");
    j.replay = string("replay");
    j.explanation = json.at("explanation").get<std::vector<std::string>>();
    if (json.contains("worst")) j.worst = number_of(json.at("worst"));
    if (json.contains("moved")) {
        const Json& from = json.at("moved");
        Moved moved;
        moved.samples = from.at(0).get<std::size_t>();
        moved.largest = number_of(from.at(1));
        moved.call = from.at(2).get<std::string>();
        moved.before = from.at(3).get<std::string>();
        moved.after = from.at(4).get<std::string>();
        j.moved = std::move(moved);
    }
    return j;
}

std::string format(const TimeRequest& request) {
    return dumped({{"round", request.what == TimeRequest::What::round},
                   {"kernel", request.kernel},
                   {"before", request.before},
                   {"after", request.after},
                   {"alone", request.alone},
                   {"results", request.results},
                   {"number", request.round}});
}

TimeRequest parse_time_request(const std::string& text) {
    const Json json = Json::parse(text);
    TimeRequest request;
    request.what = json.at("round").get<bool>() ? TimeRequest::What::round : TimeRequest::What::begin;
    request.kernel = json.at("kernel").get<std::size_t>();
    request.before = json.at("before").get<std::string>();
    request.after = json.at("after").get<std::string>();
    request.alone = json.at("alone").get<std::string>();
    request.results = json.at("results").get<std::uint64_t>();
    request.round = json.at("number").get<unsigned>();
    return request;
}

std::string format(const Times& times) {
    return dumped({{"cannot", times.cannot},
                   {"device_lost", times.device_lost},
                   {"same_results", times.same_results},
                   {"times", {times.before, times.after, times.again, times.floor}}});
}

Times parse_times(const std::string& text) {
    const Json json = Json::parse(text);
    Times times;
    times.cannot = json.at("cannot").get<std::string>();
    times.device_lost = json.at("device_lost").get<bool>();
    times.same_results = json.at("same_results").get<bool>();
    times.before = json.at("times").at(0).get<double>();
    times.after = json.at("times").at(1).get<double>();
    times.again = json.at("times").at(2).get<double>();
    times.floor = json.at("times").at(3).get<double>();
    return times;
}

} // namespace gnomon::watch
