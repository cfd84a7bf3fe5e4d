#include "casegen/fuzz/journal.h"

#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>

namespace gnomon::fuzz {
namespace {

constexpr std::string_view title = "gnomon fuzz journal 1\n";

} // namespace

Journal::Journal(const std::filesystem::path& path) : path_(path) {
    std::string kept(title);
    if (std::filesystem::exists(path)) {
        const std::string text = read_file(path);
        if (!text.starts_with(title))
            throw Error("{}: not a journal of gnomon fuzz; remove it, or name another file", path.string());
        std::string_view rest = std::string_view(text).substr(title.size());
        for (std::size_t end = rest.find('\n'); end != rest.npos; end = rest.find('\n')) {
            const std::string_view line = rest.substr(0, end);
            Line read;
            const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), read.unit);
            if (error != std::errc() || stop == line.data() + line.size() || *stop != ' ')
                throw Error("{}: damaged (\"{}\"); remove it to begin anew", path.string(),
                            line.substr(0, 40));
            read.text.assign(stop + 1, line.data() + line.size());
            lines_.push_back(std::move(read));
            kept.append(line).push_back('\n');
            rest.remove_prefix(end + 1);
        }
    }
    write_file(path, kept); // without a line that was cut short
    file_.reset(std::fopen(path.c_str(), "a"));
    if (!file_) throw Error("{}: {}", path.string(), std::strerror(errno));
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
