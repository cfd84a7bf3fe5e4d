#include "casegen/truths.h"

#include "casegen/truth_fingerprint.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <boost/version.hpp>
#include <fmt/format.h>
#include <mpfr.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace gnomon {
namespace {

static_assert(sizeof(Truth) == 9 * sizeof(double)); // no padding: its bytes are what it is
static_assert(std::is_trivially_copyable_v<Truth>);

const std::string& quantity_of(const Case& c) { return c.quantity.empty() ? c.name : c.quantity; }

Truth compute(const Case& c, std::span<const std::uint32_t> input) {
    return c.reference.truth(arguments(c, input, nullptr));
}

bool same_bits(const Truth& a, const Truth& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// --- What this process has computed
// -------------------------------------------------------------------------------

/// A record's words, as bytes.
std::string key_of(std::span<const std::uint32_t> input) {
    return {reinterpret_cast<const char*>(input.data()), input.size_bytes()};
}

struct Entry {
    Truth truth;
    bool done = false; ///< else a thread is at it
};
/// Of one quantity.
using Known = std::unordered_map<std::string, Entry>;

struct Memory {
    std::mutex mutex;
    std::condition_variable changed;
    std::map<std::string, Known> quantities;
    std::size_t count = 0;
};
Memory& memory() {
    static Memory all;
    return all;
}

/// Forgets what is done with once there is much of it. Under the lock.
void make_room(Memory& all) {
    constexpr std::size_t most = std::size_t{1} << 18; // 80 MB
    if (all.count < most) return;
    for (auto& [name, known] : all.quantities)
        all.count -= std::erase_if(known, [](const auto& entry) { return entry.second.done; });
}

/// The truths at the records that `wanted` names, each computed by one thread of the process only.
void compute_all(const Case& c, const Records& records, std::span<const std::size_t> wanted,
                 const std::function<void(std::size_t, const Truth&)>& put) {
    Memory& all = memory();
    Known* known = nullptr;
    {
        const std::scoped_lock lock(all.mutex);
        make_room(all);
        known = &all.quantities[quantity_of(c)]; // a map's nodes stay where they are
    }
    /// Returns whether the truth is there; if not, another thread has it in hand.
    const auto settle = [&](std::size_t i) {
        const std::string key = key_of(records.input(i));
        {
            const std::scoped_lock lock(all.mutex);
            const auto [entry, fresh] = known->try_emplace(key);
            if (entry->second.done) put(i, entry->second.truth);
            if (!fresh) return entry->second.done;
            ++all.count;
        }
        std::optional<Truth> truth;
        std::exception_ptr failure;
        try {
            truth = compute(c, records.input(i));
        } catch (...) {
            failure = std::current_exception();
        }
        {
            const std::scoped_lock lock(all.mutex);
            if (truth)
                known->find(key)->second = {*truth, true};
            else
                all.count -= known->erase(key); // whoever waits for it will try itself
        }
        all.changed.notify_all();
        if (failure) std::rethrow_exception(failure);
        put(i, *truth);
        return true;
    };
    std::vector<std::uint8_t> settled(wanted.size());
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) { settled[i] = settle(wanted[i]); });
    // No thread waits before all that it has taken on itself is done, so none waits for ever.
    for (std::size_t i = 0; i < wanted.size(); ++i)
        while (!settled[i]) {
            {
                const std::string key = key_of(records.input(wanted[i]));
                std::unique_lock lock(all.mutex);
                all.changed.wait(lock, [&] {
                    const auto found = known->find(key);
                    return found == known->end() || found->second.done;
                });
            }
            settled[i] = settle(wanted[i]);
        }
}

// --- Files
// --------------------------------------------------------------------------------------------------------

/// A chunk's truths: those that any kernel of the quantity has asked for so far.
struct Chunk {
    std::vector<Truth> truths;
    std::vector<std::uint8_t> known;
};

