#include "casegen/census.h"

#include "casegen/standalone.h"
#include "runtime/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace gnomon {
namespace {

std::uint64_t count_of(const Counts& counts, unsigned number) {
    return number < counts.size() ? counts[number] : 0;
}

/// Of any case of the family.
double all_of(const Family& family, const Counts& counts) {
    std::uint64_t sum = 0;
    for (const Case* c : numbered_cases(family)) sum += count_of(counts, c->number);
    return static_cast<double>(sum);
}

} // namespace

Counts mask_census(gpu::Device& device, const glsl::Sources& sources, const Family& family,
                   const Mask& mask) {
    const Case* number = find_kernel(family, "number");
    if (!number) throw Error("{} has no kernel \"number\": nothing to count", family.name);
    gpu::Kernel kernel = device.kernel(compile_standalone(*number, sources), number->name);
    const int rows_at_once = std::max(1, (1 << 20) / mask.width);
    Counts counts(1);
    for (int first = 0; first < mask.height; first += rows_at_once) {
        Records records(*number);
        for (int y = first; y < std::min(first + rows_at_once, mask.height); ++y)
            for (int x = 0; x < mask.width; ++x) {
                const std::array texel{std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y)};
                records.add(texel, &mask);
            }
        const Outputs outputs = run_standalone(device, kernel, *number, records);
        if (const std::string complaint = outputs.complaint(); !complaint.empty())
            throw Error("{}: {}; gnomon check {} tells more", number->name, complaint, number->name);
        for (const std::uint32_t word : outputs.words) {
            if (word >= counts.size()) counts.resize(std::min<std::size_t>(word, 255) + 1);
            ++counts[std::min<std::size_t>(word, 255)];
        }
    }
    return counts;
}

std::vector<CaseShare> case_shares(const Family& family, std::span<const Counts> censuses) {
    std::vector<CaseShare> shares;
    for (const Case* c : numbered_cases(family)) {
        CaseShare share{.c = c};
        double all = 0, sum = 0, squares = 0, met = 0;
        for (const Counts& counts : censuses) {
            const double here = all_of(family, counts);
            if (here == 0) continue;
            share.count += count_of(counts, c->number);
            all += here;
            sum += static_cast<double>(count_of(counts, c->number)) / here;
            ++met;
        }
        if (met > 0) {
            share.share = static_cast<double>(share.count) / all;
            share.mean = sum / met;
        }
        for (const Counts& counts : censuses)
            if (const double here = all_of(family, counts); here > 0) {
                const double off = static_cast<double>(count_of(counts, c->number)) / here - share.mean;
                squares += off * off;
            }
        if (met > 1) share.deviation = std::sqrt(squares / (met - 1));
        shares.push_back(share);
    }
    return shares;
}

std::vector<unsigned> cases_by_frequency(const Family& family, const Counts& counts) {
    std::vector<unsigned> numbers;
    for (const Case* c : numbered_cases(family))
        if (count_of(counts, c->number) > 0) numbers.push_back(c->number);
    std::ranges::stable_sort(numbers, std::ranges::greater{},
                             [&](unsigned number) { return counts[number]; });
    if (numbers.empty()) numbers.push_back(0);
    return numbers;
}

glm::vec3 spread_direction(unsigned i) {
    // Points of the plane's R2 sequence (Roberts 2018) that fall into a disc, lifted onto the hemisphere
    // above it: products, remainders and one square root, which every machine rounds alike.
    constexpr double a = 0.7548776662466927, b = 0.5698402909980532, disc = 0.95;
    unsigned found = 0;
    for (unsigned n = 1;; ++n) {
        const double u = a * n, v = b * n;
        const double x = 2 * (u - std::floor(u)) - 1, z = 2 * (v - std::floor(v)) - 1;
        const double squared = x * x + z * z;
        if (squared > disc * disc) continue;
        if (found++ == i)
            return {static_cast<float>(x), -static_cast<float>(std::sqrt(1 - squared)),
                    static_cast<float>(z)};
    }
}

} // namespace gnomon
