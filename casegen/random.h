// Random numbers that are the same bits on every machine, compiler and number of threads.
#pragma once

#include <bit>
#include <cstdint>

namespace gnomon {

/// A number below 2^63: a signed one is converted by one instruction, an unsigned one by several.
inline double to_double(std::uint64_t n) { return static_cast<double>(static_cast<std::int64_t>(n)); }

/// SplitMix64 (Steele, Lea, Flood 2014): a counter put through a mixing function, so that stream `index` of a
/// seed can be started anywhere.
class Random {
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : Random(Streams(seed)[stream]) {}

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
    double unit() { return to_double(bits() >> 11) * 0x1p-53; }

    bool chance(double probability) { return unit() < probability; }

    /// The streams of a seed, for those who ask for very many: streams[index] is Random(seed, index).
    class Streams {
    public:
        explicit Streams(std::uint64_t seed) : mixed_seed_(mix(seed)) {}
        Random operator[](std::uint64_t index) const {
            Random random;
            random.state_ = mixed_seed_ ^ mix(index * golden + 1);
            return random;
        }

    private:
        std::uint64_t mixed_seed_;
    };

private:
    Random() = default;
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ull;
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_ = 0;
};

} // namespace gnomon
