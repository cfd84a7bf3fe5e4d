// Random numbers that are the same bits on every machine, compiler and number of threads.
#pragma once

#include <bit>
#include <cstdint>

namespace gnomon {

/// SplitMix64 (Steele, Lea, Flood 2014): a counter put through a mixing function, so that stream `index` of a
/// seed can be started anywhere.
class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
        : state_(mix(seed) ^ mix(stream * golden + 1)) {}

    std::uint64_t bits() { return mix(state_ += golden); }

    /// 0 … n-1, without bias: draws whose product's low half falls short would favour small numbers (Lemire
    /// 2019).
    std::uint32_t below(std::uint32_t n) {
        std::uint64_t product = (bits() >> 32) * n;
        if (static_cast<std::uint32_t>(product) < n) {
            const std::uint32_t threshold = (0u - n) % n;
            while (static_cast<std::uint32_t>(product) < threshold) product = (bits() >> 32) * n;
        }
        return static_cast<std::uint32_t>(product >> 32);
    }

    /// lower … upper, both included.
    int between(int lower, int upper) {
        return lower + static_cast<int>(below(static_cast<std::uint32_t>(upper - lower) + 1u));
    }

    /// A multiple of 2^-53 in [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

    bool chance(double probability) { return unit() < probability; }

private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ull;
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

} // namespace gnomon
