// What the fuzzing targets share. Each is one file with a FUZZ_TARGET(name) { … } that reads `data` of `size`
// bytes: libFuzzer calls it with any bytes whatever, the test suite with the files of fixtures/corpus/name. A
// reader answers with a value or with an Error of one line; any other exception, a crash, a sanitizer's
// report, a hang or too much memory is a finding, and so is a false REQUIRE.
#pragma once

#include "runtime/error.h"
#include "runtime/files.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <unistd.h>

#define REQUIRE(condition)                                                                                   \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            std::fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition);                   \
            std::abort();                                                                                    \
        }                                                                                                    \
    } while (false)

#ifdef GNOMON_LIBFUZZER
#define FUZZ_TARGET(name) extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#else
#define FUZZ_TARGET(name)                                                                                    \
    static int read_as_##name(const std::uint8_t*, std::size_t);                                             \
    [[maybe_unused]] static const bool is_listed_##name =                                                    \
        gnomon::fuzzing::targets().emplace(#name, read_as_##name).second;                                    \
    static int read_as_##name(const std::uint8_t* data, std::size_t size)
#endif

namespace gnomon::fuzzing {

/// By name: those that are linked into this program.
inline std::map<std::string, int (*)(const std::uint8_t*, std::size_t)>& targets() {
    static std::map<std::string, int (*)(const std::uint8_t*, std::size_t)> all;
    return all;
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Whether `read` answers with a value. What it says otherwise must be on one line, as long as what it quotes
/// is.
template <typename Read>
bool is_read(Read&& read, bool on_one_line = true) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        const std::string_view message = error.what();
        REQUIRE(!message.empty());
        REQUIRE(!on_one_line || message.find('\n') == message.npos);
        return false;
    }
}

/// A file for readers that take a path; gone with the process.
class InputFile {
public:
    explicit InputFile(const std::string& name) {
        std::string pattern = (std::filesystem::temp_directory_path() / "gnomon-fuzz-XXXXXX").string();
        REQUIRE(mkdtemp(pattern.data()) != nullptr);
        folder_ = pattern;
        path_ = folder_ / name;
    }
    ~InputFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::filesystem::path& write(std::string_view bytes) const {
        std::FILE* file = std::fopen(path_.c_str(), "wb");
        REQUIRE(file != nullptr);
        REQUIRE(std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size());
        REQUIRE(std::fclose(file) == 0);
        return path_;
    }

private:
    std::filesystem::path folder_, path_;
};

} // namespace gnomon::fuzzing
