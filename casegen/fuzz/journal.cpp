#include "casegen/fuzz/journal.h"

#include "runtime/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gnomon::fuzz {
namespace {

constexpr std::string_view any_title = "gnomon fuzz journal ", title = "gnomon fuzz journal 2 ";

bool is_same_file(int descriptor, const std::filesystem::path& path) {
    using Status = struct stat;
    Status opened{}, there{};
    return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
           opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
}

/// The file, made if there is none, and locked for this process: children do not inherit that. Throws Error.
/// (The lock would end when another descriptor of the file is closed: all is done by this one.)
Journal::File open_locked(const std::filesystem::path& path) {
    for (;;) {
        Journal::File file;
        const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor >= 0) file.reset(::fdopen(descriptor, "r+"));
        if (!file) throw Error("{}: {}", path.string(), std::strerror(errno));
        using Lock = struct flock;
        Lock whole{};
        whole.l_type = F_WRLCK;
        whole.l_whence = SEEK_SET;
        if (::fcntl(descriptor, F_SETLK, &whole) != 0)
            throw Error(
                "{}: another gnomon fuzz is writing to it ({}); wait for its end, or name another file",
                path.string(), std::strerror(errno));
        if (is_same_file(descriptor, path)) return file; // else its owner has just ended, and removed it
    }
}

/// All of it, if it is a journal or empty. Throws Error.
std::string text_of_journal(std::FILE* file, const std::filesystem::path& path) {
    std::string text;
    std::array<char, 4096> bytes{};
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file))
        text.append(bytes.data(), count);
    if (std::ferror(file)) throw Error("{}: {}", path.string(), std::strerror(errno));
    if (!text.empty() && !text.starts_with(any_title))
        throw Error("{}: not a journal of gnomon fuzz; remove it, or name another file", path.string());
    return text;
}

} // namespace

Journal::Journal(const std::filesystem::path& path, const std::string& campaign)
    : path_(path), file_(open_locked(path)) {
    const std::string text = text_of_journal(file_.get(), path),
                      head = fmt::format("{}{}\n", title, campaign);
    if (!text.empty() && !text.starts_with(head))
        throw Error(
            "{}: the journal of another campaign (other kernels, inputs, options, or another build of "
            "gnomon); --restart begins anew, or name another file",
            path.string());
    std::size_t at = text.empty() ? 0 : head.size();
    for (std::size_t end = text.find('\n', at); end != text.npos; end = text.find('\n', at)) {
        const std::string_view line = std::string_view(text).substr(at, end - at);
        Line read;
        const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), read.unit);
        if (error != std::errc() || stop == line.data() + line.size() || *stop != ' ')
            throw Error("{}: damaged (\"{}\"); --restart begins anew", path.string(), line.substr(0, 40));
        read.text.assign(stop + 1, line.data() + line.size());
        lines_.push_back(std::move(read));
        at = end + 1;
    }
    // Without a line that was cut short.
    if (::ftruncate(fileno(file_.get()), static_cast<off_t>(at)) != 0 ||
        std::fseek(file_.get(), 0, SEEK_END) != 0)
        throw Error("{}: {}", path.string(), std::strerror(errno));
    if (at == 0) write(head);
}

void Journal::discard(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return;
    const File file = open_locked(path);
    text_of_journal(file.get(), path);
    std::filesystem::remove(path);
}

void Journal::write(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
        throw Error("{}: {}", path_.string(), std::strerror(errno));
}

void Journal::add(const Line& line) {
    if (file_) write(fmt::format("{} {}\n", line.unit, line.text));
}

void Journal::finish() {
    if (!file_) return;
    std::filesystem::remove(path_); // first: nobody else is to find it unlocked
    file_.reset();
}

} // namespace gnomon::fuzz
