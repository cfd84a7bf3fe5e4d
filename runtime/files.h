// Files read whole and written whole: a reader never sees half of one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// The bytes of a file. Throws Error naming the file if it is missing, a folder, or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes beside `path` and renames over it, so that `path` holds either its old bytes or all the new ones.
/// What a symbolic link points to is replaced, not the link; a device or pipe (/dev/stdout, say) is written
/// to directly. Throws Error naming the file (missing folder, no permission, full disk); then nothing is left
/// behind.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws Error now if write_file(path, …) could not succeed later: before minutes of work, not after.
void require_writable(const std::filesystem::path& path);

/// A path or name as one word of a shell's command: in single quotes, whatever it holds.
std::string in_quotes(std::string_view text);

/// Where compiled kernels are kept between runs: $GNOMON_CACHE, else $XDG_CACHE_HOME/gnomon, else
/// ~/.cache/gnomon, else this user's folder in the system's temporary folder. Made if it is missing. Throws
/// Error if $GNOMON_CACHE is set but cannot be used, or if none of them can.
std::filesystem::path cache_directory();

/// FNV-1a, 64 bits: names to seeds and texts to cache keys. Not for adversaries.
constexpr std::uint64_t hash(std::string_view text, std::uint64_t state = 0xcbf29ce484222325ull) {
    for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return state;
}

} // namespace gnomon