template <typename T>
void append(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string checksum(std::string_view bytes) { return fmt::format("{:016x}", hash(bytes)); }

class ChunkFile {
public:
    ChunkFile(const Case& c, const Records& records, std::size_t begin, std::size_t end,
              const TruthFiles& files)
        : about_(fmt::format("gnomon truths\n{}\n{}\n{} records of {} words\n", files.fingerprint,
                             quantity_of(c), end - begin, word_count(c))),
          size_(end - begin) {
        for (std::size_t i = begin; i < end; ++i) about_ += key_of(records.input(i));
        if (!files.folder.empty()) path_ = files.folder / fmt::format("{:016x}.truths", hash(about_));
    }

    /// Nothing known, if there is no such file or it is not to be trusted.
    Chunk load() const {
        Chunk none{std::vector<Truth>(size_), std::vector<std::uint8_t>(size_)};
        std::error_code error;
        if (path_.empty() || !std::filesystem::is_regular_file(path_, error)) return none;
        std::string bytes;
        try {
            bytes = read_file(path_);
        } catch (const Error&) {
            return none;
        }
        const std::size_t content = about_.size() + size_ * (sizeof(Truth) + 1);
        if (bytes.size() != content + checksum({}).size() || !bytes.starts_with(about_) ||
            !bytes.ends_with(checksum(std::string_view(bytes).substr(0, content))))
            return none;
        Chunk chunk = none;
        std::memcpy(chunk.known.data(), bytes.data() + about_.size(), size_);
        std::memcpy(chunk.truths.data(), bytes.data() + about_.size() + size_, size_ * sizeof(Truth));
        return chunk;
    }

    void store(const Chunk& chunk) const {
        if (path_.empty()) return;
        std::string bytes = about_;
        append(bytes, chunk.known);
        append(bytes, chunk.truths);
        bytes += checksum(bytes);
        try {
            std::filesystem::create_directories(path_.parent_path());
            write_file(path_, bytes);
        } catch (const std::exception&) { // NOLINT: the next process computes them again
        }
    }

private:
    std::string about_;
    std::size_t size_;
    std::filesystem::path path_;
};

/// Whether one of the chunk's truths, computed again, has the bits it had: the fingerprint does not know
/// which function a table names as a quantity's truth.
bool is_credible(const Case& c, const Records& records, std::size_t begin, const Chunk& chunk,
                 std::span<const std::size_t> wanted) {
    std::vector<std::size_t> known;
    for (const std::size_t i : wanted)
        if (chunk.known[i - begin]) known.push_back(i);
    if (known.empty()) return true;
    const std::size_t one = known[known.size() / 2]; // ends of ranges are special, and come first
    return same_bits(chunk.truths[one - begin], compute(c, records.input(one)));
}

} // namespace

TruthFiles default_truth_files() {
    static const std::string fingerprint = fmt::format("{} Boost {} MPFR {} {}", truth_sources,
                                                       BOOST_LIB_VERSION, mpfr_get_version(), __VERSION__);
    try {
        return {cache_directory() / "truths", fingerprint};
    } catch (const Error&) {
        return {{}, fingerprint};
    }
}

std::vector<Truth> truths(const Case& c, const Records& records, const TruthFiles& files) {
    if (!c.reference.truth) return {};
    std::vector<Truth> all(records.size());
    for (std::size_t begin = 0; begin < records.size(); begin += records_per_truth_file) {
        const std::size_t end = std::min(records.size(), begin + records_per_truth_file);
        std::vector<std::size_t> wanted, missing;
        for (std::size_t i = begin; i < end; ++i)
            if (in_domain(c, arguments(c, records.input(i), records.mask(i)))) wanted.push_back(i);
        if (c.reference.takes_mask) { // a mask is not among the words that truths are kept by
            for (const std::size_t i : wanted)
                all[i] = c.reference.truth(arguments(c, records.input(i), records.mask(i)));
            continue;
        }
        const ChunkFile file(c, records, begin, end, files);
        Chunk chunk = file.load();
        if (!is_credible(c, records, begin, chunk, wanted)) std::ranges::fill(chunk.known, std::uint8_t{0});
        for (const std::size_t i : wanted)
            if (!chunk.known[i - begin]) missing.push_back(i);
        compute_all(c, records, missing, [&](std::size_t i, const Truth& truth) {
            chunk.truths[i - begin] = truth;
            chunk.known[i - begin] = 1;
        });
        if (!missing.empty()) file.store(chunk);
        for (const std::size_t i : wanted) all[i] = chunk.truths[i - begin];
    }
    return all;
}

void forget_truths() {
    Memory& all = memory();
    const std::scoped_lock lock(all.mutex);
    for (auto& [name, known] : all.quantities)
        all.count -= std::erase_if(known, [](const auto& entry) { return entry.second.done; });
}

} // namespace gnomon
