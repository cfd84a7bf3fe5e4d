#include "casegen/versus/message.h"

#include <nlohmann/json.hpp>

// nlohmann finds these by the namespaces of the types.
namespace gnomon::measure {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Interval, lower, upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Quantiles, median, p90, p99, most, count, non_finite)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PaceVerdict, pace, ratio, with_floor, interval, again, calibration, margin,
                                   confidence, rounds, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pairing, verdict, a, b, floor, looks, seconds)
} // namespace gnomon::measure

namespace gnomon::versus {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ValueShare, value, samples, differ)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Whereabouts, name, values, sampled_from, sampled_to, from, to, inside)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Difference, samples, defined, differ, differ_defined, finiteness, zeros,
                                   other_nan, worst, absolute, ulps, most_ulps, where)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SideReport, failure, message, ran, seed, samples, wrong, error, unit,
                                   allowed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DifferenceReport, counts, lost, worst_defined, call_a, call_b, got_a,
                                   got_b, want, command_a, command_b)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Request, question, a, b)

namespace {

using Json = nlohmann::json;

std::string to_bytes(const Json& object) {
    std::string bytes;
    Json::to_cbor(object, bytes);
    return bytes;
}

Json json_of(const PictureReport& report) {
    return {{"png", std::vector<std::uint8_t>(report.png.begin(), report.png.end())},
            {"across", report.across},
            {"down", report.down},
            {"rest", report.rest},
            {"scale", report.scale},
            {"counts", {report.pixels, report.differ, report.finiteness, report.both_nan, report.outside}}};
}

PictureReport picture_of(const Json& object) {
    const auto bytes = object.at("png").get<std::vector<std::uint8_t>>();
    const auto counts = object.at("counts").get<std::vector<std::size_t>>();
    PictureReport report;
    report.png.assign(bytes.begin(), bytes.end());
    report.across = object.at("across").get<std::string>();
    report.down = object.at("down").get<std::string>();
    report.rest = object.at("rest").get<std::string>();
    report.scale = object.at("scale").get<double>();
    report.pixels = counts.at(0);
    report.differ = counts.at(1);
    report.finiteness = counts.at(2);
    report.both_nan = counts.at(3);
    report.outside = counts.at(4);
    return report;
}

} // namespace

std::string format_request(const Request& request) { return to_bytes(request); }

Request parse_request(const std::string& bytes) { return Json::from_cbor(bytes).get<Request>(); }

std::string format_reply(const Reply& reply, Question question) {
    Json object{{"timeout", reply.timeout}, {"obstacle", reply.obstacle}};
    switch (question) {
    case Question::same_code:
        object["answer"] = reply.same_code;
        break;
    case Question::run_a:
    case Question::run_b:
        object["answer"] = reply.side;
        break;
    case Question::difference:
        object["answer"] = reply.difference;
        break;
    case Question::draw:
        object["answer"] = json_of(reply.picture);
        break;
    case Question::time:
        object["answer"] = reply.time;
        break;
    }
    return to_bytes(object);
}

Reply parse_reply(const std::string& bytes, Question question) {
    const Json object = Json::from_cbor(bytes);
    const Json& answer = object.at("answer");
    Reply reply;
    reply.timeout = object.at("timeout").get<std::string>();
    reply.obstacle = object.at("obstacle").get<std::string>();
    switch (question) {
    case Question::same_code:
        reply.same_code = answer.get<bool>();
        break;
    case Question::run_a:
    case Question::run_b:
        reply.side = answer.get<SideReport>();
        break;
    case Question::difference:
        reply.difference = answer.get<DifferenceReport>();
        break;
    case Question::draw:
        reply.picture = picture_of(answer);
        break;
    case Question::time:
        reply.time = answer.get<measure::Pairing>();
        break;
    }
    return reply;
}

} // namespace gnomon::versus
