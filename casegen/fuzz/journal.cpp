#include "casegen/fuzz/journal.h"

#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>

#include <fcntl.h>

namespace gnomon::fuzz {
namespace {

constexpr std::string_view title = "gnomon fuzz journal 2 ";

/// Of the whole file, for this process alone: children do not inherit it. It ends when any descriptor of the
/// file is closed.
bool lock(int descriptor) {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    return ::fcntl(descriptor, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN);
}

using File = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

/// Its text, behind the title. Throws Error if it is no journal, or somebody is writing to it.
std::string read_journal(const std::filesystem::path& path) {
    std::string text = read_file(path);
    if (!text.starts_with(title))
        throw Error("{}: not a journal of gnomon fuzz; remove it, or name another file", path.string());
    if (const File file(std::fopen(path.c_str(), "r+")); file && !lock(fileno(file.get())))
        throw Error("{}: another gnomon fuzz is writing to it; wait for its end, or name another file",
                    path.string());
    return text.substr(title.size());
}

} // namespace

Journal::Journal(const std::filesystem::path& path, const std::string& campaign) : path_(path) {
    std::string kept = fmt::format("{}{}\n", title, campaign);
    if (std::filesystem::exists(path)) {
        const std::string text = read_journal(path);
        std::string_view rest = text;
        if (!rest.starts_with(campaign + '\n'))
            throw Error("{}: the journal of another campaign, with other kernels, inputs or options; "
                        "--restart begins anew, or name another file",
                        path.string());
        rest.remove_prefix(campaign.size() + 1);
        for (std::size_t end = rest.find('\n'); end != rest.npos; end = rest.find('\n')) {
            const std::string_view line = rest.substr(0, end);
            Line read;
            const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), read.unit);
            if (error != std::errc() || stop == line.data() + line.size() || *stop != ' ')
                throw Error("{}: damaged (\"{}\"); --restart begins anew", path.string(), line.substr(0, 40));
            read.text.assign(stop + 1, line.data() + line.size());
            lines_.push_back(std::move(read));
            kept.append(line).push_back('\n');
            rest.remove_prefix(end + 1);
        }
    }
    write_file(path, kept); // without a line that was cut short
    file_.reset(std::fopen(path.c_str(), "a"));
    if (!file_) throw Error("{}: {}", path.string(), std::strerror(errno));
    lock(fileno(file_.get()));
}

void Journal::discard(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return;
    read_journal(path);
    std::filesystem::remove(path);
}

void Journal::add(const Line& line) {
    if (!file_) return;
    const std::string text = fmt::format("{} {}\n", line.unit, line.text);
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0)
        throw Error("{}: {}", path_.string(), std::strerror(errno));
}

void Journal::finish() {
    if (!file_) return;
    file_.reset();
    std::filesystem::remove(path_);
}

} // namespace gnomon::fuzz
