// Truths are computed once, and never taken from a file that is not about them.
#include "casegen/truths.h"
#include "runtime/files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>

namespace gnomon {
namespace {

using testing::TemporaryFolder;

std::atomic<int> computed = 0;

Truth third_of(const Arguments& x) {
    ++computed;
    return {{x.numbers[0] / 3}, {std::abs(x.numbers[0]) * 0x1p-24}, 1};
}
Truth half_of(const Arguments& x) {
    ++computed;
    return {{x.numbers[0] / 2}, {std::abs(x.numbers[0]) * 0x1p-24}, 1};
}
Truth slow_third_of(const Arguments& x) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    return third_of(x);
}

Case make_case(const char* name, Truth (*truth)(const Arguments&)) {
    Case c;
    c.name = name;
    c.quantity = "test/third";
    c.reference = reference_by<double(double)>(truth);
    c.parameters = {{"x", {-100, 100, {}}, "1", "input"}};
    c.result = {-1000, 1000, "1", "output"};
    c.tolerance = conditioned(2);
    return c;
}

constexpr int in_domain_count = 1100, record_count = in_domain_count + 7; // three files, the last not full
Records make_records(const Case& c, float first = 0) {
    Records records(c);
    for (int i = 0; i < record_count; ++i) {
        const float x = i < in_domain_count ? first + 0.01f * static_cast<float>(i) : 1000.0f;
        const std::uint32_t word = std::bit_cast<std::uint32_t>(x);
        records.add({&word, 1}, nullptr);
    }
    return records;
}

const double fifth = static_cast<double>(0.01f * 5); // the record of that index

void expect_same_bits(const std::vector<Truth>& a, const std::vector<Truth>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Truth)), 0);
}

class TruthsInFiles : public ::testing::Test {
protected:
    TruthsInFiles() { forget_truths(); }

    /// The truths, and how many of them had to be computed.
    std::vector<Truth> get(const Case& kernel, const Records& of, const TruthFiles& in) {
        computed = 0;
        return truths(kernel, of, in);
    }
    std::vector<Truth> get() { return get(c, records, files); }
    /// As a new process would.
    std::vector<Truth> get_afresh() {
        forget_truths();
        return get();
    }
    std::vector<std::filesystem::path> paths() const {
        std::vector<std::filesystem::path> all;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            all.push_back(entry.path());
        std::ranges::sort(all);
        return all;
    }

    TemporaryFolder folder;
    TruthFiles files{folder.path(), "one"};
    Case c = make_case("test/third_by_name", third_of);
    Records records = make_records(c);
    static constexpr int checks = 3; ///< of a file that is believed one record is computed again
};

TEST_F(TruthsInFiles, are_those_of_the_reference_and_empty_outside_the_domain) {
    const std::vector<Truth> all = get();
    EXPECT_EQ(computed, in_domain_count);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(record_count));
    EXPECT_EQ(all[5].value[0], fifth / 3);
    EXPECT_EQ(all[in_domain_count].scale, 0);
    EXPECT_EQ(folder.entries(), 3u);
}

TEST_F(TruthsInFiles, are_the_same_bits_warm_and_cold) {
    const std::vector<Truth> cold = get();
    expect_same_bits(get(), cold);
    expect_same_bits(get_afresh(), cold);
    EXPECT_EQ(computed, checks);
}

TEST_F(TruthsInFiles, serve_every_kernel_of_the_quantity) {
    get();
    const Case other = make_case("test/third_by_another_name", third_of);
    get(other, records, files);
    EXPECT_EQ(computed, checks);
    Case narrower = other;
    narrower.where = [](const Arguments& x) { return x.numbers[0] > 5; };
    const std::vector<Truth> fewer = get(narrower, records, files);
    EXPECT_LE(computed, checks);
    EXPECT_EQ(fewer[5].scale, 0); // outside that kernel's domain
}

TEST_F(TruthsInFiles, grow_with_the_domains_that_ask_for_them) {
    Case narrower = c;
    narrower.where = [](const Arguments& x) { return x.numbers[0] > 5; };
    get(narrower, records, files);
    EXPECT_LT(computed, in_domain_count);
    const std::vector<Truth> all = get_afresh();
    EXPECT_LT(computed, in_domain_count);
    EXPECT_EQ(all[5].value[0], fifth / 3);
    get_afresh();
    EXPECT_EQ(computed, checks);
}

TEST_F(TruthsInFiles, are_not_taken_from_damaged_files) {
    const std::vector<Truth> cold = get();
    const auto all = paths();
    const std::string good = read_file(all[0]);
    const std::size_t places[] = {0, 20, good.size() / 2, good.size() - 30, good.size() - 1};
    for (const std::size_t place : places) {
        std::string bad = good;
        bad[place] = static_cast<char>(bad[place] ^ 1);
        write_file(all[0], bad);
        expect_same_bits(get_afresh(), cold);
        EXPECT_GT(computed, checks) << place;
        EXPECT_EQ(read_file(all[0]), good) << place; // replaced
    }
    for (const std::string& bad : {good.substr(0, good.size() / 2), std::string(), good + "x"}) {
        write_file(all[0], bad);
        expect_same_bits(get_afresh(), cold);
        EXPECT_GT(computed, checks);
    }
    write_file(all[0], read_file(all[1])); // another chunk's, whole
    expect_same_bits(get_afresh(), cold);
    EXPECT_GT(computed, checks);
    EXPECT_EQ(read_file(all[0]), good);
}

TEST_F(TruthsInFiles, are_not_taken_from_files_about_something_else) {
    get();
    TruthFiles later = files;
    later.fingerprint = "two"; // another reference
    forget_truths();
    get(c, records, later);
    EXPECT_EQ(computed, in_domain_count);

    Case other = c;
    other.quantity = "test/quarter";
    get(other, records, files);
    EXPECT_EQ(computed, in_domain_count);

    get(c, make_records(c, 0.005f), files);
    EXPECT_EQ(computed, in_domain_count);
}

TEST_F(TruthsInFiles, are_not_taken_from_files_of_another_function) {
    get();
    forget_truths();
    const Case changed = make_case("test/third_by_name", half_of); // a table that was edited
    const std::vector<Truth> all = get(changed, records, files);
    EXPECT_GE(computed, in_domain_count);
    EXPECT_EQ(all[5].value[0], fifth / 2);
}

TEST_F(TruthsInFiles, do_without_a_folder_that_cannot_be_written) {
    const std::vector<Truth> cold = get();
    const std::filesystem::path file = folder.write("file", "");
    for (const std::filesystem::path& unusable : {std::filesystem::path(), file, file / "below"}) {
        forget_truths();
        expect_same_bits(get(c, records, {unusable, "one"}), cold);
        EXPECT_EQ(computed, in_domain_count);
    }
}

TEST_F(TruthsInFiles, are_computed_once_by_kernels_that_are_checked_at_the_same_time) {
    const std::vector<Truth> cold = get();
    for (const std::filesystem::path& path : paths()) std::filesystem::remove(path);
    forget_truths();
    computed = 0;
    const Case slow = make_case("test/third_slowly", slow_third_of);
    std::vector<std::vector<Truth>> results(4);
    {
        std::vector<std::jthread> threads;
        for (std::vector<Truth>& result : results)
            threads.emplace_back(
                [&] { result = truths(slow, records, {}); }); // no files: what the process remembers
    }
    EXPECT_EQ(computed, in_domain_count);
    for (const std::vector<Truth>& result : results) expect_same_bits(result, cold);
}

} // namespace
} // namespace gnomon
